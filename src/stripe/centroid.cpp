#include "centroid.h"

#include <cmath>

namespace weld_profiler
{
namespace
{
constexpr double kWindowSigmas = 3.0;  ///< half a window; beyond, a Gaussian's square is noise only
constexpr double kLeastSigmas = 1.2;   ///< of the stripe that must lie inside the image on either side
constexpr double kFlankSigmas = 4.0;   ///< where the background begins
constexpr int kFlankPixels = 6;
constexpr int kEvenCells = 8;  ///< neighbours either side that width and background are averaged over
constexpr int kIterations = 4;
constexpr double kSettled = 2e-4;  ///< [px]
const double kSqrtPi = std::sqrt(std::acos(-1.0));

struct Sums
{
  double weight = 0.0;  ///< sum of the weights
  double moment = 0.0;  ///< about the window's middle
  double second = 0.0;
  double energy = 0.0;  ///< sum of squared gray
  double noise = 0.0;   ///< sum of the squared derivatives of the moment by each pixel's gray
  bool saturated = false;
};

template <class Pixel>
Sums sumWindow(const ImageView& image, const Centre& centre, double half, bool squared, double saturation)
{
  Sums sums;
  const int first = std::max(0, static_cast<int>(std::ceil(centre.v - half - 0.5)));
  const int last = std::min(image.height - 1, static_cast<int>(std::floor(centre.v + half + 0.5)));
  const Pixel* pixel = image.row<Pixel>(first) + centre.cell;
  const std::size_t stride = image.step / sizeof(Pixel);
  for (int v = first; v <= last; ++v, pixel += stride)
  {
    const double y = v - centre.v;
    const double inside = std::min(1.0, half + 0.5 - std::abs(y));
    const double gray = *pixel - centre.background - centre.gradient * y;
    const double energy = inside * gray * gray;
    const double weight = squared ? energy : inside * gray;
    const double change = squared ? 2.0 * inside * gray * y : inside * y;
    sums.weight += weight;
    sums.moment += weight * y;
    sums.second += weight * y * y;
    sums.energy += energy;
    sums.noise += change * change;
    sums.saturated = sums.saturated || *pixel >= saturation;
  }
  return sums;
}

/// Mean of the middle pixels of one flank: a spark or a neighbouring stripe's edge in it does not count.
template <class Pixel>
bool flankLevel(const ImageView& image, int u, int first, double& level)
{
  if (first < 0 || first + kFlankPixels > image.height)
    return false;
  double values[kFlankPixels];
  for (int i = 0; i < kFlankPixels; ++i)
    values[i] = image.row<Pixel>(first + i)[u];
  std::sort(values, values + kFlankPixels);
  level = 0.5 * (values[kFlankPixels / 2 - 1] + values[kFlankPixels / 2]);
  return true;
}
}  // namespace

void ColumnCentroid::measure(const ImageView& image, const Levels& levels, const FrameStatistics& statistics,
                             CentroidWeight weight, const std::vector<Seed>& seeds, std::vector<Centre>& centres)
{
  centres.resize(seeds.size());
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    Centre centre;
    centre.cell = seeds[i].u;
    centre.u = seeds[i].u;
    centre.v = seeds[i].v;
    centre.sigma_column = std::max(0.6, static_cast<double>(seeds[i].sigma));
    centre.starts_piece = seeds[i].starts_piece;
    centre.ambiguous = seeds[i].ambiguous;
    centres[i] = centre;
  }
  evenOut(centres, &Centre::sigma_column);
  withPixel(image,
            [&](auto pixel)
            {
              using Pixel = decltype(pixel);
              measureBackground<Pixel>(image, statistics.background, centres);
              // First with the width the candidate seemed to have, then with the one that was measured.
              for (int pass = 0; pass < 2; ++pass)
              {
                std::size_t kept = 0;
                bool torn = false;
                for (Centre& centre : centres)
                {
                  torn = torn || centre.starts_piece;
                  if (!measureOne<Pixel>(image, levels, statistics.noise, weight, centre))
                    continue;
                  centre.starts_piece = torn;
                  torn = false;
                  centres[kept++] = centre;
                }
                centres.resize(kept);
                if (pass == 0)
                  evenOut(centres, &Centre::sigma_column);
              }
            });
}

template <class Pixel>
void ColumnCentroid::measureBackground(const ImageView& image, double fallback, std::vector<Centre>& centres)
{
  for (Centre& centre : centres)
  {
    const int reach = static_cast<int>(std::ceil(kFlankSigmas * centre.sigma_column));
    const int middle = static_cast<int>(std::lround(centre.v));
    double above = 0.0;
    double below = 0.0;
    const bool has_above = flankLevel<Pixel>(image, centre.cell, middle - reach - kFlankPixels + 1, above);
    const bool has_below = flankLevel<Pixel>(image, centre.cell, middle + reach, below);
    centre.gradient = 0.0;
    if (has_above && has_below)
    {
      centre.background = 0.5 * (above + below);
      centre.gradient = (below - above) / (2 * reach + kFlankPixels - 1);
    }
    else
      centre.background = has_above ? above : (has_below ? below : fallback);
  }
  evenOut(centres, &Centre::background);
  evenOut(centres, &Centre::gradient);
}

template <class Pixel>
bool ColumnCentroid::measureOne(const ImageView& image, const Levels& levels, double noise, CentroidWeight weight,
                                Centre& centre)
{
  const bool squared = weight == CentroidWeight::SquaredGray;
  Sums sums;
  for (int i = 0; i < kIterations; ++i)
  {
    // The window stays symmetric where the image ends, or the centre would be drawn inward.
    const double room = std::min(centre.v, image.height - 1 - centre.v) + 0.5;
    const double half = std::min(kWindowSigmas * centre.sigma_column, room - 0.5);
    if (!(half >= kLeastSigmas * centre.sigma_column))
      return false;
    sums = sumWindow<Pixel>(image, centre, half, squared, levels.saturation);
    if (!(sums.weight > 0.0))
      return false;
    const double shift = sums.moment / sums.weight;
    centre.v += shift;
    centre.background += centre.gradient * shift;
    if (std::abs(shift) < kSettled)
      break;
  }
  // A squared Gaussian is narrower by sqrt(2).
  const double variance = (squared ? 2.0 : 1.0) * sums.second / sums.weight;
  if (!(variance > 0.0))
    return false;
  centre.sigma_column = std::sqrt(variance);
  centre.amplitude =
      std::min(std::sqrt(sums.energy / (centre.sigma_column * kSqrtPi)), levels.saturation - centre.background);
  centre.read_sigma = noise * std::sqrt(sums.noise) / sums.weight;
  centre.saturated = sums.saturated;
  return true;
}

/// Running mean along the stripe, not across a tear.
void ColumnCentroid::evenOut(std::vector<Centre>& centres, double Centre::*field)
{
  for (std::size_t begin = 0; begin < centres.size();)
  {
    std::size_t end = begin + 1;
    while (end < centres.size() && !centres[end].starts_piece)
      ++end;
    sums_.assign(1, 0.0);
    for (std::size_t i = begin; i < end; ++i)
      sums_.push_back(sums_.back() + centres[i].*field);
    const std::size_t count = end - begin;
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t reach = std::min<std::size_t>(kEvenCells, std::min(i, count - 1 - i));
      centres[begin + i].*field = (sums_[i + reach + 1] - sums_[i - reach]) / static_cast<double>(2 * reach + 1);
    }
    begin = end;
  }
}
}  // namespace weld_profiler
