#include "stray_excess.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kBeside = 1.5e-3;    // neighbours across the weld are taken from this far on either side [m]
constexpr int kNeighbours = 7;        // on either side
constexpr std::size_t kFewest = 7;    // of them
constexpr double kSigmas = 5.0;       // of what points depart from their neighbours
constexpr double kNothing = 1e-5;     // a smaller departure is none, whatever is tolerated [m]
constexpr float kLeast = 6e-5F;       // [m]
constexpr std::size_t kSampled = 97;  // every so many points tell the scatter

class ExcessFinder
{
public:
  ExcessFinder(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface)
    : grid_(grid), sampler_(sampler), surface_(surface)
  {
    result_.height.assign(grid.z.size(), 0.0F);
    result_.tolerances.assign(grid.z.size(), 0.0F);
    result_.on_face.assign(grid.z.size(), 0);
    stride_ = std::max(1, static_cast<int>(std::lround(kBeside / kNeighbours / grid.spacing)));
  }

  StrayExcess operator()()
  {
    for (std::size_t i = 0; i < grid_.z.size(); ++i)
      hold(i);
    if (grid_.pitch > 0.0)
      holdAgainstNeighbours();
    return std::move(result_);
  }

private:
  void hold(std::size_t i)
  {
    if (!std::isfinite(grid_.z[i]))
      return;
    const PathPlace& place = sampler_.place(i);
    const std::size_t k = surface_.nearestSection(place.s);
    const double departure = surface_.departure(k, place.q, static_cast<double>(grid_.z[i]));
    result_.on_face[i] = surface_.onFace(k, place.q) ? 1 : 0;
    if (!std::isfinite(departure))
      return;
    result_.height[i] = static_cast<float>(departure);
    if (std::abs(departure) < kNothing)
      return;
    result_.tolerances[i] = static_cast<float>(departure / surface_.tolerance(k, place));
  }

  bool onFace(std::size_t i) const { return result_.on_face[i] != 0; }

  /// Height above the median of the neighbours in the same section; NaN where there are few.
  double aboveNeighbours(std::size_t i) const
  {
    const int row = static_cast<int>(i / static_cast<std::size_t>(grid_.cells));
    const int column = static_cast<int>(i % static_cast<std::size_t>(grid_.cells));
    const double rows_per_column =
        std::tan(surface_.yaw(surface_.nearestSection(sampler_.place(i).s))) * grid_.spacing / grid_.pitch;
    std::vector<double> heights;
    heights.reserve(2 * kNeighbours);
    for (int n = -kNeighbours; n <= kNeighbours; ++n)
    {
      const int c = column + n * stride_;
      const int r = row + static_cast<int>(std::lround(n * stride_ * rows_per_column));
      if (n == 0 || c < 0 || c >= grid_.cells || r < 0 || r >= grid_.rows || !onFace(grid_.at(r, c)))
        continue;
      heights.push_back(static_cast<double>(result_.height[grid_.at(r, c)]));
    }
    return heights.size() < kFewest ? kNaN : static_cast<double>(result_.height[i]) - median(std::move(heights));
  }

  void holdAgainstNeighbours()
  {
    std::vector<double> sampled;
    for (std::size_t i = 0; i < grid_.z.size(); i += kSampled)
    {
      if (onFace(i))
        sampled.push_back(aboveNeighbours(i));
    }
    const double scatter = robustSigma(std::move(sampled));
    if (!std::isfinite(scatter))
      return;
    const double tolerance = std::max(static_cast<double>(kLeast), kSigmas * scatter);
    for (std::size_t i = 0; i < grid_.z.size(); ++i)
    {
      if (std::abs(result_.height[i]) < kLeast || !onFace(i))
        continue;
      const double above = aboveNeighbours(i);
      if (!std::isfinite(above))
        continue;
      const PathPlace place = sampler_.place(i);
      const double slack = surface_.alongSlack(surface_.nearestSection(place.s), place);
      result_.tolerances[i] = static_cast<float>(above / (tolerance + slack));
    }
  }

  const ScanGrid& grid_;
  const SectionSampler& sampler_;
  const SeamSurface& surface_;
  StrayExcess result_;
  int stride_ = 1;
};
}  // namespace

StrayExcess strayExcess(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface)
{
  return ExcessFinder(grid, sampler, surface)();
}
}  // namespace weld
}  // namespace weld_profiler
