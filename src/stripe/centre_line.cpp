#include "centre_line.h"

#include <algorithm>
#include <cmath>

#include "normal_angle.h"

namespace weld_profiler
{
namespace
{
constexpr int kSlopeCells = 5;
constexpr double kBroken = 4.0;  ///< rows a column, 76 deg; no slope is taken across

bool isBroken(const Centre& a, const Centre& b)
{
  return std::abs(b.v - a.v) > kBroken * (b.cell - a.cell);
}

/// Sums over the centres of a window that slides along a piece, columns and rows counted from the piece's first.
struct SlidingLine
{
  double count = 0.0, u = 0.0, v = 0.0, uu = 0.0, uv = 0.0;

  void add(double x, double y, double sign)
  {
    count += sign;
    u += sign * x;
    v += sign * y;
    uu += sign * x * x;
    uv += sign * x * y;
  }

  double slope() const
  {
    const double spread = count * uu - u * u;
    return spread > 0.0 ? (count * uv - u * v) / spread : 0.0;
  }
};

void measureSlopes(std::vector<Centre>& centres, std::size_t begin, std::size_t end)
{
  const Centre& origin = centres[begin];
  SlidingLine line;
  const auto add = [&](std::size_t i, double sign)
  { line.add(centres[i].cell - origin.cell, centres[i].v - origin.v, sign); };
  std::size_t first = begin;
  std::size_t next = begin;
  for (std::size_t i = begin; i < end; ++i)
  {
    for (; next < end && centres[next].cell - centres[i].cell <= kSlopeCells; ++next)
      add(next, 1.0);
    for (; centres[i].cell - centres[first].cell > kSlopeCells; ++first)
      add(first, -1.0);
    centres[i].slope = line.slope();
  }
}

float normalAngleOf(const Centre& centre)
{
  const bool own = centre.normal_u != 0.0 || centre.normal_v != 0.0;
  return normalAngle(own ? std::atan2(centre.normal_v, centre.normal_u) : std::atan2(1.0, -centre.slope));
}
}  // namespace

void measureSlopes(std::vector<Centre>& centres)
{
  for (std::size_t begin = 0, end = 0; begin < centres.size(); begin = end)
  {
    for (end = begin + 1;
         end < centres.size() && !centres[end].starts_piece && !isBroken(centres[end - 1], centres[end]);)
      ++end;
    measureSlopes(centres, begin, end);
  }
}

void writeStripe(const std::vector<Centre>& centres, const LineScatter& scatter, const StripeParams& params,
                 const Levels& levels, Stripe& stripe)
{
  stripe.resize(centres.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < centres.size(); ++i)
  {
    const Centre& centre = centres[i];
    const double cosine = 1.0 / std::sqrt(1.0 + centre.slope * centre.slope);
    StripePoint point;
    point.cell = static_cast<std::uint16_t>(centre.cell);
    point.u = static_cast<float>(centre.u);
    point.v = static_cast<float>(centre.v);
    point.normal_angle = normalAngleOf(centre);
    point.intensity = static_cast<float>(centre.amplitude);
    point.width = static_cast<float>(centre.sigma_column * cosine);
    const double variance = centre.read_sigma * centre.read_sigma + scatter[i] * scatter[i];
    point.sigma = static_cast<float>(cosine * std::sqrt(variance));
    point.flags = static_cast<std::uint8_t>((centre.saturated ? stripe_flag::kSaturated : 0) |
                                            (centre.ambiguous ? stripe_flag::kAmbiguous : 0));
    const bool bright = point.intensity >= params.min_peak_counts * levels.count;
    const bool wide = point.width >= params.min_stripe_width_px && point.width <= params.max_stripe_width_px;
    if (bright && wide)
      stripe.set(kept++, point);
  }
  stripe.resize(kept);
}
}  // namespace weld_profiler
