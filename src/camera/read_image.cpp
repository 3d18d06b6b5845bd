#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "weld_profiler/camera/folder_source.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

Bytes readFile(const std::string& path)
{
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw InputError(path + ": is a directory, expected an image file");
  errno = 0;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file)
    throw InputError(path + ": cannot be read: " + std::strerror(errno != 0 ? errno : EIO));
  Bytes bytes(static_cast<std::size_t>(std::max<std::streamoff>(file.tellg(), 0)));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file)
    throw InputError(path + ": cannot be read to its end");
  if (bytes.empty())
    throw InputError(path + ": is empty (0 bytes), expected an image; write the file again");
  return bytes;
}

bool startsWith(const Bytes& bytes, const Bytes& magic)
{
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

bool endsWith(const Bytes& bytes, const Bytes& mark)
{
  constexpr std::size_t kTrailer = 4096;  // some cameras append their own data after the image
  const auto begin = bytes.size() > kTrailer ? bytes.end() - kTrailer : bytes.begin();
  return std::search(begin, bytes.end(), mark.begin(), mark.end()) != bytes.end();
}

// libjpeg fills what is missing with grey and calls it success; libpng complains on standard error by itself.
void refuseTruncated(const Bytes& bytes, const std::string& path)
{
  const bool cut_jpeg = startsWith(bytes, { 0xFF, 0xD8, 0xFF }) && !endsWith(bytes, { 0xFF, 0xD9 });
  const bool cut_png = startsWith(bytes, { 0x89, 'P', 'N', 'G' }) && !endsWith(bytes, { 'I', 'E', 'N', 'D' });
  if (cut_jpeg || cut_png)
    throw InputError(path + ": the image is truncated (" + std::to_string(bytes.size()) +
                     " bytes, its end mark is missing); copy it again or leave it out");
}

cv::Mat decode(const Bytes& bytes, const std::string& path)
{
  cv::Mat image;
  try
  {
    image = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  }
  catch (const cv::Exception& error)
  {
    throw InputError(path + ": cannot be decoded: " + error.err);
  }
  if (image.empty())
    throw InputError(path +
                     ": not an image that can be decoded (damaged, or of an unknown format); "
                     "expected png, jpg, bmp, tif, pgm or ppm");
  if (image.depth() != CV_8U && image.depth() != CV_16U)
    throw InputError(path + ": pixels are neither 8 nor 16 bit; convert the image");
  if (image.channels() == 4)
    cv::cvtColor(image, image, cv::COLOR_BGRA2BGR);
  if (image.channels() != 1 && image.channels() != 3)
    throw InputError(path + ": has " + std::to_string(image.channels()) + " channels, must have 1, 3 or 4");
  return image;
}
}  // namespace

void readImage(const std::string& path, Frame& frame)
{
  const Bytes bytes = readFile(path);
  refuseTruncated(bytes, path);
  const cv::Mat image = decode(bytes, path);
  const bool wide = image.depth() == CV_16U;
  frame.width = image.cols;
  frame.height = image.rows;
  frame.step = image.elemSize() * static_cast<std::size_t>(image.cols);
  frame.encoding = image.channels() == 1 ? (wide ? "mono16" : "mono8") : (wide ? "bgr16" : "bgr8");
  frame.origin = path;
  frame.pixels.resize(frame.step * static_cast<std::size_t>(frame.height));
  image.copyTo(cv::Mat(image.rows, image.cols, image.type(), frame.pixels.data(), frame.step));
}
}  // namespace weld_profiler
