#include <algorithm>
#include <cmath>
#include <limits>

#include "method.h"

namespace weld_profiler
{
namespace
{
constexpr double kReachSigmas = 3.0;   ///< of the filter, either side
constexpr double kNarrowest = 1.0;     ///< a narrower filter bends between two samples [px]
constexpr double kStep = 0.25;         ///< the filter's sigma is rounded: the same from frame to frame [px]
constexpr double kAstraySigmas = 1.0;  ///< from the centroid; a crossing farther off belongs to something else
/// Between two samples the output is -x + x^3 / (2 S^2), S^2 = filter's sigma^2 + stripe's sigma^2; the straight line
/// errs by p q (q - p) / (2 S^2) at a share p = 1 - q of the way, 0.0345 / S^2 as RMS over p.
constexpr double kStraightLine = 0.0345;

/// Taps of a smoothed derivative and what white noise becomes behind it.
struct Filter
{
  std::vector<double>& taps;  ///< from -reach to reach
  int reach = 0;
  double ramp = 0.0;       ///< output for a gray that rises by one level a row
  double power = 0.0;      ///< sum of squares: variance of the output for a noise of one
  double neighbour = 0.0;  ///< covariance of outputs a row apart

  Filter(double sigma, std::vector<double>& memory) : taps(memory)
  {
    reach = static_cast<int>(std::ceil(kReachSigmas * sigma));
    taps.resize(static_cast<std::size_t>(2 * reach) + 1);
    for (int k = -reach; k <= reach; ++k)
      tap(k) = k * std::exp(-0.5 * k * k / (sigma * sigma));
    for (int k = -reach; k <= reach; ++k)
    {
      ramp += k * tap(k);
      power += tap(k) * tap(k);
      neighbour += k < reach ? tap(k) * tap(k + 1) : 0.0;
    }
  }

  double& tap(int k) const { return taps.data()[reach + k]; }
};

/// Positive above a stripe's middle, where the gray rises down the column, negative below it.
template <class Pixel>
double slopeAt(const ImageView& image, const Filter& filter, const Centre& centre, int v)
{
  const Pixel* middle = image.row<Pixel>(v) + centre.cell;
  const auto stride = static_cast<std::ptrdiff_t>(image.step / sizeof(Pixel));
  double sum = 0.0;
  for (int k = 1; k <= filter.reach; ++k)
    sum += filter.tap(k) * (static_cast<double>(middle[k * stride]) - static_cast<double>(middle[-k * stride]));
  return sum - centre.gradient * filter.ramp;
}

struct Crossing
{
  bool found = false;
  double v = 0.0;
  double gain = 0.0;  ///< 1-sigma of v for a noise of one grey level in each pixel
};

/// The falling zero crossing nearest to the centroid, by a straight line between the samples on either side of it.
template <class Pixel>
Crossing crossingNear(const ImageView& image, const Filter& filter, const Centre& centre)
{
  Crossing crossing;
  const double farthest = kAstraySigmas * centre.sigma_column;
  const int first = std::max(filter.reach, static_cast<int>(std::floor(centre.v - farthest)));
  const int last = std::min(image.height - 1 - filter.reach, static_cast<int>(std::ceil(centre.v + farthest)));
  double nearest = farthest;
  double before = first <= last ? slopeAt<Pixel>(image, filter, centre, first) : 0.0;
  for (int v = first + 1; v <= last; ++v)
  {
    const double here = slopeAt<Pixel>(image, filter, centre, v);
    if (before > 0.0 && here <= 0.0)
    {
      const double share = before / (before - here);
      const double distance = std::abs(v - 1 + share - centre.v);
      if (distance <= nearest)
      {
        nearest = distance;
        crossing.found = true;
        crossing.v = v - 1 + share;
        const double variance = (share * share + (1.0 - share) * (1.0 - share)) * filter.power +
                                2.0 * share * (1.0 - share) * filter.neighbour;
        crossing.gain = std::sqrt(variance) / (before - here);
      }
    }
    before = here;
  }
  return crossing;
}

/// Zero crossing of a smoothed derivative, as profile cameras compute it in their sensor.
///
/// Source: J. Forest, J. Salvi, E. Cabruja, C. Pous, "Laser stripe peak detector for 3D scanners. A FIR filter
/// approach", ICPR 2004; the crossing by linear interpolation between two samples. One filter for the whole frame: the
/// derivative of a Gaussian as wide as the stripe (median over its columns, at least 1 px), which is the filter matched
/// to it. Good for: noise (at the bound of one column where the filter fits the stripe), clipped tops, any background.
/// Poor for: stripes that change their width along the frame, and narrow ones: the straight line between the samples is
/// off by 4 mpx at sigma 2, 17 at sigma 1 (RMS, part of the sigma told). Where the filter leaves the image or the
/// output crosses nowhere within the stripe, the centroid stays.
class FirPeak : public MethodBase
{
public:
  using MethodBase::MethodBase;

protected:
  void refine(const ImageView& image, Workspace::Scratch& scratch) const override
  {
    if (scratch.centres.empty())
      return;
    const double width = medianWidth(scratch);
    const Filter filter(width, scratch.column.gray);
    withPixel(image,
              [&](auto pixel)
              {
                for (Centre& centre : scratch.centres)
                {
                  const Crossing crossing = crossingNear<decltype(pixel)>(image, filter, centre);
                  if (!crossing.found)
                    continue;
                  centre.background += centre.gradient * (crossing.v - centre.v);
                  centre.v = crossing.v;
                  const double bent = kStraightLine / (width * width + centre.sigma_column * centre.sigma_column);
                  centre.read_sigma = std::hypot(scratch.finder.noise() * crossing.gain, bent);
                }
              });
  }

private:
  static double medianWidth(Workspace::Scratch& scratch)
  {
    scratch.widths.clear();
    for (const Centre& centre : scratch.centres)
      scratch.widths.push_back(centre.sigma_column);
    const auto middle = scratch.widths.begin() + static_cast<std::ptrdiff_t>(scratch.widths.size() / 2);
    std::nth_element(scratch.widths.begin(), middle, scratch.widths.end());
    return std::max(kNarrowest, kStep * std::round(*middle / kStep));
  }
};
}  // namespace

std::unique_ptr<const StripeExtractor> makeFirPeak(const StripeParams& params)
{
  return std::make_unique<FirPeak>(params);
}
}  // namespace weld_profiler
