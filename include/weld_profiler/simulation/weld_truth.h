#pragma once

#include <array>

namespace weld_profiler
{
/// True dimensions of one cross-section of the bead, perpendicular to the weld's path, after the definitions of
/// weld.csv. Points in the cloud's frame. Spatter and blocks do not count.
struct WeldTruth
{
  int row = 0;                 ///< frame whose sheet crosses the path here
  double stage = 0.0;          ///< stage position of that frame [m]
  double s = 0.0;              ///< along the path from the weld's first end [m]
  double yaw = 0.0;            ///< of the path against y, from +y toward -x [rad]
  double width = 0.0;          ///< chord of the toes [m]
  double reinforcement = 0.0;  ///< largest distance of the face above the chord [m]
  double height_left = 0.0;    ///< the same above the left parent line [m]
  double height_right = 0.0;
  std::array<double, 3> toe_left{};  ///< [m]
  std::array<double, 3> toe_right{};
  double toe_angle_left = 0.0;  ///< pi = flush; regression over the face's first 1 mm or third of height [rad]
  double toe_angle_right = 0.0;
  double undercut_left = 0.0;  ///< depth below the extended parent line [m]
  double undercut_right = 0.0;
  double misalignment = 0.0;  ///< offset of the parent lines at the seam [m], >= 0
  double area = 0.0;          ///< between face and chord [m^2]
};
}  // namespace weld_profiler
