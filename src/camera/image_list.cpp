#include "weld_profiler/camera/folder_source.h"

#include <glob.h>
#include <strings.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;

bool isDigit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::string digitsAt(const std::string& text, std::size_t& at)
{
  const std::size_t begin = at;
  while (at < text.size() && isDigit(text[at]))
    ++at;
  const std::size_t first = std::min(text.find_first_not_of('0', begin), at);
  return text.substr(first, at - first);
}

// img2 before img10: runs of digits compare as numbers of any length, the rest by character.
bool naturallyLess(const std::string& a, const std::string& b)
{
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size())
  {
    if (isDigit(a[i]) && isDigit(b[j]))
    {
      const std::string left = digitsAt(a, i);
      const std::string right = digitsAt(b, j);
      if (left.size() != right.size())
        return left.size() < right.size();
      if (left != right)
        return left < right;
      continue;
    }
    if (a[i] != b[j])
      return a[i] < b[j];
    ++i;
    ++j;
  }
  if (i < a.size() || j < b.size())
    return j < b.size();
  return a < b;  // img1 and img01: some order, always the same
}

bool hasImageExtension(const fs::path& path)
{
  static const std::array<const char*, 9> kExtensions{ { ".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm",
                                                         ".ppm", ".pnm" } };
  const std::string extension = path.extension().string();
  return std::any_of(kExtensions.begin(), kExtensions.end(),
                     [&](const char* known) { return strcasecmp(known, extension.c_str()) == 0; });
}

std::vector<std::string> filesOfDirectory(const std::string& directory)
{
  std::error_code error;
  fs::directory_iterator entry(directory, error);
  if (error)
    throw InputError(directory + ": the directory cannot be read: " + error.message());
  std::vector<std::string> files;
  for (; entry != fs::directory_iterator(); ++entry)
    if (entry->is_regular_file() && hasImageExtension(entry->path()))
      files.push_back(entry->path().string());
  if (files.empty())
    throw InputError(directory + ": no image in this directory; expected png, jpg, bmp, tif, pgm or ppm files");
  return files;
}

std::vector<std::string> filesOfGlob(const std::string& pattern)
{
  glob_t found{};
  std::vector<std::string> files;
  if (glob(pattern.c_str(), GLOB_TILDE, nullptr, &found) == 0)
    for (std::size_t i = 0; i < found.gl_pathc; ++i)
      if (fs::is_regular_file(found.gl_pathv[i]))
        files.emplace_back(found.gl_pathv[i]);
  globfree(&found);
  if (files.empty())
    throw InputError(pattern + ": no such directory or file, and as a glob it matches no image; check the path");
  return files;
}
}  // namespace

std::vector<std::string> listImages(const std::string& directory_or_glob)
{
  if (directory_or_glob.empty())
    throw InputError("images is empty, must be a directory or a glob such as /data/run3/*.png");
  std::error_code ignored;
  std::vector<std::string> files;
  if (fs::is_directory(directory_or_glob, ignored))
    files = filesOfDirectory(directory_or_glob);
  else if (fs::is_regular_file(directory_or_glob, ignored))
    files = { directory_or_glob };  // a name with brackets in it is still a name
  else
    files = filesOfGlob(directory_or_glob);
  std::sort(files.begin(), files.end(), naturallyLess);
  return files;
}
}  // namespace weld_profiler
