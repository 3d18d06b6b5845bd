#pragma once

#include <vector>

#include "parent_fit.h"
#include "plane_fit.h"

namespace weld_profiler
{
namespace weld
{
/// The plate that the parent lines of one side are cut from: a plane in the scan frame or, beside a curved weld, a
/// surface that follows its path, whichever the lines lie in better.
///
/// What is evened out and continued along the weld is the lines' height over it. The heights themselves go up and down
/// with the path's own errors where the plate is tilted.
class ParentPlate
{
public:
  /// A section's parent line.
  struct Piece
  {
    WeldPathPoint place;
    Line line;
  };

  /// @param pieces     of valid lines.
  /// @param near,far   two places across the weld that tell a line [m].
  ParentPlate(const std::vector<Piece>& pieces, double near, double far);

  /// The line that the section at a place of the path cuts out of it.
  Line lineAt(const WeldPathPoint& place) const;

  /// Of the lines about it, robustly [m].
  double scatter() const { return plane_.scatter; }

private:
  bool follows_path_ = false;
  Plane plane_;  ///< over x and y; of one that follows the path over q and s
};
}  // namespace weld
}  // namespace weld_profiler
