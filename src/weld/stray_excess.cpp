#include "stray_excess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kBeside = 1.5e-3;  // neighbours across the weld are taken from this far on either side [m]
constexpr int kNeighbours = 7;      // on either side
constexpr std::size_t kFewest = 7;  // of them
constexpr double kSigmas = 5.0;     // of what points depart from their neighbours
constexpr double kNothing = 1e-5;   // a smaller departure is none, whatever is tolerated [m]
constexpr float kLeast = 6e-5F;     // [m]
// tolerances, of 3 sigmas of a place: what departs by more is no ripple. A sine's crests and troughs reach a third of
// one; troughs twice as deep do not reach one, but metal piles up higher where a pass began or ended
constexpr float kNoCrest = 3.0F;
constexpr float kNoTrough = -2.0F;
constexpr std::size_t kSampled = 97;  // every so many points tell the scatter
constexpr double kAtToe = 4e-4;       // [m]
constexpr double kSeen = 0.75;        // of the face tells a pit as deep as is said
constexpr double kFoot = 0.4;         // of a tolerance: what departs by less is of no stray's foot

class ExcessFinder
{
public:
  ExcessFinder(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface,
               const std::vector<std::uint8_t>& without)
    : grid_(grid), sampler_(sampler), surface_(surface), without_(without)
  {
    of_face_.assign(grid.z.size(), 0);
    result_.height.assign(grid.z.size(), 0.0F);
    result_.tolerances.assign(grid.z.size(), 0.0F);
    result_.on_face.assign(grid.z.size(), 0);
    result_.at_toe = result_.on_face;
    result_.over_plate.assign(grid.z.size(), 1);
    result_.known.assign(grid.z.size(), 0);
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
    const float height = grid_.z[i];
    if (!std::isfinite(height))
      return;
    const auto z = static_cast<double>(height);
    const PathPlace place = sampler_.place(i);
    const std::size_t k = surface_.nearestSection(place.s);
    const SeamSurface::Under under = surface_.under(k, place.q);
    const double departure = surface_.departure(k, under, z);
    const bool known = std::isfinite(departure);
    const bool departs = known && !(std::abs(departure) < kNothing);
    const double tolerance = departs ? surface_.tolerance(k, place, under) : kNothing;
    // what is written last keeps what is read in registers
    if (under.zone == Zone::Weld)
    {
      result_.on_face[i] = 1;
      result_.over_plate[i] = static_cast<std::int8_t>(surface_.overPlate(k, place.q, z));
      result_.at_toe[i] = surface_.toToe(k, place.q) < kAtToe ? 1 : 0;
    }
    if (!known)
      return;
    result_.height[i] = static_cast<float>(departure);
    result_.known[i] = std::isfinite(tolerance) ? 1 : 0;
    if (departs)
      result_.tolerances[i] = static_cast<float>(departure / tolerance);
    const bool taken_out = (!without_.empty() && without_[i] != 0) || surface_.inHollow(k, under);
    of_face_[i] = under.zone == Zone::Weld && !taken_out && mayBeRipple(i) ? 1 : 0;
  }

  bool mayBeRipple(std::size_t i) const
  {
    return result_.tolerances[i] >= kNoTrough && result_.tolerances[i] <= kNoCrest;
  }

  bool onFace(std::size_t i) const { return result_.on_face[i] != 0; }

  /// The neighbours of a point in the same section, those that are strays themselves left out.
  struct Neighbours
  {
    std::array<double, 2 * kNeighbours> height;
    std::size_t count = 0;

    bool enough() const { return count >= kFewest; }

    double middle() const
    {
      std::array<double, 2 * kNeighbours> sorted = height;
      return medianInPlace(sorted.data(), sorted.data() + count);
    }

    /// Whether their median lies within `reach` of `at`, for certain.
    bool around(double at, double reach) const
    {
      std::size_t above = 0, below = 0;
      for (std::size_t n = 0; n < count; ++n)
      {
        above += height[n] > at - reach ? 1 : 0;
        below += height[n] < at + reach ? 1 : 0;
      }
      return 2 * above > count + 1 && 2 * below > count + 1;
    }
  };

