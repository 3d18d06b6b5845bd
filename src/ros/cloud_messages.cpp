#include <cstring>

#include <boost/make_shared.hpp>

#include "weld_profiler/ros/messages.h"
#include "weld_profiler/scan/cloud_record.h"

namespace weld_profiler
{
namespace
{
sensor_msgs::PointCloud2Ptr emptyCloud(const std::string& frame_id, Stamp stamp)
{
  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header.frame_id = frame_id;
  cloud->header.stamp = toRosTime(stamp);
  for (const CloudField& field : kCloudFields)
  {
    sensor_msgs::PointField description;
    description.name = field.name;
    description.offset = field.offset;
    description.datatype = field.is_float ? sensor_msgs::PointField::FLOAT32 : sensor_msgs::PointField::UINT8;
    description.count = 1;
    cloud->fields.push_back(description);
  }
  cloud->is_bigendian = false;
  cloud->point_step = sizeof(CloudRecord);
  return cloud;
}

void fill(sensor_msgs::PointCloud2& cloud, const std::vector<CloudRecord>& records)
{
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize(records.size() * sizeof(CloudRecord));
  if (!records.empty())
    std::memcpy(cloud.data.data(), records.data(), cloud.data.size());
}
}  // namespace

sensor_msgs::PointCloud2Ptr profileCloud(const Profile& profile, const std::string& frame_id)
{
  sensor_msgs::PointCloud2Ptr cloud = emptyCloud(frame_id, profile.stamp);
  cloud->header.seq = static_cast<std::uint32_t>(profile.frame);
  cloud->height = 1;
  cloud->width = static_cast<std::uint32_t>(profile.points.size());
  cloud->is_dense = true;
  std::vector<CloudRecord> records;
  records.reserve(profile.points.size());
  for (const CloudPoint& point : profile.points)
    records.push_back(cloudRecord(profile, point, profile.stamp));
  fill(*cloud, records);
  return cloud;
}

sensor_msgs::PointCloud2Ptr scanCloud(const Scan& scan)
{
  sensor_msgs::PointCloud2Ptr cloud = emptyCloud(scan.frame_id, scan.rows.empty() ? 0 : scan.rows.front().stamp);
  cloud->height = static_cast<std::uint32_t>(scan.rows.size());
  cloud->width = scan.cells;
  cloud->is_dense = false;
  fill(*cloud, organisedRecords(scan));
  return cloud;
}
}  // namespace weld_profiler
