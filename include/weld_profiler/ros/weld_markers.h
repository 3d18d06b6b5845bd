#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/weld_evaluation.h"

namespace weld_profiler
{
/// What rviz shows of a measured weld, in the cloud's frame: both toe lines and the crest, coloured by the sections'
/// verdicts, spots, and the weld's verdict as text. Each call deletes what the one before drew.
visualization_msgs::MarkerArray weldMarkers(const WeldEvaluation& evaluation, const std_msgs::Header& header);

/// One section with its dimensions drawn in: chord, height, both toe angles' lines, and their values as text.
visualization_msgs::MarkerArray sectionMarkers(const WeldSection& section, const std_msgs::Header& header);
}  // namespace weld_profiler
