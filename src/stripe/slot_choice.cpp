#include "slot_choice.h"

namespace weld_profiler
{
namespace
{
constexpr float kNearlyAsGood = 0.5F;  // light, of the better, from which a second piece in a cell is worth a flag
constexpr std::size_t kLeastCells = 5;
constexpr int kSmallGap = 3;  // cells that may be missing inside a piece
}  // namespace

void SlotChoice::overlay(const ColumnTrack& track, const std::vector<float>& light)
{
  for (const ColumnTrack::Piece& piece : track.pieces)
    for (int k = 0; k < piece.count; ++k)
    {
      const int slot = piece.slot + k;
      if (!(light[slot] > 0.0F))
        continue;
      const int cell = piece.cell + k;
      const int before = slots_[cell];
      if (before < 0)
      {
        slots_[cell] = slot;
        continue;
      }
      const bool brighter = light[slot] > light[before];
      const float least = light[brighter ? before : slot];
      const float most = light[brighter ? slot : before];
      const bool close = least > kNearlyAsGood * most;
      close_[cell] = close || (!brighter && close_[cell] != 0) ? 1 : 0;
      slots_[cell] = brighter ? slot : before;
    }
}

void SlotChoice::choose(const ColumnTrack& track, const std::vector<float>& light, int cells)
{
  slots_.assign(static_cast<std::size_t>(cells), -1);
  close_.assign(static_cast<std::size_t>(cells), 0);
  overlay(track, light);
  chosen_.resize(static_cast<std::size_t>(cells));
  std::size_t count = 0;
  std::size_t begin = 0;  // of what lies between two gaps
  const auto dropShort = [&] { count = count - begin < kLeastCells ? begin : count; };
  Slot last{ -kSmallGap - 2, -1, false, false };
  for (int cell = 0; cell < cells; ++cell)
  {
    const int slot = slots_[cell];
    if (slot < 0)
      continue;
    const bool gap = cell - last.cell > kSmallGap + 1;
    if (gap)
    {
      dropShort();
      begin = count;
    }
    const bool torn = gap || slot - last.slot != cell - last.cell;
    last = Slot{ cell, slot, torn, close_[cell] != 0 };
    chosen_[count++] = last;
  }
  dropShort();
  chosen_.resize(count);
}
}  // namespace weld_profiler
