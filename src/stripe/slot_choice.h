#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "column_track.h"

namespace weld_profiler
{
/// Chooses for each cell the slot that speaks for it: of two pieces that overlap in a cell the brighter stays, and what
/// is left of fewer than 5 cells between gaps of more than 3 is no stripe.
class SlotChoice
{
public:
  /// Neighbouring cells whose slots are neighbours as well.
  struct Run
  {
    int cell, slot, count;
    bool starts_piece;  ///< the line is torn before it: another piece, or a gap of more than 3 cells
    bool ambiguous;     ///< a second piece was nearly as bright, in all of its cells
  };

  /// @param light  of each slot; 0 = not to be chosen.
  /// @param cells  columns of the image.
  void choose(const ColumnTrack& track, const std::vector<float>& light, int cells);

  /// In rising cells.
  const std::vector<Run>& runs() const { return runs_; }
  /// Cells of all runs.
  std::size_t size() const { return size_; }

private:
  void overlay(const ColumnTrack& track, const std::vector<float>& light);
  void runsOfOne(const ColumnTrack::Piece& piece, const std::vector<float>& light);
  void runsOfCells(int cells);
  void dropShort();

  std::vector<int> slots_;           ///< of each cell; -1 = none
  std::vector<std::uint8_t> close_;  ///< of each cell: a second piece was nearly as bright
  std::vector<Run> runs_;
  std::size_t size_ = 0;
};
}  // namespace weld_profiler
