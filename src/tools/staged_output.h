#pragma once

#include <string>
#include <vector>

namespace weld_profiler
{
/// Outputs that appear whole or not at all. Each target gets a temporary name beside it; commit() gives all of them
/// their names, and without commit() the destructor removes what was written.
class StagedOutput
{
public:
  StagedOutput() = default;
  ~StagedOutput();
  StagedOutput(const StagedOutput&) = delete;
  StagedOutput& operator=(const StagedOutput&) = delete;

  /// @return where to write the file meanwhile. @throws InputError when the target cannot be written there.
  std::string file(const std::string& target);

  /// The same for a directory, which the caller creates. An existing one is replaced on commit().
  std::string directory(const std::string& target);

  /// @throws InputError naming the target.
  void commit();

private:
  struct Entry
  {
    std::string target;
    std::string temporary;
  };
  std::string stage(const std::string& target);

  std::vector<Entry> entries_;
};

/// Creates a directory and its parents unless it is there. @throws InputError naming it and the cause.
void makeOutputDirectory(const std::string& directory);

/// Writes a file whole or not at all. @throws InputError naming path and cause.
void writeFileWhole(const std::string& path, const std::string& content);
}  // namespace weld_profiler
