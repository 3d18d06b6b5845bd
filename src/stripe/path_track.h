#pragma once

#include <vector>

#include "column_track.h"
#include "group_path.h"

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
  struct Node
  {
    float u = 0.0F, v = 0.0F, sigma = 0.0F, background = 0.0F, gradient = 0.0F, ambiguous = 0.0F;
    float span = 0.0F;  ///< between the flanks [px]
    bool starts_piece = false;
  };

  static Node measure(const GroupSums& sums, const PathNode& node);
  void takeSmear(std::size_t begin, std::size_t end);
  void evenOut(std::size_t begin, std::size_t end, float Node::*field);
  void smooth(std::size_t begin, std::size_t end, float Node::*field);
  void dropUnsureGradients(std::size_t begin, std::size_t end, float noise);
  void layPiece(std::size_t begin, std::size_t end, int columns, ColumnTrack& track) const;

  std::vector<Node> nodes_;
  std::vector<float> evened_;
};
}  // namespace weld_profiler
