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
constexpr std::size_t kEvenCells = 8;  ///< neighbours either side that width and background are averaged over
constexpr double kAstraySigmas = 2.0;  ///< from the seed; a centroid that went farther follows something else
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

/// Mean of one flank without its darkest and its brightest pixel.
template <class Pixel>
bool flankLevel(const ImageView& image, int u, int first, double& level)
{
  if (first < 0 || first + kFlankPixels > image.height)
    return false;
  double sum = 0.0;
  double least = image.row<Pixel>(first)[u];
  double most = least;
  for (int i = 0; i < kFlankPixels; ++i)
  {
    const double value = image.row<Pixel>(first + i)[u];
    sum += value;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  level = (sum - least - most) / (kFlankPixels - 2);
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
    centre.initial_v = seeds[i].v;
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
  if (std::abs(centre.v - centre.initial_v) > kAstraySigmas * centre.sigma_column)
    return false;
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

/// Running median along the stripe, not across a tear: a spatter beside the stripe spoils width and background of a few
/// columns and must not spoil those of their neighbours.
void ColumnCentroid::evenOut(std::vector<Centre>& centres, double Centre::*field)
{
  evened_.resize(centres.size());
  const auto enter = [&](double value)
  { window_.insert(std::upper_bound(window_.begin(), window_.end(), value), value); };
  for (std::size_t begin = 0, end = 0; begin < centres.size(); begin = end)
  {
    for (end = begin + 1; end < centres.size() && !centres[end].starts_piece;)
      ++end;
    window_.clear();
    for (std::size_t i = begin; i < std::min(end, begin + kEvenCells); ++i)
      enter(centres[i].*field);
    for (std::size_t i = begin; i < end; ++i)
    {
      if (i + kEvenCells < end)
        enter(centres[i + kEvenCells].*field);
      if (i > begin + kEvenCells)
        window_.erase(std::lower_bound(window_.begin(), window_.end(), centres[i - kEvenCells - 1].*field));
      evened_[i] = window_[window_.size() / 2];
    }
  }
  for (std::size_t i = 0; i < centres.size(); ++i)
    centres[i].*field = evened_[i];
}
}  // namespace weld_profiler