  Neighbours neighbours(std::size_t i) const
  {
    const int row = static_cast<int>(i / static_cast<std::size_t>(grid_.cells));
    const int column = static_cast<int>(i % static_cast<std::size_t>(grid_.cells));
    const std::array<int, 2 * kNeighbours + 1>& rows_off = rows_off_[surface_.nearestSection(sampler_.place(i).s)];
    Neighbours found;
    int c = column - (kNeighbours + 1) * stride_;
    for (const int off : rows_off)
    {
      c += stride_;
      const int r = row + off;
      if (c == column || c < 0 || c >= grid_.cells || r < 0 || r >= grid_.rows || of_face_[grid_.at(r, c)] == 0)
        continue;
      found.height[found.count++] = static_cast<double>(result_.height[grid_.at(r, c)]);
    }
    return found;
  }

  void lookAcross()
  {
    rows_off_.resize(surface_.size());
    for (std::size_t k = 0; k < surface_.size(); ++k)
    {
      const double rows_per_column = std::tan(surface_.yaw(k)) * grid_.spacing / grid_.pitch;
      int columns = -kNeighbours * stride_;
      for (int& off : rows_off_[k])
      {
        off = static_cast<int>(std::lround(columns * rows_per_column));
        columns += stride_;
      }
    }
  }

  /// A place of the face, and whether it is held against its neighbours.
  struct Looked
  {
    std::size_t at;
    bool near;
  };

  /// What a pit's bottom may depart by without being told. @param tolerance  against neighbours.
  double unseenDepth(const std::vector<Looked>& looked, double tolerance) const
  {
    std::vector<double> depths;
    for (const Looked& one : looked)
    {
      const PathPlace place = sampler_.place(one.at);
      const std::size_t k = surface_.nearestSection(place.s);
      const double alone = surface_.tolerance(k, place, surface_.under(k, place.q));
      depths.push_back(one.near ? std::min(-static_cast<double>(kNoTrough) * alone,
                                           kClear * (tolerance + surface_.alongSlack(k, place)))
                                : kClear * alone);
    }
    if (depths.empty())
      return INFINITY;
    const auto at = depths.begin() + static_cast<std::ptrdiff_t>(kSeen * static_cast<double>(depths.size()));
    std::nth_element(depths.begin(), at, depths.end());
    return *at;
  }

  void holdAgainstNeighbours()
  {
    lookAcross();
    std::vector<double> sampled;
    std::vector<Looked> looked;
    for (std::size_t i = 0; i < grid_.z.size(); i += kSampled)
    {
      if (!onFace(i))
        continue;
      const Neighbours near = neighbours(i);
      looked.push_back({ i, near.enough() });
      if (near.enough())
        sampled.push_back(static_cast<double>(result_.height[i]) - near.middle());
    }
    const double scatter = robustSigma(std::move(sampled));
    if (!std::isfinite(scatter))
      return;
    const double tolerance = std::max(static_cast<double>(kLeast), kSigmas * scatter);
    result_.unseen_depth = unseenDepth(looked, tolerance);
    for (std::size_t i = 0; i < grid_.z.size(); ++i)
    {
      if (std::abs(result_.height[i]) < kLeast || !mayBeRipple(i) || !onFace(i))
        continue;
      const Neighbours near = neighbours(i);
      if (!near.enough())
        continue;
      const auto height = static_cast<double>(result_.height[i]);
      if (near.around(height, kFoot * tolerance))
      {
        result_.tolerances[i] = 0.0F;  // as its neighbours: their median need not be known
        continue;
      }
      const PathPlace place = sampler_.place(i);
      const double slack = surface_.alongSlack(surface_.nearestSection(place.s), place);
      result_.tolerances[i] = static_cast<float>((height - near.middle()) / (tolerance + slack));
    }
  }

  const ScanGrid& grid_;
  const SectionSampler& sampler_;
  const SeamSurface& surface_;
  const std::vector<std::uint8_t>& without_;
  std::vector<std::uint8_t> of_face_;  ///< points that tell what ripples do
  StrayExcess result_;
  int stride_ = 1;
  /// Of each section, by how many rows a neighbour across the weld lies off the point's own row.
  std::vector<std::array<int, 2 * kNeighbours + 1>> rows_off_;
};
}  // namespace

StrayExcess strayExcess(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface,
                        const std::vector<std::uint8_t>& without)
{
  return ExcessFinder(grid, sampler, surface, without)();
}
}  // namespace weld
}  // namespace weld_profiler
