#pragma once

#include <limits>
#include <string>

#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
/// What kind of weld a scan shows. None = no weld was recognised.
enum class WeldKind
{
  None,
  Butt,
  Fillet,
  BeadOnPlate
};

/// `none`, `butt`, `fillet`, `bead_on_plate`: as in parameters, messages and files.
const char* name(WeldKind kind);

/// What a section's heights are measured from.
enum class SectionReference
{
  Chord,        ///< the chord of the toes
  ParentLines,  ///< the extended parent lines (no two toes were found)
};

/// A point of a section in the cloud's frame, each coordinate with its uncertainty [m].
struct SectionPoint
{
  Quantity x, y, z;
};

/// The dimensions of one cross-section, perpendicular to the weld's path, after the definitions of weld.csv. SI:
/// metres, square metres, radians. What could not be measured is NaN. Left and right: seen along +y of the
/// cloud's frame, z up, and s and sections rise with y, whichever way the stage ran.
struct WeldSection
{
  int section = 0;     ///< index along the weld, from 0
  int row = 0;         ///< nearest row of the scan, from 0
  double stage = 0.0;  ///< stage position of that row [m]
  double s = 0.0;      ///< along the path, from the bead's end at the least y [m]
  double yaw = 0.0;    ///< of the path against the scan axis y, from +y toward -x [rad]
  /// 1-sigma of the yaw, which is in the other sigmas as well; NaN where it is not told by itself [rad]
  double yaw_sigma = std::numeric_limits<double>::quiet_NaN();
  SectionReference reference = SectionReference::Chord;

  Quantity width;          ///< chord of the toes
  Quantity reinforcement;  ///< largest distance of the face above the chord (of a fillet: its convexity)
  Quantity height_left;    ///< largest distance of the face above the left parent line
  Quantity height_right;
  SectionPoint toe_left;
  SectionPoint toe_right;
  Quantity toe_angle_left;  ///< pi = flush [rad]
  Quantity toe_angle_right;
  Quantity undercut_left;  ///< depth below the extended parent line, >= 0
  Quantity undercut_right;
  Quantity misalignment;     ///< ISO 6520-1 no. 507: offset of the parent lines at the seam, >= 0
  Quantity angle;            ///< no. 508: between the parent lines, > 0 = both rise outward [rad]
  Quantity area;             ///< between face and chord [m^2]
  Quantity incomplete_fill;  ///< no. 511: largest depth of the face below the chord, >= 0
  Quantity leg_left;         ///< fillet: from the root, where the parent lines meet, to the toe
  Quantity leg_right;
  Quantity throat;  ///< fillet: from the root to the chord, perpendicular

  bool hasBead() const { return width.measured(); }
};
}  // namespace weld_profiler
