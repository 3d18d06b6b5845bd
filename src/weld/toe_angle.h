#pragma once

#include "section_sampler.h"
#include "toe_fit.h"

namespace weld_profiler
{
namespace weld
{
/// What a toe's angle is told from.
struct ToeAngleQuestion
{
  const SectionProfile& profile;
  const ToeFit& toe;
  Side side = Side::Left;
  Line parent;          ///< of that side
  double height = 0.0;  ///< of the weld above it [m]
  double blur = 0.0;    ///< nearer to the toe the profile is blurred [m]
};

/// Angle of the toe after ISO 5817 no. 505: pi less that between the parent line and the regression over the first
/// millimetre of the face, or a third of its height where that is shorter. Taken from the fitted face; beside an
/// evened out toe from the section's own points, for an arc does not follow ripples.
Quantity toeAngle(const ToeAngleQuestion& asked);
}  // namespace weld
}  // namespace weld_profiler
