#pragma once

#include <vector>

#include "column_track.h"
#include "group_path.h"
#include "group_profile.h"

namespace weld_profiler
{
/// Lays the line through the nodes of a path over the columns: where the stripe runs to a pixel or so, how wide it is
/// and on what background. A piece is laid a group farther than its last node on either side.
class PathTrack
{
public:
  /// @param noise  1-sigma of one pixel [grey levels].
  void lay(const GroupSums& sums, const std::vector<PathNode>& nodes, float noise, ColumnTrack& track);

private:
  void takeSmear(std::size_t begin, std::size_t end);
  void evenOut(std::size_t begin, std::size_t end, float GroupProfile::*field);
  void smooth(std::size_t begin, std::size_t end, float GroupProfile::*field);
  void dropUnsureGradients(std::size_t begin, std::size_t end, float noise);
  void layPiece(std::size_t begin, std::size_t end, int columns, ColumnTrack& track) const;

  std::vector<GroupProfile> nodes_;
  std::vector<float> evened_;
};
}  // namespace weld_profiler
