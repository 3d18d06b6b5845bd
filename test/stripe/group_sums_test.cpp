// One read of the image: sums of 8 neighbouring columns against sums pixel by pixel.
#include "stripe/group_sums.h"

#include <gtest/gtest.h>

#include <random>

#include "support/on_path.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::blank;
using test_support::Picture;

/// Grey levels over the whole range of the container.
Picture randomPicture(int width, int height, int bit_depth)
{
  std::mt19937 random(static_cast<unsigned>(width * 1000 + height + bit_depth));
  std::uniform_int_distribution<int> level(0, bit_depth == 8 ? 255 : 65535);
  Picture picture = blank(width, height, 0.0, bit_depth);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      picture.set(u, v, level(random));
  return picture;
}

/// A sum of 16-bit pixels is kept in 16 bit as their mean, rounded down.
int bruteForce(const Picture& picture, int row, int first_column)
{
  int sum = 0;
  for (int k = 0; k < kGroup; ++k)
    sum += static_cast<int>(picture.at(first_column + k, row));
  return picture.bit_depth == 8 ? sum : sum / kGroup;
}

void expectBruteForce(const Picture& picture, int row_step)
{
  GroupSums sums;
  sums.layOut(picture.view(), row_step);
  ASSERT_EQ(sums.groups(), (picture.width + kGroup - 1) / kGroup);
  ASSERT_EQ(sums.rows(), (picture.height + row_step - 1) / row_step);
  ASSERT_EQ(sums.columns(), picture.width);
  sums.sum(picture.view(), 0, sums.rows());
  for (int i = 0; i < sums.rows(); ++i)
    for (int group = 0; group < sums.groups(); ++group)
      ASSERT_EQ(sums.row(i)[group], bruteForce(picture, i * row_step, sums.firstColumn(group)))
          << "row " << i << " of every " << row_step << ", group " << group << ", width " << picture.width;
}

using GroupSumsTest = test_support::OnEachPath;

TEST_P(GroupSumsTest, AreThoseOfThePixelsForEveryWidth)
{
  // One group, one lane less and more than the vectors' 64, 128 and 256 bytes, and widths that 8 does not divide.
  for (const int width : { 8, 9, 15, 16, 17, 63, 64, 65, 72, 127, 128, 129, 136, 143, 255, 257, 264, 331 })
    for (const int bit_depth : { 8, 16 })
      expectBruteForce(randomPicture(width, 7, bit_depth), 1);
}

TEST_P(GroupSumsTest, AreThoseOfTheRowsThatAreNotSkipped)
{
  for (const int step : { 2, 3, 4, 5 })
    for (const int height : { 1, 5, 24, 31 })
      for (const int bit_depth : { 8, 16 })
        expectBruteForce(randomPicture(83, height, bit_depth), step);
}

TEST_P(GroupSumsTest, OfAWhiteImageDoNotOverflow)
{
  for (const int bit_depth : { 8, 16 })
    expectBruteForce(blank(264, 3, bit_depth == 8 ? 255.0 : 65535.0, bit_depth), 1);
}

TEST_P(GroupSumsTest, LeaveOutTheBytesBetweenTheRows)
{
  const Picture picture = randomPicture(151, 9, 8);
  ImageView part = picture.view();
  part.width = 133;  // the other 18 columns of a row belong to no group
  GroupSums sums;
  sums.layOut(part, 2);
  ASSERT_EQ(sums.groups(), 17);
  ASSERT_EQ(sums.firstColumn(16), 125);
  sums.sum(part, 0, sums.rows());
  for (int i = 0; i < sums.rows(); ++i)
    for (int group = 0; group < sums.groups(); ++group)
      ASSERT_EQ(sums.row(i)[group], bruteForce(picture, 2 * i, sums.firstColumn(group)));
}

TEST_P(GroupSumsTest, TouchOnlyTheRowsAskedFor)
{
  GroupSums sums;
  const Picture dark = blank(100, 20);
  sums.layOut(dark.view(), 1);
  sums.sum(dark.view(), 0, 20);
  const Picture picture = blank(100, 20, 10.0);
  sums.sum(picture.view(), 4, 9, 2);
  for (int i = 0; i < 20; ++i)
  {
    const int expected = i == 4 || i == 6 || i == 8 ? 80 : 0;
    for (int group = 0; group < sums.groups(); ++group)
      ASSERT_EQ(sums.row(i)[group], expected) << "row " << i;
  }
}

TEST_P(GroupSumsTest, TellWhatTheyCount)
{
  for (const int bit_depth : { 8, 16 })
  {
    GroupSums sums;
    const Picture picture = blank(21, 2, 100.0, bit_depth);
    sums.layOut(picture.view(), 1);
    sums.sum(picture.view(), 0, 2);
    EXPECT_FLOAT_EQ(sums.row(1)[2], 100.0F * sums.perLevel());
    EXPECT_FLOAT_EQ(sums.middle(0), 3.5F);
    EXPECT_FLOAT_EQ(sums.middle(2), 16.5F);  // columns 13 to 20: it overlaps its neighbour
  }
}

INSTANTIATE_TEST_SUITE_P(BothPaths, GroupSumsTest, ::testing::Values(VectorPath::Plain, VectorPath::Avx2));
}  // namespace
}  // namespace weld_profiler
