#pragma once

#include <cstdint>
#include <vector>

#include "along_stripe.h"
#include "column_track.h"
#include "slot_choice.h"
#include "stripe_limits.h"
#include "weld_profiler/core/stripe.h"
#include "weld_profiler/stripe/workspace.h"

namespace weld_profiler
{
/// Turns what was measured column by column into the stripe: one centre a cell, directions and widths across the
/// stripe, flags; what is too dim, too narrow, too wide or too short is left out.
class RidgeCentres
{
public:
  /// @param cells     columns of the image.
  /// @param aperture  columns that each centre was measured over, one a centre of the stripe.
  void write(const ColumnTrack& track, const AlongStripe& along, const StripeLimits& limits, int cells, Stripe& stripe,
             std::vector<std::uint16_t>& aperture);

  /// Where the columns were measured about: the line that was found, before it was joined.
  void trace(const ColumnTrack& track, std::vector<InitialPoint>& initial) const;

private:
  void fill(const AlongStripe& along, Stripe& stripe, std::vector<std::uint16_t>& aperture) const;

  std::vector<float> good_, angle_, intensity_, width_, sigma_;
  std::vector<std::uint8_t> flags_;
  SlotChoice choice_;
};
}  // namespace weld_profiler
