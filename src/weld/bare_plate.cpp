#include "bare_plate.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
// a hollow in a face that touches the plate and stays within flatness of it for so long is as round as a plate: 2 mm
// and more of radius
constexpr double kShortest = 1e-3;  // of a piece [m]

/// Follows the outline from a plate's end outward.
class PlateWalk
{
public:
  PlateWalk(const RowOutline& outline, const PlateLine& plate, const WeldParams& params)
    : outline_(outline),
      plate_(plate),
      params_(params),
      near_(std::max(params.flatness, 2.0 * outline.noise())),
      high_(std::max({ params.min_height, outline.seen(), near_ }))
  {
  }

  std::vector<StraightRun> operator()() const
  {
    std::vector<StraightRun> pieces;
    int last = plate_.from;  // of the plate before what rises
    for (int i = plate_.from; inRow(i); i += plate_.side)
    {
      if (!isNear(i))
        continue;
      const int begin = i;
      while (inRow(i + plate_.side) && isNear(i + plate_.side))
        i += plate_.side;
      const bool passed = reach(last, begin) >= params_.min_width;
      const bool bare = reach(begin, i) + spacing() > kShortest && rises(last, begin) && goesOnRising(i + plate_.side);
      if (passed && bare)
        pieces.push_back(piece(begin, i));
      if (!passed || bare)
        last = i;
    }
    return pieces;
  }

private:
  bool inRow(int i) const { return i >= 0 && i < outline_.size(); }
  double above(int i) const { return plate_.line.above(outline_.node(i).x, outline_.node(i).z); }
  bool isNear(int i) const { return std::abs(above(i)) <= near_; }
  double reach(int from, int to) const { return std::abs(outline_.node(to).x - outline_.node(from).x); }
  double spacing() const { return reach(0, outline_.size() - 1) / std::max(1, outline_.size() - 1); }

  /// Something stands between two nodes.
  bool rises(int from, int to) const
  {
    double top = 0.0;
    for (int i = from; i != to; i += plate_.side)
      top = std::max(top, above(i));
    return top > high_;
  }

  /// Beyond a piece something wider than spatter stands.
  bool goesOnRising(int from) const
  {
    int i = from;
    double top = 0.0;
    for (; inRow(i) && reach(from, i) < params_.min_width; i += plate_.side)
    {
      if (!(above(i) > near_))
        return false;
      top = std::max(top, above(i));
    }
    return inRow(i) && top > high_;
  }

  StraightRun piece(int from, int to) const
  {
    const int first = std::min(from, to), end = std::max(from, to) + 1;
    std::vector<double> off;
    for (int i = first; i < end; ++i)
      off.push_back(above(i));
    StraightRun run{ first, end, outline_.node(first).x, outline_.node(end - 1).x, plate_.line, true };
    run.line.height += medianInPlace(off) / std::cos(run.line.angle());
    return run;
  }

  const RowOutline& outline_;
  const PlateLine& plate_;
  const WeldParams& params_;
  double near_, high_;  ///< off the line: the plate; something that stands on it [m]
};
}  // namespace

std::vector<StraightRun> barePlate(const RowOutline& outline, const PlateLine& plate, const WeldParams& params)
{
  return PlateWalk(outline, plate, params)();
}
}  // namespace weld
}  // namespace weld_profiler
