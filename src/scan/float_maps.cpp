#include "weld_profiler/scan/float_maps.h"

#include <cstring>

#include "pcd_file.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
void saveFloatMaps(const std::vector<FloatMap>& maps, std::size_t columns, const std::string& path,
                   const std::vector<std::string>& comments)
{
  const std::size_t points = maps.empty() ? 0 : maps.front().values.size();
  if (columns == 0 || points % columns != 0)
    throw PreconditionError("maps have " + std::to_string(points) + " values, must be whole rows of " +
                            std::to_string(columns));
  pcl::PCLPointCloud2 cloud;
  cloud.width = static_cast<std::uint32_t>(columns);
  cloud.height = static_cast<std::uint32_t>(points / columns);
  cloud.point_step = static_cast<std::uint32_t>(maps.size() * sizeof(float));
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = 0;
  cloud.data.resize(points * cloud.point_step);
  for (std::size_t field = 0; field < maps.size(); ++field)
  {
    const FloatMap& map = maps[field];
    if (map.values.size() != points)
      throw PreconditionError("map " + map.name + " has " + std::to_string(map.values.size()) + " values, must be " +
                              std::to_string(points) + " as the first");
    addField(cloud, map.name.c_str(), static_cast<std::uint32_t>(field * sizeof(float)), pcl::PCLPointField::FLOAT32);
    for (std::size_t i = 0; i < points; ++i)
      std::memcpy(&cloud.data[i * cloud.point_step + field * sizeof(float)], &map.values[i], sizeof(float));
  }
  AtomicFile file(path);
  writePcd(cloud, file, comments);
  file.commit();
}
}  // namespace weld_profiler
