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

  /// @param image      mono8, mono16, bayer_*8/16, rgb8/16, bgr8/16, rgba8/16, bgra8/16; raw.
  /// @param workspace  scratch, one a thread and stream. With direction `auto` every frame is searched both ways, until
  ///                   one shows a stripe in a quarter of its cells, twice as long as what the other way shows: its
  ///                   direction is kept until Workspace::reset().
  /// @param stripe     u, v in full-resolution pixels of `image` (a region's offset and the Bayer grid are undone).
  /// @throws PreconditionError for an empty image, an unknown encoding (naming the known ones) a step that is too
  ///         short or not of whole samples, or a region outside the image.
  void process(const RawImage& image, Workspace& workspace, Stripe& stripe) const;

  const StripeParams& params() const { return params_; }

private:
  void extractAlong(Direction direction, const ImageView& view, int pitch, Workspace& workspace, Stripe& stripe) const;
  void extractAnyDirection(const ImageView& view, int pitch, Workspace& workspace, Stripe& stripe) const;

  StripeParams params_;
  std::unique_ptr<const StripeExtractor> extractor_;
  std::unique_ptr<const StripeExtractor> every_second_pixel_;  ///< the same for the photosites of one colour
};
}  // namespace weld_profiler
