#pragma once

#include "weld_profiler/core/image.h"
#include "weld_profiler/core/stripe.h"
#include "weld_profiler/stripe/workspace.h"

namespace weld_profiler
{
/// What is known from the last frame. Never changes the result, only the time it takes.
struct StripeHint
{
  const Stripe* last = nullptr;  ///< the last frame's stripe; null = look everywhere
};

/// Finds where the laser stripe crosses each image column (a stripe along the rows; StripeStage turns the others).
///
/// Implementations are immutable after construction, so one object may serve several threads.
class StripeExtractor
{
public:
  virtual ~StripeExtractor() = default;

  /// @param image      8 or 16 bit, raw (not rectified); stripe along the rows.
  /// @param hint       where the stripe was in the last frame; empty = look everywhere.
  /// @param workspace  scratch memory, reused from frame to frame; one a thread.
  /// @param stripe     filled with at most one centre a column, in rising order; empty, with a status, when the frame
  ///                   shows no stripe. After warm-up nothing is allocated.
  virtual void extract(const ImageView& image, const StripeHint& hint, Workspace& workspace, Stripe& stripe) const = 0;
};
}  // namespace weld_profiler
