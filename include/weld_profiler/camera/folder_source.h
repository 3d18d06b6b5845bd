#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weld_profiler/camera/frame_source.h"

namespace weld_profiler
{
/// Settings of FolderSource.
struct FolderSourceParams
{
  std::string images;     ///< a directory, or a glob such as /data/run3/*.png
  double rate = 20.0;     ///< frames a second, (0, 10000]
  bool loop = false;      ///< begin again after the last image
  double exposure = 0.0;  ///< written into the frames [s], >= 0; 0 = unknown

  void validate() const;  ///< @throws ConfigError naming field, value and range

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("images", images);
    v("rate", rate);
    v("loop", loop);
    v("exposure", exposure);
  }
};

/// Names of the image files a directory or glob stands for, in natural order (img2 before img10).
/// @throws InputError when there is none, naming the pattern.
std::vector<std::string> listImages(const std::string& directory_or_glob);

/// Decodes an image file into frame.pixels as mono8, mono16, bgr8 or bgr16. @throws InputError naming file and cause.
void readImage(const std::string& path, Frame& frame);

/// Plays the images of a folder at a fixed rate, stamped with the wall clock when due. An image that cannot be read, or
/// whose size or encoding is not the first one's, is Result::Failed and leaves a gap in the frame numbers.
class FolderSource : public FrameSource
{
public:
  /// @throws ConfigError, InputError.
  explicit FolderSource(const FolderSourceParams& params);

  Result next(Frame& frame, double timeout_seconds) override;
  std::string message() const override { return message_; }

private:
  bool waitUntilDue(double timeout_seconds);
  void requireSameShape(const Frame& frame);

  FolderSourceParams params_;
  std::vector<std::string> files_;
  std::size_t index_ = 0;
  std::uint64_t number_ = 0;
  Stamp due_ = 0;
  std::string shape_;  ///< size and encoding of the first image that could be read
  std::string message_;
};
}  // namespace weld_profiler
