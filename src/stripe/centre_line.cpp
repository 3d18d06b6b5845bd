#include "centre_line.h"

#include <algorithm>
#include <cmath>

#include "normal_angle.h"

namespace weld_profiler
{
namespace
{
constexpr int kSlopeCells = 5;
constexpr double kUncertain = 2.5;   ///< rows a column, 68 deg; beyond, a column looks along the stripe, not across it
constexpr double kBroken = 4.0;      ///< rows a column, 76 deg; no slope is taken across
constexpr int kAlone = 3;            ///< columns from one centre to the next of its piece, at most one more
constexpr std::size_t kCompany = 3;  ///< centres that make a line

/// Whether the line runs steeper than that from one centre to the next of its piece. [rows a column]
bool isSteeper(double limit, const Centre& a, const Centre& b)
{
  return std::abs(b.v - a.v) > limit * (b.cell - a.cell);
}

double slopeAround(const std::vector<Centre>& centres, std::size_t middle)
{
  std::size_t first = middle;
  std::size_t last = middle;
  const Centre& here = centres[middle];
  while (first > 0 && !centres[first].starts_piece && here.cell - centres[first - 1].cell <= kSlopeCells &&
         !isSteeper(kBroken, centres[first - 1], centres[first]))
    --first;
  while (last + 1 < centres.size() && !centres[last + 1].starts_piece &&
         centres[last + 1].cell - here.cell <= kSlopeCells && !isSteeper(kBroken, centres[last], centres[last + 1]))
    ++last;
  const auto count = static_cast<double>(last - first + 1);
  double u_mean = 0.0;
  double v_mean = 0.0;
  for (std::size_t i = first; i <= last; ++i)
  {
    u_mean += centres[i].u / count;
    v_mean += centres[i].v / count;
  }
  double uu = 0.0;
  double uv = 0.0;
  for (std::size_t i = first; i <= last; ++i)
  {
    uu += (centres[i].u - u_mean) * (centres[i].u - u_mean);
    uv += (centres[i].u - u_mean) * (centres[i].v - v_mean);
  }
  return uu > 0.0 ? uv / uu : 0.0;
}

float normalAngleOf(const Centre& centre)
{
  const bool own = centre.normal_u != 0.0 || centre.normal_v != 0.0;
  return normalAngle(own ? std::atan2(centre.normal_v, centre.normal_u) : std::atan2(1.0, -centre.slope));
}
}  // namespace

void measureSlopes(std::vector<Centre>& centres)
{
  for (std::size_t i = 0; i < centres.size(); ++i)
    centres[i].slope = slopeAround(centres, i);
  for (std::size_t i = 1; i < centres.size(); ++i)
    if (!centres[i].starts_piece && isSteeper(kUncertain, centres[i - 1], centres[i]))
      // ... and the columns beside, which see the end of the steep piece.
      for (std::size_t j = i - std::min<std::size_t>(i, 2); j <= std::min(i + 1, centres.size() - 1); ++j)
        centres[j].ambiguous = true;
}

void dropLoneCentres(std::vector<Centre>& centres)
{
  std::size_t kept = 0;
  for (std::size_t begin = 0, end = 0; begin < centres.size(); begin = end)
  {
    centres[begin].starts_piece = true;
    for (end = begin + 1;
         end < centres.size() && !centres[end].starts_piece && centres[end].cell - centres[end - 1].cell <= kAlone + 1;)
      ++end;
    if (end - begin < kCompany)
      continue;
    for (std::size_t i = begin; i < end; ++i)
      centres[kept++] = centres[i];
  }
  centres.resize(kept);
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
    point.sigma = static_cast<float>(cosine * std::hypot(centre.read_sigma, scatter[i]));
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
