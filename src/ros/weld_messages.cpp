#include "weld_profiler/ros/weld_messages.h"

#include <cmath>
#include <cstring>

#include <boost/make_shared.hpp>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/messages.h"
#include "weld_profiler/scan/labelled_scan.h"

namespace weld_profiler
{
namespace
{
constexpr double kNanoseconds = 1e9;

Measured measured(const Quantity& quantity)
{
  Measured message;
  message.value = quantity.value;
  message.sigma = quantity.sigma;
  return message;
}

geometry_msgs::Point point(const SectionPoint& place)
{
  geometry_msgs::Point message;
  message.x = place.x.value;
  message.y = place.y.value;
  message.z = place.z.value;
  return message;
}

/// The records of a cloud of ours, in place.
/// @throws PreconditionError when it is none.
const CloudRecord* records(const sensor_msgs::PointCloud2& cloud)
{
  const std::string thing = "cloud of " + std::to_string(cloud.width) + " x " + std::to_string(cloud.height);
  if (cloud.point_step != sizeof(CloudRecord) || cloud.is_bigendian)
    throw PreconditionError(thing + ": its points are no points of scan_points, give it those of `triangulation`");
  std::size_t known = 0;
  for (const CloudField& field : kCloudFields)
  {
    for (const sensor_msgs::PointField& described : cloud.fields)
      known += described.name == field.name && described.offset == field.offset ? 1 : 0;
  }
  if (known != sizeof(kCloudFields) / sizeof(kCloudFields[0]))
    throw PreconditionError(thing + ": lacks fields of scan_points, give it those of `triangulation`");
  const std::size_t points = static_cast<std::size_t>(cloud.width) * cloud.height;
  if (cloud.data.size() != points * sizeof(CloudRecord))
    throw PreconditionError(thing + ": has " + std::to_string(cloud.data.size()) + " bytes, must have " +
                            std::to_string(points * sizeof(CloudRecord)));
  return reinterpret_cast<const CloudRecord*>(cloud.data.data());
}

Profile rowOf(const CloudRecord* record, std::uint32_t cells, Stamp origin)
{
  Profile row;
  row.cells = cells;
  row.stage = cells > 0 ? static_cast<double>(record->stage) : 0.0;
  row.stamp = origin + (cells > 0 ? std::llround(kNanoseconds * static_cast<double>(record->time)) : 0);
  for (std::uint32_t cell = 0; cell < cells; ++cell, ++record)
  {
    if (!std::isfinite(record->x) || !std::isfinite(record->y) || !std::isfinite(record->z))
      continue;
    CloudPoint at;
    at.x = record->x, at.y = record->y, at.z = record->z;
    at.intensity = record->intensity;
    at.sigma = record->sigma;
    at.cell = static_cast<std::uint16_t>(cell);
    at.flags = record->flags;
    row.points.push_back(at);
  }
  return row;
}

WeldVerdictLine lineMessage(const VerdictRow& row)
{
  WeldVerdictLine line;
  line.imperfection = name(row.imperfection);
  line.level = name(row.level);
  line.value = measured(row.value);
  line.limit = measured(row.limit);
  line.margin = measured(row.margin);
  line.length = row.length;
  line.decision = name(row.decision);
  line.unverified = !row.verified;
  return line;
}
}  // namespace

Scan scanFromCloud(const sensor_msgs::PointCloud2& cloud)
{
  const CloudRecord* record = records(cloud);
  Scan scan;
  scan.frame_id = cloud.header.frame_id;
  scan.cells = cloud.width;
  scan.end = ScanEnd::Stopped;
  const Stamp origin = fromRosTime(cloud.header.stamp);
  for (std::uint32_t row = 0; row < cloud.height; ++row, record += cloud.width)
    scan.rows.push_back(rowOf(record, cloud.width, origin));
  return scan;
}

Profile profileFromCloud(const sensor_msgs::PointCloud2& cloud)
{
  const CloudRecord* record = records(cloud);
  Profile profile = rowOf(record, cloud.width * cloud.height, fromRosTime(cloud.header.stamp));
  profile.frame = cloud.header.seq;
  return profile;
}

WeldCrossSection sectionMessage(const WeldSection& section, const SectionVerdict* verdict)
{
  WeldCrossSection message;
  message.section = static_cast<std::uint32_t>(section.section);
  message.row = static_cast<std::uint32_t>(section.row);
  message.stage = section.stage;
  message.s = section.s;
  message.yaw = section.yaw;
  message.yaw_sigma = section.yaw_sigma;
  message.reference = section.reference == SectionReference::Chord ? "chord" : "parent_lines";
  message.toe_left = point(section.toe_left);
  message.toe_right = point(section.toe_right);
  message.width = measured(section.width);
  message.reinforcement = measured(section.reinforcement);
  message.height_left = measured(section.height_left);
  message.height_right = measured(section.height_right);
  message.toe_angle_left = measured(section.toe_angle_left);
  message.toe_angle_right = measured(section.toe_angle_right);
  message.undercut_left = measured(section.undercut_left);
  message.undercut_right = measured(section.undercut_right);
  message.misalignment = measured(section.misalignment);
  message.angle = measured(section.angle);
  message.area = measured(section.area);
  message.incomplete_fill = measured(section.incomplete_fill);
  message.leg_left = measured(section.leg_left);
  message.leg_right = measured(section.leg_right);
  message.throat = measured(section.throat);
  message.verdict = verdict != nullptr ? verdict->verdict : "";
  message.unverified = verdict != nullptr && verdict->unverified;
  return message;
}

WeldMeasurement measurementMessage(const WeldEvaluation& evaluation)
{
  const WeldResult& result = evaluation.result;
  WeldMeasurement message;
  message.type = WeldMeasurement::SUMMARY;
  message.kind = name(result.kind);
  message.kind_score = result.scores.empty() ? 0.0 : result.scores.front().score;
  message.reason = result.reason;
  for (std::size_t i = 0; i < result.sections.size(); ++i)
    message.sections.push_back(sectionMessage(
        result.sections[i], i < evaluation.section_verdicts.size() ? &evaluation.section_verdicts[i] : nullptr));
  message.measured_share = result.measured_share;
  message.length = measured(result.length);
  message.volume = measured(result.volume);
  message.removal_volume = measured(result.removal_volume);
  message.ripple_pitch = measured(result.ripple_pitch);
  message.ripple_height = measured(result.ripple_height);
  message.verdict = evaluation.verdict.verdict;
  message.unverified = evaluation.verdict.unverified;
  for (const VerdictRow& row : evaluation.verdict.rows)
    message.verdict_lines.push_back(lineMessage(row));
  message.lacks_thickness = evaluation.verdict.lacks_thickness;
  message.notes = evaluation.verdict.notes;
  return message;
}

sensor_msgs::PointCloud2Ptr weldCloud(const Scan& scan, const WeldResult& result)
{
  sensor_msgs::PointCloud2Ptr cloud = scanCloud(scan);
  const auto describe = [&](const char* field, std::uint32_t offset, std::uint8_t type)
  {
    sensor_msgs::PointField description;
    description.name = field;
    description.offset = offset;
    description.datatype = type;
    description.count = 1;
    cloud->fields.push_back(description);
  };
  describe("label", offsetof(LabelledRecord, label), sensor_msgs::PointField::UINT32);
  describe("removal", offsetof(LabelledRecord, removal), sensor_msgs::PointField::FLOAT32);
  const std::vector<LabelledRecord> organised = labelledRecords(scan, ScanLabels{ result.labels, result.removal });
  cloud->point_step = sizeof(LabelledRecord);
  cloud->row_step = cloud->width * cloud->point_step;
  cloud->data.resize(organised.size() * sizeof(LabelledRecord));
  if (!organised.empty())
    std::memcpy(cloud->data.data(), organised.data(), cloud->data.size());
  return cloud;
}
}  // namespace weld_profiler
