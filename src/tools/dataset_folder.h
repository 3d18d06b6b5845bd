#pragma once

#include <map>
#include <string>

#include "tools/dataset_plan.h"

namespace weld_profiler
{
/// A data set on disk: train/, validation/, index.csv with a line a cloud, dataset.yaml with what it was made from.
/// A cloud belongs to it once its line stands in index.csv.
class DatasetFolder
{
public:
  /// Makes a new or empty folder one of this plan, or goes on with one.
  /// @throws InputError for a folder that holds anything else, or a data set of another plan.
  DatasetFolder(const std::string& directory, const DatasetPlan& plan);

  bool has(const DatasetEntry& entry) const;
  std::string path(const DatasetEntry& entry) const { return directory_ + "/" + entry.file; }

  /// Adds a cloud that is written. @param line  its line of index.csv. @throws InputError naming path and cause.
  void add(const DatasetEntry& entry, const std::string& line);

private:
  void refuseForeign() const;
  void readIndex();

  std::string directory_;
  std::map<std::string, std::string> lines_;  ///< of index.csv, by the number in the file's name
};
}  // namespace weld_profiler
