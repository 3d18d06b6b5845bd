#include "spots.h"

#include <algorithm>
#include <cmath>

#include "bead_ends.h"
#include "pit_chance.h"
#include "pit_rim.h"
#include "stray_excess.h"
#include "unseen_pores.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kFewest = 6;    // points of a spot
constexpr double kWidest = 4e-3;      // [m]
constexpr double kRim = 1.3e-4;       // around a stray the surface is blurred with it [m]
constexpr double kOfTolerance = 0.5;  // the foot of a stray reaches down to this share of the tolerance
// of a pore's rim must be seen on the face: what is open to a side may as well be the gap between two balls of spatter,
// the toe's kink, or the edge of what is hidden; a pore of 1 mm that begins at a toe has 0.8 of its rim on the face
constexpr double kRimSeen = 0.8;
// of its diameter: laser and camera look into a hole at 27 deg to each other or more, and see its walls further down
constexpr double kDeepest = 2.0;

// of the diameter of a pit that is not seen whole: it may be twice as wide, and as well be none
constexpr double kUnseen = 0.5;

class StraySearch
{
public:
  StraySearch(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface, StrayExcess found)
    : grid_(grid),
      sampler_(sampler),
      found_(std::move(found)),
      excess_(found_.tolerances),
      ends_(grid, sampler, surface, found_)
  {
  }

  /// @param without  points known to be strays; empty = none.
  Strays operator()(const std::vector<std::uint8_t>& without)
  {
    Strays strays;
    strays.kind.assign(grid_.z.size(), Stray::None);
    strays.masked.assign(grid_.z.size(), 0);
    seen_.assign(grid_.z.size(), 0);
    for (std::size_t i = 0; i < grid_.z.size(); ++i)
    {
      if (seen_[i] == 0 && std::abs(excess_[i]) > 1.0F)
        takeSpot(i, strays);
    }
    judgePits(strays);
    strays.unseen = unseenPores(grid_, found_.unseen_depth);
    keep(without, strays);
    for (std::vector<WeldSpot>* spots : { &strays.spots, &strays.hollows })
      std::sort(spots->begin(), spots->end(), [](const WeldSpot& a, const WeldSpot& b) { return a.s < b.s; });
    return strays;
  }

private:
  /// Points that hang together with `start`, on the same side of the surface.
  std::vector<std::size_t> connected(std::size_t start)
  {
    const bool above = excess_[start] > 0.0F;
    std::vector<std::size_t> spot{ start };
    seen_[start] = 1;
    for (std::size_t next = 0; next < spot.size(); ++next)
    {
      const int row = static_cast<int>(spot[next] / static_cast<std::size_t>(grid_.cells));
      const int column = static_cast<int>(spot[next] % static_cast<std::size_t>(grid_.cells));
      for (int r = std::max(0, row - 1); r <= std::min(grid_.rows - 1, row + 1); ++r)
      {
        for (int c = std::max(0, column - 2); c <= std::min(grid_.cells - 1, column + 2); ++c)
        {
          const std::size_t i = grid_.at(r, c);
          if (seen_[i] != 0 || std::abs(excess_[i]) < kOfTolerance || (excess_[i] > 0.0F) != above)
            continue;
          seen_[i] = 1;
          spot.push_back(i);
        }
      }
    }
    return spot;
  }

  /// A spot with the extent of its points.
  struct Found
  {
    WeldSpot spot;
    double top = 0.0;      ///< tolerances
    double extent = 0.0;   ///< the larger of those along x and y [m]
    double hidden = 0.0;   ///< by which it may be wider than seen [m]
    bool on_face = false;  ///< its top
    bool on_plate = false;
    std::vector<std::size_t> points;
  };

  Found describe(std::vector<std::size_t> points) const
  {
    Found found;
    WeldSpot& spot = found.spot;
    double least_x = INFINITY, most_x = -INFINITY, least_y = INFINITY, most_y = -INFINITY;
    for (const std::size_t i : points)
    {
      const double x = static_cast<double>(grid_.x[i]), y = static_cast<double>(grid_.y[i]);
      least_x = std::min(least_x, x), most_x = std::max(most_x, x);
      least_y = std::min(least_y, y), most_y = std::max(most_y, y);
      if (std::abs(excess_[i]) < found.top)
        continue;
      found.top = std::abs(static_cast<double>(excess_[i]));
      spot.x = x, spot.y = y, spot.z = static_cast<double>(grid_.z[i]);
      spot.s = sampler_.place(i).s;
      found.on_face = found_.on_face[i] != 0;
      found.on_plate = found_.over_plate[i] == 0;
      spot.height = Quantity{ static_cast<double>(found_.height[i]), static_cast<double>(grid_.sigma[i]) };
    }
    found.extent = std::max(most_x - least_x, most_y - least_y);
    // its side of what is around it: ripples may lift or lower both
    spot.kind = excess_[points.front()] > 0.0F ? WeldSpot::Kind::Spatter : WeldSpot::Kind::Pore;
    const double cell = grid_.spacing * (std::isfinite(grid_.pitch) ? grid_.pitch : grid_.spacing);
    const double diameter = std::sqrt(4.0 / kPi * cell * static_cast<double>(points.size()));
    // the walls of a pore are steep, or round: if they are a paraboloid's, what lies above the foot is wider by so much
    if (spot.kind == WeldSpot::Kind::Pore && found.top > kClear)
      found.hidden = diameter * (1.0 / std::sqrt(1.0 - kOfTolerance / found.top) - 1.0);
    spot.diameter = Quantity{ diameter, std::hypot(0.5 * std::hypot(grid_.spacing, grid_.pitch), found.hidden) };
    found.points = std::move(points);
    return found;
  }

