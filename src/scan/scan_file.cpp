#include "weld_profiler/scan/scan_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

#include <pcl/io/pcd_io.h>

#include "quiet_pcl.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
constexpr float kSigma = 1e-5F;          // of a point that tells none [m]
constexpr std::size_t kMost = 1U << 26;  // points
constexpr double kNanoseconds = 1e9;

[[noreturn]] void refuse(const std::string& path, const std::string& cause)
{
  throw InputError(path + ": " + cause + ", give an organised PCD cloud as scan_bag writes it");
}

/// Header of a PCD file, as far as it must be right before PCL may read the rest: PCL trusts it.
struct Header
{
  std::size_t fields = 0, width = 0, height = 0, points = 0;
  std::size_t point_bytes = 0;
  std::string form;  ///< DATA
  std::size_t begin = 0;
};

std::size_t sumOfProducts(const std::vector<std::size_t>& sizes, const std::vector<std::size_t>& counts)
{
  std::size_t sum = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    sum += sizes[i] * (i < counts.size() ? counts[i] : 1);
  return sum;
}

/// What could not be read stays 0 or empty.
Header readHeader(const std::string& path)
{
  constexpr std::size_t kLongest = 65536;
  std::ifstream file(path, std::ios::binary);
  std::string text(kLongest, '\0');
  file.read(&text[0], static_cast<std::streamsize>(kLongest));
  text.resize(static_cast<std::size_t>(file.gcount()));
  Header header;
  std::vector<std::size_t> sizes, counts;
  std::size_t at = 0;
  while (header.form.empty() && at < text.size())
  {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::istringstream line(text.substr(at, end - at));
    at = end + 1;
    std::string key, word;
    line >> key;
    const auto numbers = [&line](std::vector<std::size_t>& values)
    {
      for (std::size_t value = 0; line >> value && value < kLongest;)
        values.push_back(value);
    };
    if (key == "FIELDS")
      while (line >> word)
        ++header.fields;
    else if (key == "SIZE")
      numbers(sizes);
    else if (key == "COUNT")
      numbers(counts);
    else if (key == "WIDTH")
      line >> header.width;
    else if (key == "HEIGHT")
      line >> header.height;
    else if (key == "POINTS")
      line >> header.points;
    else if (key == "DATA")
      line >> header.form;
  }
  header.begin = at;
  header.point_bytes = sizes.size() == header.fields ? sumOfProducts(sizes, counts) : 0;
  return header;
}

void checkHeader(const std::string& path)
{
  const Header header = readHeader(path);
  const bool known = header.form == "ascii" || header.form == "binary" || header.form == "binary_compressed";
  if (!known || header.fields == 0 || header.point_bytes == 0 || header.width == 0 || header.height == 0)
    refuse(path, "is no PCD file, or its header is damaged");
  if (header.width > kMost || header.height > kMost || header.points != header.width * header.height ||
      header.points > kMost)
    refuse(path, "its header is damaged or it has too many points (" + std::to_string(header.points) + " of " +
                     std::to_string(header.width) + " x " + std::to_string(header.height) + ")");
  const std::size_t least = header.form == "binary"  ? header.points * header.point_bytes
                            : header.form == "ascii" ? 2 * header.points * header.fields - 1
                                                     : 8;
  if (header.begin + least > std::filesystem::file_size(path))
    refuse(path, "ends before its " + std::to_string(header.points) + " points do");
}

pcl::PCLPointCloud2 readCloud(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    refuse(path, std::filesystem::exists(path, error) ? "is no file" : "cannot be read: no such file");
  checkHeader(path);
  const QuietPcl quiet;
  pcl::PCLPointCloud2 cloud;
  int status = -1;
  try
  {
    status = pcl::PCDReader().read(path, cloud);
  }
  catch (const std::exception& problem)
  {
    refuse(path, std::string("is damaged: ") + problem.what());
  }
  if (status < 0 || cloud.data.size() != static_cast<std::size_t>(cloud.width) * cloud.height * cloud.point_step)
    refuse(path, "is damaged");
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
