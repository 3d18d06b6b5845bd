#pragma once

#include <array>
#include <limits>
#include <string>

namespace weld_profiler
{
/// True dimensions of one cross-section of the bead, perpendicular to the weld's path, after the definitions of
/// weld.csv. Points in the cloud's frame. Spatter and blocks do not count.
struct WeldTruth
{
  std::string kind = "butt";   ///< as in SceneWeld
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
  double misalignment = 0.0;     ///< offset of the parent lines at the seam, >= 0; NaN of a fillet [m]
  double angle = 0.0;            ///< between the parent lines, > 0 = both rise outward [rad]
  double area = 0.0;             ///< between face and chord, where the face is lower it counts negative [m^2]
  double incomplete_fill = 0.0;  ///< largest depth of the face below the chord, >= 0 [m]

  // of a fillet, else NaN
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double leg_left = kNone;  ///< from the root, where the parent lines meet, to the toe [m]
  double leg_right = kNone;
  double throat = kNone;     ///< from the root to the chord, perpendicular [m]
  double convexity = kNone;  ///< of the face where it is farthest off the chord, < 0 = concave [m]
};

/// What a point of the surface belongs to; the numbers are those of `label` in weld_points.
enum class TrueLabel
{
  Unknown = 0,  ///< a block
  Base = 1,
  Bead = 2,      ///< the second bead and pores included
  Undercut = 3,  ///< more than 20 um below the plate, beside a toe
  Spatter = 4
};

/// A ball of spatter or a pore, in the cloud's frame [m].
struct TrueSpot
{
  enum class Kind
  {
    Pore,
    Spatter
  };
  Kind kind = Kind::Spatter;
  std::array<double, 3> position{};  ///< the surface at its middle: a ball's top, a pore's bottom
  double s = 0.0;                    ///< along the path
  double diameter = 0.0;             ///< seen from above
  double height = 0.0;               ///< off the surface around, perpendicular to it, < 0 = below
};

/// Ripples along the crest [m]; both 0 without.
struct TrueRipples
{
  double pitch = 0.0;
  double height = 0.0;  ///< crest to trough
};
}  // namespace weld_profiler
