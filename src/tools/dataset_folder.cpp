#include "tools/dataset_folder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <vector>

#include "tools/dataset_weld.h"
#include "tools/staged_output.h"
#include "weld_profiler/core/atomic_file.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;
const char* const kIndex = "index.csv";
const char* const kSettings = "dataset.yaml";

std::string settingsOf(const DatasetPlan& plan)
{
  std::ostringstream text;
  text << "weld_dataset: 2\nseed: " << plan.seed << "\nvalidation: " << plan.validation << '\n';
  return text.str();
}

std::string header()
{
  std::string line;
  for (const std::string& column : datasetColumns())
    line += (line.empty() ? "" : ",") + column;
  return line;
}

std::string contentOf(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// What puts index.csv in order, whatever the split.
std::string numberOf(const std::string& file)
{
  return file.substr(file.rfind('/') + 1);
}

/// Whether a path below its folder is a data set's.
bool belongs(const std::string& relative)
{
  static const std::regex known(R"(train|validation|index\.csv|dataset\.yaml|(train|validation)/weld_[0-9]{6}\.pcd)");
  return std::regex_match(relative, known);
}

/// A file that a stopped program left: its name is AtomicFile's.
bool isLeftOver(const std::string& relative)
{
  static const std::regex known(R"(((train|validation)/)?\.(index\.csv|dataset\.yaml|weld_[0-9]{6}\.pcd)[0-9.]*\.tmp)");
  return std::regex_match(relative, known);
}
}  // namespace

DatasetFolder::DatasetFolder(const std::string& directory, const DatasetPlan& plan) : directory_(directory)
{
  const fs::path settings = fs::path(directory) / kSettings;
  if (fs::exists(settings))
  {
    if (contentOf(settings) != settingsOf(plan))
      throw InputError(settings.string() +
                       ": the data set there has another --seed or --validation, or is of another " +
                       "version; give the same, or another --out");
    refuseForeign();
  }
  else if (fs::exists(directory) && (!fs::is_directory(directory) || !fs::is_empty(directory)))
    throw InputError(directory + ": holds something else than a data set (there is no dataset.yaml); name a new or " +
                     "an empty folder with --out");
  makeOutputDirectory(directory);
  writeWholeFile(settings.string(), settingsOf(plan));  // first: what is there from now on is known as a data set
  makeOutputDirectory(directory + "/train");
  makeOutputDirectory(directory + "/validation");
  readIndex();
}

bool DatasetFolder::has(const DatasetEntry& entry) const
{
  return lines_.count(numberOf(entry.file)) != 0 && fs::is_regular_file(path(entry));
}

void DatasetFolder::add(const DatasetEntry& entry, const std::string& line)
{
  lines_[numberOf(entry.file)] = line;
  std::string text = header() + "\n";
  for (const auto& cloud : lines_)
    text += cloud.second + "\n";
  writeWholeFile(directory_ + "/" + kIndex, text);
}

void DatasetFolder::refuseForeign() const
{
  std::vector<fs::path> left_over;
  for (const auto& entry : fs::recursive_directory_iterator(directory_))
  {
    const std::string relative = fs::relative(entry.path(), directory_).generic_string();
    if (isLeftOver(relative))
      left_over.push_back(entry.path());
    else if (!belongs(relative))
      throw InputError(entry.path().string() + ": is no part of a data set; move it away, or give another --out");
  }
  for (const fs::path& path : left_over)
    fs::remove(path);
}

void DatasetFolder::readIndex()
{
  std::ifstream file(fs::path(directory_) / kIndex);
  std::string line;
  if (!std::getline(file, line))
    return;
  if (line != header())
    throw InputError(directory_ + "/" + kIndex + ": has other columns than this program writes; give another --out");
  while (std::getline(file, line))
  {
    const auto columns = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
    if (columns == datasetColumns().size())
      lines_[numberOf(line.substr(0, line.find(',')))] = line;
  }
}
}  // namespace weld_profiler
