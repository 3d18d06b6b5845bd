#include "weld_profiler/camera/folder_source.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
Stamp now()
{
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since_epoch).count();
}

std::string shape(const Frame& frame)
{
  return std::to_string(frame.width) + "x" + std::to_string(frame.height) + " " + frame.encoding;
}
}  // namespace

void FolderSourceParams::validate() const
{
  if (images.empty())
    throw ConfigError("camera/images is empty, must be a directory or a glob such as /data/run3/*.png");
  if (!(rate > 0.0 && rate <= 10000.0))
    throw ConfigError("camera/rate is " + std::to_string(rate) + ", must be in (0, 10000] frames a second");
  requireRange("camera/exposure", exposure, 0.0, 10.0, "s");
}

FolderSource::FolderSource(const FolderSourceParams& params) : params_(params)
{
  params_.validate();
  files_ = listImages(params_.images);
}

FrameSource::Result FolderSource::next(Frame& frame, double timeout_seconds)
{
  if (index_ >= files_.size())
  {
    if (!params_.loop)
      return Result::End;
    index_ = 0;
  }
  if (!waitUntilDue(timeout_seconds))
    return Result::Timeout;

  const std::string& file = files_[index_++];
  frame.number = number_++;  // a file that cannot be read leaves a gap, as a frame lost by a driver does
  frame.stamp = due_;
  frame.exposure = params_.exposure;
  due_ = std::max(due_ + fromSeconds(1.0 / params_.rate), now() - fromSeconds(1.0 / params_.rate));
  try
  {
    readImage(file, frame);
    requireSameShape(frame);
  }
  catch (const InputError& error)
  {
    message_ = error.what();
    return Result::Failed;
  }
  return Result::Frame;
}

bool FolderSource::waitUntilDue(double timeout_seconds)
{
  const Stamp start = now();
  if (due_ == 0)
    due_ = start;
  const Stamp wait = due_ - start;
  const Stamp limit = fromSeconds(std::max(timeout_seconds, 0.0));
  if (wait > 0)
    std::this_thread::sleep_for(std::chrono::nanoseconds(std::min(wait, limit)));
  return wait <= limit;
}

void FolderSource::requireSameShape(const Frame& frame)
{
  if (shape_.empty())
    shape_ = shape(frame);
  if (shape(frame) != shape_)
    throw InputError(frame.origin + ": is " + shape(frame) + ", but the images before it are " + shape_ +
                     "; keep images of one size and type in a folder");
}
}  // namespace weld_profiler
