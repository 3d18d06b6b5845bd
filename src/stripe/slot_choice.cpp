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

/// The slots of one piece that have light: whole blocks of them, as nearly all are, at once.
void SlotChoice::runsOfOne(const ColumnTrack::Piece& piece, const std::vector<float>& light)
{
  constexpr int kBlock = 64;
  const float* lights = light.data() + piece.slot;
  bool inside = false;
  const auto step = [&](int at, bool lit)
  {
    if (lit && !inside)
      runs_.push_back(Run{ piece.cell + at, piece.slot + at, 0, false, false });
    if (!lit && inside)
      runs_.back().count = piece.cell + at - runs_.back().cell;
    inside = lit;
  };
  for (int begin = 0; begin < piece.count; begin += kBlock)
  {
    const int end = begin + kBlock < piece.count ? begin + kBlock : piece.count;
    int dark = 0;
    for (int k = begin; k < end; ++k)
      dark |= lights[k] > 0.0F ? 0 : 1;
    if (dark == 0)
      step(begin, true);
    for (int k = begin; dark != 0 && k < end; ++k)
      step(k, lights[k] > 0.0F);
  }
  step(piece.count, false);
}

void SlotChoice::runsOfCells(int cells)
{
  for (int cell = 0; cell < cells; ++cell)
  {
    const int slot = slots_[cell];
    if (slot < 0)
      continue;
    const bool ambiguous = close_[cell] != 0;
    Run* last = runs_.empty() ? nullptr : &runs_.back();
    if (last != nullptr && last->ambiguous == ambiguous && cell - last->cell == last->count &&
        slot - last->slot == last->count)
      ++last->count;
    else
      runs_.push_back(Run{ cell, slot, 1, false, ambiguous });
  }
}

/// Tells where the line is torn, and drops what is left of too few cells between two gaps.
void SlotChoice::dropShort()
{
  size_ = 0;
  std::size_t kept = 0;
  for (std::size_t begin = 0, end = 0; begin < runs_.size(); begin = end)
  {
    const auto gapBefore = [&](std::size_t i)
    { return runs_[i].cell - (runs_[i - 1].cell + runs_[i - 1].count - 1) > kSmallGap + 1; };
    auto count = static_cast<std::size_t>(runs_[begin].count);
    for (end = begin + 1; end < runs_.size() && !gapBefore(end); ++end)
    {
      runs_[end].starts_piece = runs_[end].slot - runs_[end - 1].slot != runs_[end].cell - runs_[end - 1].cell;
      count += static_cast<std::size_t>(runs_[end].count);
    }
    runs_[begin].starts_piece = true;
    for (std::size_t i = begin; count >= kLeastCells && i < end; ++i)
      runs_[kept++] = runs_[i];
    size_ += count >= kLeastCells ? count : 0;
  }
  runs_.resize(kept);
}

void SlotChoice::choose(const ColumnTrack& track, const std::vector<float>& light, int cells)
{
  runs_.clear();
  if (track.pieces.size() == 1)
    runsOfOne(track.pieces.front(), light);
  else
  {
    slots_.assign(static_cast<std::size_t>(cells), -1);
    close_.assign(static_cast<std::size_t>(cells), 0);
    overlay(track, light);
    runsOfCells(cells);
  }
  dropShort();
}
}  // namespace weld_profiler
