// Drives image, encoding, direction and parameters through every method of the table; two frames a workspace.
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "fuzz/fuzz_frame.h"
#include "fuzz/fuzz_params.h"
#include "fuzz/stripe_promises.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/stripe/overlay.h"
#include "weld_profiler/stripe/stripe_methods.h"
#include "weld_profiler/stripe/stripe_stage.h"

namespace weld_profiler
{
namespace fuzz
{
namespace
{
constexpr int kLargestDrawn = 64;  ///< px; larger pictures take longer than all methods together

std::vector<Frame> readFrames(Bytes& bytes)
{
  std::vector<Frame> frames;
  Layout layout = readLayout(bytes);
  if (bytes.oneIn(8))
    frames.emplace_back(layout, bytes);
  Picture picture = readPicture(bytes);
  if (frames.empty())
    frames.emplace_back(layout, picture);
  // Mostly the same stripe a little farther on, sometimes another image altogether.
  if (bytes.oneIn(6))
    layout = readLayout(bytes);
  if (bytes.oneIn(6))
    picture = readPicture(bytes);
  for (Picture::Line& line : picture.line)
    line.row += bytes.real(-6.0, 6.0);
  ++picture.seed;
  frames.emplace_back(layout, picture);
  return frames;
}

void runMethod(const StripeParams& params, const std::vector<Frame>& frames, bool keep_trace, int scale)
{
  std::unique_ptr<const StripeStage> stage;
  try
  {
    stage = std::make_unique<StripeStage>(params);
  }
  catch (const ConfigError&)
  {
    return;
  }
  Workspace workspace;
  workspace.keep_trace = keep_trace;
  workspace.reset();
  Stripe stripe;
  for (const Frame& frame : frames)
    try
    {
      stage->process(frame.image(), workspace, stripe);
      const std::string broken = brokenPromise(stripe, frame.image(), params);
      if (!broken.empty())
      {
        std::fprintf(stderr, "%s: %s\n", params.method.c_str(), broken.c_str());
        std::abort();
      }
      if (scale > 0 && std::max(frame.image().width, frame.image().height) <= kLargestDrawn)
        drawStripe(frame.image(), stripe, workspace.initial, scale);
    }
    catch (const PreconditionError&)
    {
    }
}
}  // namespace
}  // namespace fuzz
}  // namespace weld_profiler

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace weld_profiler;
  fuzz::Bytes bytes(data, size);
  StripeParams params = fuzz::readParams(bytes);
  const bool keep_trace = bytes.oneIn(3);
  const int scale = bytes.oneIn(8) ? bytes.between(1, 8) : 0;
  const std::vector<fuzz::Frame> frames = fuzz::readFrames(bytes);
  for (const std::string& method : stripeMethods())
  {
    params.method = method;
    fuzz::runMethod(params, frames, keep_trace, scale);
  }
  return 0;
}
