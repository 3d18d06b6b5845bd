#include "weld_profiler/scan/cloud_record.h"

#include <limits>

namespace weld_profiler
{
namespace
{
Stamp firstStamp(const Scan& scan)
{
  return scan.empty() ? 0 : scan.rows.front().stamp;
}
}  // namespace

CloudRecord cloudRecord(const Profile& profile, const CloudPoint& point, Stamp origin)
{
  return CloudRecord{ point.x,
                      point.y,
                      point.z,
                      point.intensity,
                      point.sigma,
                      static_cast<float>(profile.stage),
                      static_cast<float>(toSeconds(profile.stamp - origin)),
                      point.flags,
                      { 0, 0, 0 } };
}

std::vector<CloudRecord> organisedRecords(const Scan& scan)
{
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const CloudPoint hole{ kNan, kNan, kNan, kNan, kNan, 0, 0 };
  std::vector<CloudRecord> records;
  records.reserve(scan.rows.size() * scan.cells);
  for (const Profile& row : scan.rows)
  {
    const std::size_t begin = records.size();
    records.resize(begin + scan.cells, cloudRecord(row, hole, firstStamp(scan)));
    for (const CloudPoint& point : row.points)
      if (point.cell < scan.cells)
        records[begin + point.cell] = cloudRecord(row, point, firstStamp(scan));
  }
  return records;
}

std::vector<CloudRecord> validRecords(const Scan& scan)
{
  std::vector<CloudRecord> records;
  for (const Profile& row : scan.rows)
    for (const CloudPoint& point : row.points)
      records.push_back(cloudRecord(row, point, firstStamp(scan)));
  return records;
}
}  // namespace weld_profiler
