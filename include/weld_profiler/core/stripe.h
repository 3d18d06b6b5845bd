#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace weld_profiler
{
/// Which way the stripe runs. Values as in StripeProfile.msg.
enum class Direction : std::uint8_t
{
  AlongU = 0,  ///< along the rows: one centre a column
  AlongV = 1   ///< along the columns: one centre a row
};

/// What a frame showed. Values as in StripeProfile.msg.
enum class StripeStatus : std::uint8_t
{
  Ok = 0,
  NoStripe = 1,
  TooBright = 2,
  TooDark = 3
};

/// Bits of Stripe::flags, as in StripeProfile.msg.
namespace stripe_flag
{
constexpr std::uint8_t kInterpolated = 1;  ///< filled across a gap, not measured
constexpr std::uint8_t kSaturated = 2;     ///< clipped pixels took part
constexpr std::uint8_t kAmbiguous = 4;     ///< a second candidate in this cell was nearly as good
}  // namespace stripe_flag

/// One centre of the stripe.
struct StripePoint
{
  std::uint16_t cell = 0;     ///< column (row for AlongV) the centre was found in
  float u = 0.0F;             ///< column [px], raw image, pixel centres at integers
  float v = 0.0F;             ///< row [px]
  float normal_angle = 0.0F;  ///< direction across the stripe, from +u toward +v [rad], in (-pi/2, pi/2]
  float intensity = 0.0F;     ///< peak above background [DN]
  float width = 0.0F;         ///< 1-sigma half width of the stripe across itself [px]
  float sigma = 0.0F;         ///< 1-sigma uncertainty of the centre across the stripe [px]
  std::uint8_t flags = 0;     ///< OR of stripe_flag
};

/// The sub-pixel centre line of one frame: arrays of equal length, at most one centre a cell, cells strictly rising.
/// Empty = no stripe in this frame. The arrays are those of StripeProfile.msg and are swapped into it.
struct Stripe
{
  Direction direction = Direction::AlongU;
  StripeStatus status = StripeStatus::NoStripe;
  std::vector<std::uint16_t> cell;
  std::vector<float> u, v, normal_angle, intensity, width, sigma;
  std::vector<std::uint8_t> flags;

  std::size_t size() const { return cell.size(); }
  bool empty() const { return cell.empty(); }

  void clear() { resize(0); }

  void resize(std::size_t count)
  {
    cell.resize(count);
    flags.resize(count);
    for (std::vector<float>* field : { &u, &v, &normal_angle, &intensity, &width, &sigma })
      field->resize(count);
  }

  void reserve(std::size_t count)
  {
    cell.reserve(count);
    flags.reserve(count);
    for (std::vector<float>* field : { &u, &v, &normal_angle, &intensity, &width, &sigma })
      field->reserve(count);
  }

  void push_back(const StripePoint& point)
  {
    resize(size() + 1);
    set(size() - 1, point);
  }

  void set(std::size_t i, const StripePoint& point)
  {
    cell[i] = point.cell;
    u[i] = point.u;
    v[i] = point.v;
    normal_angle[i] = point.normal_angle;
    intensity[i] = point.intensity;
    width[i] = point.width;
    sigma[i] = point.sigma;
    flags[i] = point.flags;
  }

  StripePoint operator[](std::size_t i) const
  {
    return StripePoint{ cell[i], u[i], v[i], normal_angle[i], intensity[i], width[i], sigma[i], flags[i] };
  }
};
}  // namespace weld_profiler
