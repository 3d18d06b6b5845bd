#include "weld_profiler/scan/labelled_scan.h"

#include <cstring>
#include <limits>

#include "pcd_file.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
template <class Value>
void requireSize(const char* thing, const std::vector<Value>& map, std::size_t points)
{
  if (!map.empty() && map.size() != points)
    throw PreconditionError(std::string(thing) + " have " + std::to_string(map.size()) + " values for " +
                            std::to_string(points) + " points of the scan, must be one each");
}
}  // namespace

std::vector<LabelledRecord> labelledRecords(const Scan& scan, const ScanLabels& labels)
{
  const std::vector<CloudRecord> points = organisedRecords(scan);
  requireSize("labels", labels.labels, points.size());
  requireSize("removals", labels.removal, points.size());
  std::vector<LabelledRecord> records(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    records[i] = LabelledRecord{ points[i], labels.labels.empty() ? 0U : labels.labels[i],
                                 labels.removal.empty() ? std::numeric_limits<float>::quiet_NaN() : labels.removal[i] };
  return records;
}

void saveLabelledScan(const Scan& scan, const ScanLabels& labels, const std::string& path,
                      const std::vector<std::string>& comments)
{
  const std::vector<LabelledRecord> records = labelledRecords(scan, labels);
  pcl::PCLPointCloud2 cloud = emptyPclCloud(scan.cells, scan.rows.size(), sizeof(LabelledRecord));
  addField(cloud, "label", offsetof(LabelledRecord, label), pcl::PCLPointField::UINT32);
  addField(cloud, "removal", offsetof(LabelledRecord, removal), pcl::PCLPointField::FLOAT32);
  if (!records.empty())
    std::memcpy(cloud.data.data(), records.data(), cloud.data.size());
  AtomicFile file(path);
  writePcd(cloud, file, comments);
  file.commit();
}
}  // namespace weld_profiler
