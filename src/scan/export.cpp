#include "weld_profiler/scan/export.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>

#include <pcl/console/print.h>
#include <pcl/io/ply_io.h>

#include "pcd_file.h"
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

/// While it lives PCL prints nothing: what goes wrong is told once, by our exception.
class QuietPcl
{
public:
  QuietPcl() : level_(pcl::console::getVerbosityLevel()) { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
  ~QuietPcl() { pcl::console::setVerbosityLevel(level_); }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

private:
  pcl::console::VERBOSITY_LEVEL level_;
};

/// PCL reports a full disk by exception, by return value or not at all: what is on the disk decides.
/// @param marker  ends the file's header.
void requireData(const AtomicFile& file, const std::string& marker, std::uintmax_t data_bytes)
{
  std::ifstream stream(file.temporaryPath(), std::ios::binary);
  std::string head(4096, '\0');
  stream.read(&head[0], static_cast<std::streamsize>(head.size()));
  const std::size_t found = head.find(marker);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file.temporaryPath(), error);
  if (found == std::string::npos || error || size < found + marker.size() + data_bytes)
    throw file.failure("the file came out short, is the disk full?");
}

/// What PCL refuses to write: a cloud without a point.
std::string emptyPly()
{
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex 0\n";
  for (const CloudField& field : kCloudFields)
    text += std::string("property ") + (field.is_float ? "float " : "uchar ") + field.name + "\n";
  return text + "end_header\n";
}

void writePly(const Scan& scan, AtomicFile& file)
{
  const std::vector<CloudRecord> records = validRecords(scan);
  if (records.empty())
    return file.write(emptyPly());
  const pcl::PCLPointCloud2 cloud = pclCloud(records, records.size());
  if (pcl::PLYWriter().writeBinary(file.temporaryPath(), cloud) != 0)
    throw file.failure("PCL could not write it");
  requireData(file, "end_header\n", records.size() * (sizeof(CloudRecord) - sizeof(CloudRecord::padding)));
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

void saveScan(const Scan& scan, const std::string& path, const std::string& format)
{
  requireOneOf("format", format, scanFormats());
  if (scan.empty() || scan.cells == 0)
    throw InputError("cannot write " + path + ": the scan holds no row; scan first");
  AtomicFile file(path);
  const QuietPcl quiet;
  try
  {
    if (format == "pcd")
      writePcd(pclCloud(organisedRecords(scan), scan.cells), file);
    else if (format == "ply")
      writePly(scan, file);
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
