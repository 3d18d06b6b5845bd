#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace weld_profiler
{
/// What is known of each point of an organised cloud: one field of a file.
struct FloatMap
{
  std::string name;
  const std::vector<float>& values;  ///< rows x columns, NaN = unknown
};

/// Writes maps as the fields of an organised, binary PCD cloud, FLOAT32, whole or not at all.
/// @param comments  for the file's head, one line each.
/// @throws PreconditionError when the maps differ in size or are no whole rows; InputError naming path and cause.
void saveFloatMaps(const std::vector<FloatMap>& maps, std::size_t columns, const std::string& path,
                   const std::vector<std::string>& comments = {});
}  // namespace weld_profiler
