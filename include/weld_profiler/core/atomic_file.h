#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
/// A file that appears whole or not at all: written under a hidden name beside its target, then renamed onto it.
///
/// An earlier file of that name stays untouched until commit(). What is not committed is removed with the object.
/// It guards against a full disk and a stopped program, not against a power cut (nothing is flushed to the medium).
/// Header only, because rooms that link nothing of the core write files too. Not thread safe; one object a file.
class AtomicFile
{
public:
  /// Makes the empty temporary file.
  /// @throws InputError naming path and cause: folder missing or not writable, path is a folder or a device.
  explicit AtomicFile(const std::string& path) : path_(path)
  {
    namespace fs = std::filesystem;
    std::error_code ignored;
    fs::path target(path);
    if (path.empty() || target.filename().empty())
      throw InputError("cannot write '" + path + "': no file name, give one");
    if (fs::exists(target, ignored) && !fs::is_regular_file(target, ignored))
      throw InputError("cannot write " + path + ": it exists and is not a regular file, give another name");
    if (fs::is_symlink(target, ignored) && fs::exists(target, ignored))
      target = fs::canonical(target, ignored);  // the link stays, its file is replaced
    target_ = target.string();
    static std::atomic<unsigned> counter{ 0 };
    const std::string name =
        "." + target.filename().string() + "." + std::to_string(::getpid()) + "." + std::to_string(counter++) + ".tmp";
    temporary_ = (target.parent_path() / name).string();
    const int descriptor = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor < 0)
      throw failure(std::strerror(errno));
    ::close(descriptor);
  }

  ~AtomicFile()
  {
    if (!committed_)
      ::unlink(temporary_.c_str());
  }

  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write until commit().
  const std::string& temporaryPath() const { return temporary_; }

  /// Replaces the temporary file's content. @throws InputError naming path and cause.
  void write(const std::string& content)
  {
    errno = 0;
    std::ofstream file(temporary_, std::ios::binary | std::ios::trunc);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file)
      throw failure(errno != 0 ? std::strerror(errno) : "write failed, is the disk full?");
  }

  /// Puts the file in its place. @throws InputError naming path and cause; the temporary file is removed then.
  void commit()
  {
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
      throw failure(std::strerror(errno));
    committed_ = true;
  }

  /// The error to throw when writing the temporary file failed.
  InputError failure(const std::string& cause) const
  {
    return InputError("cannot write " + path_ + ": " + cause +
                      "; check that its folder exists, is writable and has room");
  }

private:
  std::string path_;    ///< as asked for, for messages
  std::string target_;  ///< with links followed
  std::string temporary_;
  bool committed_ = false;
};

/// Writes a text file whole or not at all. @throws InputError naming path and cause.
inline void writeWholeFile(const std::string& path, const std::string& content)
{
  AtomicFile file(path);
  file.write(content);
  file.commit();
}
}  // namespace weld_profiler
