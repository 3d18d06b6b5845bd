#include "weld_profiler/scan/scan_file.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
constexpr float kSigma = 1e-5F;          // of a point that tells none [m]
constexpr std::size_t kMost = 1U << 28;  // points
constexpr double kNanoseconds = 1e9;

[[noreturn]] void refuse(const std::string& path, const std::string& cause)
{
  throw InputError(path + ": " + cause + ", give an organised PCD cloud as scan_bag writes it");
}

/// PCL says on the terminal what is wrong with a file; whoever asked is told by the exception.
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

pcl::PCLPointCloud2 readCloud(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    refuse(path, std::filesystem::exists(path, error) ? "is no file" : "cannot be read: no such file");
  const QuietPcl quiet;
  pcl::PCLPointCloud2 cloud;
  try
  {
    pcl::PCDReader reader;
    Eigen::Vector4f origin;
    Eigen::Quaternionf orientation;
    int version = 0, form = 0;
    unsigned int begin = 0;
    if (reader.readHeader(path, cloud, origin, orientation, version, form, begin) < 0)
      refuse(path, "is no PCD file or cannot be read");
    const std::size_t points = static_cast<std::size_t>(cloud.width) * cloud.height;
    const std::size_t least = form == 1 ? points * cloud.point_step : form == 0 ? 2 * points : 0;  // 0 ascii, 1 binary
    if (points > kMost || begin + least > std::filesystem::file_size(path) + 1)
      refuse(path, "ends before its " + std::to_string(points) + " points do");
    cloud = pcl::PCLPointCloud2();
    if (reader.read(path, cloud) < 0)
      refuse(path, "is damaged");
  }
  catch (const Error&)
  {
    throw;
  }
  catch (const std::exception& problem)
  {
    refuse(path, std::string("is damaged: ") + problem.what());
  }
  return cloud;
}

/// A field of a cloud's points.
class Field
{
public:
  Field(const pcl::PCLPointCloud2& cloud, const std::string& name, std::uint8_t type) : cloud_(cloud)
  {
    for (const pcl::PCLPointField& field : cloud.fields)
    {
      found_ = found_ || (field.name == name && field.datatype == type && field.count == 1);
      if (field.name == name)
        offset_ = field.offset;
    }
  }

  bool found() const { return found_; }

  template <class Value>
  Value at(std::size_t i, Value otherwise) const
  {
    if (found_)
      std::memcpy(&otherwise, &cloud_.data[i * cloud_.point_step + offset_], sizeof(Value));
    return otherwise;
  }

private:
  const pcl::PCLPointCloud2& cloud_;
  std::size_t offset_ = 0;
  bool found_ = false;
};

struct CloudReader
{
  explicit CloudReader(const pcl::PCLPointCloud2& cloud)
    : x(cloud, "x", pcl::PCLPointField::FLOAT32),
      y(cloud, "y", pcl::PCLPointField::FLOAT32),
      z(cloud, "z", pcl::PCLPointField::FLOAT32),
      intensity(cloud, "intensity", pcl::PCLPointField::FLOAT32),
      sigma(cloud, "sigma", pcl::PCLPointField::FLOAT32),
      stage(cloud, "stage", pcl::PCLPointField::FLOAT32),
      time(cloud, "time", pcl::PCLPointField::FLOAT32),
      flags(cloud, "flags", pcl::PCLPointField::UINT8)
  {
  }

  Profile row(std::size_t begin, std::uint32_t cells) const
  {
    Profile profile;
    profile.cells = cells;
    profile.stage = static_cast<double>(stage.at(begin, 0.0F));
    const auto seconds = static_cast<double>(time.at(begin, 0.0F));
    profile.stamp = std::abs(seconds) < 1e9 ? static_cast<Stamp>(std::llround(kNanoseconds * seconds)) : 0;
    for (std::uint32_t cell = 0; cell < cells; ++cell)
    {
      const std::size_t i = begin + cell;
      constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
      CloudPoint point;
      point.x = x.at(i, kNone), point.y = y.at(i, kNone), point.z = z.at(i, kNone);
      if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
        continue;
      point.intensity = intensity.at(i, 0.0F);
      point.sigma = sigma.at(i, kSigma);
      if (!(point.sigma > 0.0F) || !std::isfinite(point.sigma))
        point.sigma = kSigma;
      point.flags = flags.at(i, std::uint8_t{ 0 });
      point.cell = static_cast<std::uint16_t>(cell);
      profile.points.push_back(point);
    }
    return profile;
  }

  Field x, y, z, intensity, sigma, stage, time, flags;
};
}  // namespace

Scan loadScan(const std::string& path)
{
  const pcl::PCLPointCloud2 cloud = readCloud(path);
  const CloudReader reader(cloud);
  if (!reader.x.found() || !reader.y.found() || !reader.z.found())
    refuse(path, "has no fields x y z of type FLOAT32");
  if (cloud.height < 2)
    refuse(path, "is not organised (HEIGHT " + std::to_string(cloud.height) + ", must be a row a profile)");
  if (cloud.width > std::numeric_limits<std::uint16_t>::max())
    refuse(path, "has " + std::to_string(cloud.width) + " columns, at most 65535 can be used");
  Scan scan;
  scan.cells = cloud.width;
  scan.end = ScanEnd::Stopped;
  for (std::uint32_t row = 0; row < cloud.height; ++row)
    scan.rows.push_back(reader.row(static_cast<std::size_t>(row) * cloud.width, cloud.width));
  return scan;
}
}  // namespace weld_profiler
