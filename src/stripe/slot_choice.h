#pragma once

#include <cstdint>
#include <vector>

#include "column_track.h"
#include "multiversion.h"

namespace weld_profiler
{
/// What the light of a column must reach to be a stripe's.
struct LeastLight
{
  float light;  ///< [grey levels]
  float noise;  ///< 1-sigma of one pixel [grey levels]

  /// That a light's square times its half width must reach too.
  WELD_PROFILER_KERNEL float square() const
  {
    constexpr float kLightOverNoise = 4.0F;  // half the chance of one false column in 30 000
    return kLightOverNoise * noise * (kLightOverNoise * noise);
  }
};

/// Chooses for each cell the slot that speaks for it: of two pieces that overlap in a cell the brighter stays, and what
/// is left of fewer than 5 cells between gaps of more than 3 is no stripe.
class SlotChoice
{
public:
  struct Slot
  {
    int cell, slot;
    bool starts_piece;  ///< the line is torn before it: another piece, or a gap of more than 3 cells
    bool ambiguous;     ///< a second piece was nearly as bright
  };

  /// @param light  of each slot; 0 = not to be chosen.
  /// @param cells  columns of the image.
  void choose(const ColumnTrack& track, const std::vector<float>& light, int cells);

  /// Leaves all but these cells out.
  /// @param cells  rising; each was chosen.
  void keep(const std::vector<std::uint16_t>& cells);

  /// In rising cells.
  const std::vector<Slot>& chosen() const { return chosen_; }

private:
  void overlay(const ColumnTrack& track, const std::vector<float>& light);

  std::vector<int> slots_;           ///< of each cell; -1 = none
  std::vector<std::uint8_t> close_;  ///< of each cell: a second piece was nearly as bright
  std::vector<Slot> chosen_;
};
}  // namespace weld_profiler
