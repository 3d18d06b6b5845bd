#pragma once

#include <string>

#include <sensor_msgs/PointCloud2.h>

#include "weld_profiler/WeldMeasurement.h"
#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/weld_evaluation.h"

namespace weld_profiler
{
// Where what was measured of a weld meets a message. Nothing here computes.

/// A scan from the message that scanCloud() made of it: rows in order, holes left out.
/// @throws PreconditionError when fields are missing or the data's length does not fit.
Scan scanFromCloud(const sensor_msgs::PointCloud2& cloud);

/// A profile from a cloud of height 1. Its points are numbered one after the other: the message names no cells.
/// @throws PreconditionError as scanFromCloud.
Profile profileFromCloud(const sensor_msgs::PointCloud2& cloud);

/// @param verdict  null = not judged.
WeldCrossSection sectionMessage(const WeldSection& section, const SectionVerdict* verdict);

/// All of an evaluation but header, id and what names settings and calibration.
WeldMeasurement measurementMessage(const WeldEvaluation& evaluation);

/// The organised scan with the fields `label` UINT32 and `removal` FLOAT32 behind those of scan_points.
sensor_msgs::PointCloud2Ptr weldCloud(const Scan& scan, const WeldResult& result);
}  // namespace weld_profiler
