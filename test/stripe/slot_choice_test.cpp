// Which piece of a track speaks for a cell.
#include "stripe/slot_choice.h"

#include <gtest/gtest.h>

namespace weld_profiler
{
namespace
{
/// A track of pieces, and light in all of their slots.
struct Pieces
{
  ColumnTrack track;
  std::vector<float> light;

  void add(int cell, int count, float brightness)
  {
    const int slot = static_cast<int>(light.size()) + ColumnTrack::kGuard;
    track.pieces.push_back({ slot, cell, count });
    light.resize(static_cast<std::size_t>(slot), 0.0F);
    light.resize(static_cast<std::size_t>(slot + count), brightness);
  }

  float& at(std::size_t piece, int cell)
  {
    return light[static_cast<std::size_t>(track.pieces[piece].slot + cell - track.pieces[piece].cell)];
  }
};

constexpr int kCells = 60;

struct Chosen
{
  int cell, slot;
  bool starts_piece, ambiguous;
};

/// What was chosen, cell by cell.
std::vector<Chosen> chosen(const Pieces& pieces)
{
  SlotChoice choice;
  choice.choose(pieces.track, pieces.light, kCells);
  std::vector<Chosen> cells;
  for (const SlotChoice::Run& run : choice.runs())
    for (int k = 0; k < run.count; ++k)
      cells.push_back({ run.cell + k, run.slot + k, run.starts_piece && k == 0, run.ambiguous });
  EXPECT_EQ(choice.size(), cells.size());
  return cells;
}

TEST(SlotChoice, LetsTheBrighterOfTwoPiecesSpeakAndFlagsACloseCall)
{
  for (const float second : { 90.0F, 30.0F, 120.0F })
  {
    Pieces pieces;
    pieces.add(5, 20, 100.0F);
    pieces.add(15, 20, second);
    const std::vector<Chosen> cells = chosen(pieces);
    ASSERT_EQ(cells.size(), 30U);
    for (std::size_t i = 0; i < 30; ++i)
    {
      const Chosen& slot = cells[i];
      const bool both = slot.cell >= 15 && slot.cell < 25;
      ASSERT_EQ(slot.cell, 5 + static_cast<int>(i));
      const bool later = slot.cell >= 25 || (both && second > 100.0F);
      EXPECT_EQ(slot.slot - slot.cell, pieces.track.pieces[later].slot - pieces.track.pieces[later].cell);
      EXPECT_EQ(slot.ambiguous, both && second > 50.0F) << "cell " << slot.cell;
      EXPECT_EQ(slot.starts_piece, i == 0 || slot.cell == (second > 100.0F ? 15 : 25)) << "cell " << slot.cell;
    }
  }
}

TEST(SlotChoice, DropsFewerThanFiveCellsBetweenGapsOfMoreThanThree)
{
  for (const int length : { 4, 5 })
  {
    Pieces pieces;
    pieces.add(0, 50, 100.0F);
    for (int cell = 10; cell < 40; ++cell)
      pieces.at(0, cell) = cell >= 20 && cell < 20 + length ? 100.0F : 0.0F;
    const std::vector<Chosen> cells = chosen(pieces);
    ASSERT_EQ(cells.size(), length < 5 ? 20U : 25U);
    for (const Chosen& slot : cells)
      EXPECT_EQ(slot.starts_piece, slot.cell == 0 || slot.cell == 20 || slot.cell == 40) << "cell " << slot.cell;
  }
}

TEST(SlotChoice, BridgesThreeMissingCells)
{
  Pieces pieces;
  pieces.add(0, 20, 100.0F);
  for (int cell = 8; cell < 11; ++cell)
    pieces.at(0, cell) = 0.0F;
  const std::vector<Chosen> cells = chosen(pieces);
  ASSERT_EQ(cells.size(), 17U);
  for (std::size_t i = 1; i < 17; ++i)
    EXPECT_FALSE(cells[i].starts_piece);
}
}  // namespace
}  // namespace weld_profiler
