#include "tools/staged_output.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const std::string& cause)
{
  throw InputError(path + ": cannot be written: " + cause);
}

fs::path parentOf(const std::string& path)
{
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? fs::path(".") : parent;
}
}  // namespace

StagedOutput::~StagedOutput()
{
  std::error_code ignored;
  for (const Entry& entry : entries_)
    fs::remove_all(entry.temporary, ignored);
}

std::string StagedOutput::stage(const std::string& target)
{
  std::error_code error;
  const fs::path parent = parentOf(target);
  if (!fs::is_directory(parent, error))
    refuse(target, "there is no directory " + parent.string() + "; create it first");
  const fs::path name = fs::path(target).filename();
  if (name.empty())
    refuse(target, "the name is empty; name a file");
  // same directory, so that commit() is a rename; same extension, for writers that choose the format by it
  const std::string hidden = "." + name.stem().string() + ".partial." + std::to_string(getpid());
  entries_.push_back({ target, (parent / (hidden + name.extension().string())).string() });
  return entries_.back().temporary;
}

std::string StagedOutput::file(const std::string& target)
{
  std::error_code error;
  if (fs::is_directory(target, error))
    refuse(target, "it is a directory; name a file");
  std::string temporary = stage(target);
  errno = 0;
  if (!std::ofstream(temporary))
    refuse(target, std::strerror(errno != 0 ? errno : EIO));
  return temporary;
}

std::string StagedOutput::directory(const std::string& target)
{
  std::error_code error;
  if (fs::exists(target, error) && !fs::is_directory(target, error))
    refuse(target, "a file of this name is in the way; remove it");
  return stage(target);
}

void StagedOutput::commit()
{
  for (const Entry& entry : entries_)
  {
    std::error_code error;
    if (fs::is_directory(entry.target))
      fs::remove_all(entry.target, error);
    if (!error)
      fs::rename(entry.temporary, entry.target, error);
    if (error)
      refuse(entry.target, error.message());
  }
  entries_.clear();
}

void makeOutputDirectory(const std::string& directory)
{
  std::error_code error;
  fs::create_directories(directory, error);
  if (error || !fs::is_directory(directory))
    throw InputError(directory + ": the directory cannot be created: " +
                     (error ? error.message() : "a file of this name is in the way"));
  if (access(directory.c_str(), W_OK | X_OK) != 0)
    throw InputError(directory + ": the directory cannot be written to: " + std::strerror(errno));
}

void writeFileWhole(const std::string& path, const std::string& content)
{
  StagedOutput output;
  const std::string temporary = output.file(path);
  errno = 0;
  std::ofstream file(temporary, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file)
    refuse(path, std::strerror(errno != 0 ? errno : EIO));
  output.commit();
}
}  // namespace weld_profiler
