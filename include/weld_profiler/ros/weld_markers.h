#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "weld_profiler/core/profile.h"
#include "weld_profiler/weld/weld_evaluation.h"

namespace weld_profiler
{
/// What rviz shows of a measured weld, in the cloud's frame: both toe lines, coloured by the sections' verdicts and
/// broken where no toe was measured, spots, and kind and verdict of the weld as text over its middle. Each call deletes
/// what the one before drew.
visualization_msgs::MarkerArray weldMarkers(const WeldEvaluation& evaluation, const std_msgs::Header& header);

/// One section drawn over the place where it was measured, upright and enlarged so that it can be read: the profile,
/// the width, the height, the toes, and their values; of a fillet the throat. Only the deletion of what was drawn
/// before where the section has no bead.
/// @param row  of the scan that the section is nearest to: what is drawn of the surface.
visualization_msgs::MarkerArray sectionMarkers(const WeldSection& section, const Profile& row,
                                               const std_msgs::Header& header);

/// Of a weld, the measured section that is nearest to the middle of its length; null = none.
const WeldSection* middleSection(const WeldResult& result);
}  // namespace weld_profiler
