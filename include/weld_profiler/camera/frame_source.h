#pragma once

#include <string>

#include "weld_profiler/core/frame.h"

namespace weld_profiler
{
/// Where images come from: a folder, a GigE Vision camera. Used by one capture thread.
class FrameSource
{
public:
  enum class Result
  {
    Frame,    ///< frame was filled
    Timeout,  ///< nothing yet, ask again
    End,      ///< no more frames (a folder played once)
    Failed    ///< this frame could not be read; message() says why; asking again goes on with the next
  };

  virtual ~FrameSource() = default;

  /// Waits at most timeout_seconds. Reuses frame.pixels' memory. The stamp is set here and nowhere else.
  virtual Result next(Frame& frame, double timeout_seconds) = 0;

  /// One line about the last Failed: thing, value, remedy.
  virtual std::string message() const = 0;
};
}  // namespace weld_profiler
