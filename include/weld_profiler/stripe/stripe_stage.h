#pragma once

#include <memory>

#include "weld_profiler/core/image.h"
#include "weld_profiler/core/stripe.h"
#include "weld_profiler/stripe/stripe_extractor.h"
#include "weld_profiler/stripe/stripe_params.h"

namespace weld_profiler
{
/// The whole way from an image as a camera delivers it to the stripe's centre line: channel, region, direction,
/// extraction, repair. Immutable; state (direction found, last stripe) lives in the caller's Workspace.
class StripeStage
{
public:
  /// @throws ConfigError naming field, value and range.
  explicit StripeStage(const StripeParams& params);

  /// @param image      mono8, mono16, bayer_*8/16, rgb8/16, bgr8/16, rgba8, bgra8; raw.
  /// @param workspace  scratch, one a thread and stream. With direction `auto` it remembers the direction of the first
  ///                   frame with a stripe until Workspace::reset().
  /// @param stripe     u, v in full-resolution pixels of `image` (a region's offset and the Bayer grid are undone).
  /// @throws PreconditionError for an empty image or an unknown encoding, naming the known ones.
  void process(const RawImage& image, Workspace& workspace, Stripe& stripe) const;

  const StripeParams& params() const { return params_; }

private:
  StripeParams params_;
  std::unique_ptr<const StripeExtractor> extractor_;
};
}  // namespace weld_profiler
