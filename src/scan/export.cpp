#include "weld_profiler/scan/export.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>

#include "pcd_file.h"
#include "quiet_pcl.h"
#include "weld_profiler/core/atomic_file.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/scan/cloud_record.h"
#include "weld_profiler/scan/csv.h"

namespace weld_profiler
{
namespace
{
pcl::PCLPointCloud2 pclCloud(const std::vector<CloudRecord>& records, std::size_t width)
{
  pcl::PCLPointCloud2 cloud = emptyPclCloud(width, records.size() / width, sizeof(CloudRecord));
  std::memcpy(cloud.data.data(), records.data(), cloud.data.size());
  return cloud;
}

/// Written here, not by PCL: its writer knows no comments, and reports a full disk by exception, by return value or not
/// at all.
void writePly(const Scan& scan, const AtomicFile& file, const std::vector<std::string>& comments)
{
  const std::vector<CloudRecord> records = validRecords(scan);
  std::string head = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : comments)
    head += "comment " + comment + "\n";
  head += "element vertex " + std::to_string(records.size()) + "\n";
  for (const CloudField& field : kCloudFields)
    head += std::string("property ") + (field.is_float ? "float " : "uchar ") + field.name + "\n";
  head += "end_header\n";
  errno = 0;
  std::ofstream out(file.temporaryPath(), std::ios::binary | std::ios::trunc);
  out.write(head.data(), static_cast<std::streamsize>(head.size()));
  constexpr std::streamsize kBytes = sizeof(CloudRecord) - sizeof(CloudRecord::padding);
  for (const CloudRecord& record : records)
    out.write(reinterpret_cast<const char*>(&record), kBytes);
  out.close();
  if (!out)
    throw file.failure(errno != 0 ? std::strerror(errno) : "write failed, is the disk full?");
}

void writeCsvFile(const Scan& scan, const AtomicFile& file)
{
  errno = 0;
  std::ofstream out(file.temporaryPath(), std::ios::binary | std::ios::trunc);
  writeCsv(scan, out);
  out.close();
  if (!out)
    throw file.failure(errno != 0 ? std::strerror(errno) : "write failed, is the disk full?");
}
}  // namespace

std::vector<std::string> scanFormats()
{
  return { "pcd", "ply", "csv" };
}

void saveScan(const Scan& scan, const std::string& path, const std::string& format,
              const std::vector<std::string>& comments)
{
  requireOneOf("format", format, scanFormats());
  for (const std::string& comment : comments)
    if (comment.find_first_of("\r\n") != std::string::npos)
      throw PreconditionError("a comment of " + path + " has a line break, must be one line");
  if (scan.empty() || scan.cells == 0)
    throw InputError("cannot write " + path + ": the scan holds no row; scan first");
  AtomicFile file(path);
  const QuietPcl quiet;
  try
  {
    if (format == "pcd")
      writePcd(pclCloud(organisedRecords(scan), scan.cells), file, comments);
    else if (format == "ply")
      writePly(scan, file, comments);
    else
      writeCsvFile(scan, file);
  }
  catch (const Error&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw file.failure(error.what());
  }
  file.commit();
}
}  // namespace weld_profiler
