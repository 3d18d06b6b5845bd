#pragma once

#include "face_arc.h"
#include "parent_fit.h"

namespace weld_profiler
{
namespace weld
{
/// A toe: where the weld face, continued from where the profile is not blurred by the kink, meets the parent line.
struct ToeFit
{
  bool found = false;
  bool bridged = false;     ///< not seen itself: told from the toes on both sides along the weld, the face is not known
  bool evened = false;      ///< told from a face evened out along the weld; `face` is the section's own
  double q = 0.0, z = 0.0;  ///< [m]
  double sigma = 0.0;       ///< along the parent line, of chance [m]
  double bias = 0.0;        ///< what neighbouring sections err alike: blur of the kink [m]
  double flank = 0.0;       ///< angle between face and parent at the toe [rad]
  FaceArc face;             ///< in the coordinates (inward, z), inward = -sign(side) q
  double energy = 0.0;      ///< variance of a face point times the number of neighbours that share its error [m^2]
};

/// What the kink's blur leaves in the face beside a toe, square to it [m].
double faceBias(double flank);

/// What a toe is looked for in.
struct ToeQuestion
{
  Side side = Side::Left;
  double guess = 0.0;     ///< q of this toe, to a millimetre
  double opposite = 0.0;  ///< q of the other toe, likewise
};

/// Not found where the parent is missing, the face does not rise above it, or too little of the face was measured.
ToeFit fitToe(const SectionProfile& profile, const ToeQuestion& question, const ParentFit& parent,
              const WeldParams& params);
}  // namespace weld
}  // namespace weld_profiler
