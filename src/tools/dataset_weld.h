#pragma once

#include <string>
#include <vector>

#include "tools/dataset_plan.h"

namespace weld_profiler
{
/// Columns of index.csv, in order.
const std::vector<std::string>& datasetColumns();

/// Renders an entry's weld, sends it through the chain and writes its labelled cloud, whole or not at all.
/// @return the entry's line of index.csv, without line end.
/// @throws InputError naming path and cause.
std::string writeDatasetCloud(const DatasetEntry& entry, const std::string& path);
}  // namespace weld_profiler