  /// Where a bead is narrower than beside, what lies lower than its face there is the plate, from the toe on.
  bool isWaist(const Found& found) const
  {
    const auto plate_at_toe = [this](std::size_t i) { return found_.over_plate[i] == 0 && found_.at_toe[i] != 0; };
    return found.spot.kind == WeldSpot::Kind::Pore && found.on_plate &&
           std::any_of(found.points.begin(), found.points.end(), plate_at_toe);
  }

  /// Likewise where its flank lies farther inward: open to a toe, and nowhere deeper than the plate.
  bool isFlank(const Found& found) const
  {
    const std::vector<std::size_t>& points = found.points;
    return std::any_of(points.begin(), points.end(), [this](std::size_t i) { return found_.at_toe[i] != 0; }) &&
           std::none_of(points.begin(), points.end(), [this](std::size_t i) { return found_.over_plate[i] < 0; });
  }

  void takeSpot(std::size_t start, Strays& strays)
  {
    Found found = describe(connected(start));
    const bool pit = found.spot.kind == WeldSpot::Kind::Pore;
    if (pit && found.on_face)
      chance_.look(found.points);
    if (found.points.size() < kFewest || found.top < kClear || isWaist(found))
      return;
    // what lies below a plate is no pore of the weld
    const bool foreign = (pit && !found.on_face) || found.extent > kWidest;
    const Stray kind = foreign ? Stray::Foreign : pit ? Stray::Pore : Stray::Spatter;
    if (kind == Stray::Spatter && ends_.make(found.points, kClear))
      return;
    const double rim = kRim + (kind == Stray::Pore ? found.hidden : 0.0);
    for (const std::size_t i : found.points)
    {
      strays.kind[i] = kind;
      maskAround(grid_, i, rim, strays.masked);
    }
    if (kind == Stray::Spatter)
    {
      strays.spots.push_back(found.spot);
      strays.widest_ball = std::max(strays.widest_ball, found.spot.diameter.value);
    }
    else if (kind == Stray::Pore)
    {
      strays.widest_pit = std::max(strays.widest_pit, found.spot.diameter.value);
      pits_.push_back(std::move(found));
    }
    else if (pit && found.on_face)
      addHollow(found, strays);
  }

  void addHollow(const Found& pit, Strays& strays) const
  {
    if (isFlank(pit) || ends_.make(pit.points, kClear))
      return;
    WeldSpot spot = pit.spot;
    spot.diameter.sigma = std::hypot(spot.diameter.sigma, kUnseen * spot.diameter.value);
    strays.hollows.push_back(spot);
  }

  /// Which pits are pores; when all strays are known.
  void judgePits(Strays& strays) const
  {
    if (pits_.empty())
      return;
    std::vector<std::uint8_t> face = found_.on_face, ball(face.size(), 0);
    for (std::size_t i = 0; i < face.size(); ++i)
      if (strays.kind[i] == Stray::Spatter)
        maskAround(grid_, i, kRim, ball);
    for (std::size_t i = 0; i < face.size(); ++i)
      face[i] = face[i] != 0 && strays.kind[i] == Stray::None && ball[i] == 0 ? 1 : 0;
    for (const Found& pit : pits_)
    {
      const bool shallow = -pit.spot.height.value < kDeepest * pit.spot.diameter.value;
      const bool seen = hiddenBeside(grid_, pit.points) <= pit.points.size();
      if (shallow && seen && !chance_.mayMake(pit.points) && !ends_.reachedBy(pit.points) &&
          faceAround(grid_, pit.points, face) >= kRimSeen)
        strays.spots.push_back(pit.spot);
      else
      {
        addHollow(pit, strays);
        for (const std::size_t i : pit.points)
          strays.kind[i] = Stray::Foreign;
      }
    }
  }

  /// Strays of an earlier look stay what is to be left out, where without them nothing tells what the surface does: no
  /// median, or a bead whose toes they hide.
  void keep(const std::vector<std::uint8_t>& without, Strays& strays) const
  {
    for (std::size_t i = 0; i < without.size(); ++i)
    {
      if (without[i] == 0 || found_.on_face[i] == 0 || found_.known[i] != 0)
        continue;
      strays.kind[i] = Stray::Foreign;
      strays.masked[i] = 1;
    }
  }

  const ScanGrid& grid_;
  const SectionSampler& sampler_;
  const StrayExcess found_;
  const std::vector<float>& excess_;  ///< departure over tolerance
  const BeadEnds ends_;
  PitChance chance_{ grid_, kFewest };
  std::vector<Found> pits_;
  std::vector<std::uint8_t> seen_;
};
}  // namespace

Strays findStrays(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface,
                  const std::vector<std::uint8_t>& without)
{
  return StraySearch(grid, sampler, surface, strayExcess(grid, sampler, surface, without))(without);
}
}  // namespace weld
}  // namespace weld_profiler
