#include "pcd_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <pcl/io/pcd_io.h>

namespace weld_profiler
{
pcl::PCLPointCloud2 emptyPclCloud(std::size_t width, std::size_t rows, std::size_t point_step)
{
  pcl::PCLPointCloud2 cloud;
  cloud.width = static_cast<std::uint32_t>(width);
  cloud.height = static_cast<std::uint32_t>(rows);
  cloud.point_step = static_cast<std::uint32_t>(point_step);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = 0;
  for (const CloudField& field : kCloudFields)
    addField(cloud, field.name, field.offset, field.is_float ? pcl::PCLPointField::FLOAT32 : pcl::PCLPointField::UINT8);
  cloud.data.resize(width * rows * point_step);
  return cloud;
}

void addField(pcl::PCLPointCloud2& cloud, const char* name, std::uint32_t offset, std::uint8_t type)
{
  pcl::PCLPointField description;
  description.name = name;
  description.offset = offset;
  description.datatype = type;
  description.count = 1;
  cloud.fields.push_back(description);
}

void writePcd(const pcl::PCLPointCloud2& cloud, const AtomicFile& file, const std::vector<std::string>& comments)
{
  std::string header =
      pcl::PCDWriter().generateHeaderBinary(cloud, Eigen::Vector4f::Zero(), Eigen::Quaternionf::Identity()) +
      "DATA binary\n";
  std::string remarks;
  for (const std::string& comment : comments)
    remarks += "# " + comment + "\n";
  header.insert(header.find('\n') + 1, remarks);  // behind the line that names the format
  errno = 0;
  std::ofstream out(file.temporaryPath(), std::ios::binary | std::ios::trunc);
  out.write(header.data(), static_cast<std::streamsize>(header.size()));
  out.write(reinterpret_cast<const char*>(cloud.data.data()), static_cast<std::streamsize>(cloud.data.size()));
  out.close();
  if (!out)
    throw file.failure(errno != 0 ? std::strerror(errno) : "write failed, is the disk full?");
}
}  // namespace weld_profiler
