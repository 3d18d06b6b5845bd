#include "centre_line.h"

#include <cmath>

#include "normal_angle.h"

namespace weld_profiler
{
namespace
{
constexpr int kSlopeCells = 5;
constexpr std::size_t kLag = 6;  ///< columns between the centres of a difference: beyond kernel and speckle grain
constexpr std::size_t kBlock = 64;
constexpr std::size_t kLeastDifferences = 8;
constexpr double kMedianPerSigma = 0.6745;
const double kThirdDifference = std::sqrt(20.0);  ///< sigma of v[0] - 3 v[1] + 3 v[2] - v[3] in that of v

/// Row at which the line would cross the middle of the centre's own column.
double rowInCell(const Centre& centre)
{
  return centre.v - centre.slope * (centre.u - centre.cell);
}

double slopeAround(const std::vector<Centre>& centres, std::size_t middle)
{
  std::size_t first = middle;
  std::size_t last = middle;
  const Centre& here = centres[middle];
  while (first > 0 && !centres[first].starts_piece && here.cell - centres[first - 1].cell <= kSlopeCells)
    --first;
  while (last + 1 < centres.size() && !centres[last + 1].starts_piece &&
         centres[last + 1].cell - here.cell <= kSlopeCells)
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
}

void LineScatter::measure(const std::vector<Centre>& centres)
{
  excess_.assign(centres.size(), 0.0);
  for (std::size_t begin = 0; begin < centres.size(); begin += kBlock)
  {
    const std::size_t end = std::min(centres.size(), begin + kBlock);
    const std::size_t first = begin < kLag ? 0 : begin - kLag;
    differences_.clear();
    for (std::size_t i = first; i + 3 * kLag < std::min(centres.size(), end + 2 * kLag); ++i)
    {
      if (centres[i + 3 * kLag].cell - centres[i].cell != static_cast<int>(3 * kLag))
        continue;
      differences_.push_back(std::abs(rowInCell(centres[i]) - 3.0 * rowInCell(centres[i + kLag]) +
                                      3.0 * rowInCell(centres[i + 2 * kLag]) - rowInCell(centres[i + 3 * kLag])));
    }
    if (differences_.size() < kLeastDifferences)
      continue;
    const auto middle = differences_.begin() + static_cast<std::ptrdiff_t>(differences_.size() / 2);
    std::nth_element(differences_.begin(), middle, differences_.end());
    const double sigma = *middle / kMedianPerSigma / kThirdDifference;
    double read_variance = 0.0;
    for (std::size_t i = begin; i < end; ++i)
      read_variance += centres[i].read_sigma * centres[i].read_sigma / static_cast<double>(end - begin);
    const double excess = std::sqrt(std::max(0.0, sigma * sigma - read_variance));
    std::fill(excess_.begin() + static_cast<std::ptrdiff_t>(begin), excess_.begin() + static_cast<std::ptrdiff_t>(end),
              excess);
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
