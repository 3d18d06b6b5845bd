// The columns' centres joined along the stripe: noise goes, outline stays, and sigma tells what is left.
#include "stripe/along_stripe.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/measured_columns.h"

namespace weld_profiler
{
namespace
{
using test_support::Columns;
using test_support::Judged;
using test_support::kColumns;
using test_support::lineOf;
using test_support::slotOf;
using test_support::trackOf;

/// Over 30 draws of the noise.
Judged judged(Columns columns, int max_aperture, int begin = 0, int end = kColumns)
{
  Judged judged;
  AlongStripe along;
  for (columns.seed = 1; columns.seed <= 30; ++columns.seed)
  {
    along.join(trackOf(columns), max_aperture);
    judged.add(along, columns.row, begin, end);
  }
  EXPECT_EQ(judged.count, 30 * (end - begin));
  return judged;
}

TEST(AlongStripe, AveragesWhiteNoiseOfAStraightLineOverAllColumnsAllowed)
{
  for (const int aperture : { 3, 9, 27 })
    for (const double degrees : { 0.0, 30.0 })
    {
      const Columns line = lineOf(degrees);
      const Judged result = judged(line, aperture, 50, kColumns - 50);
      const double ideal = line.noise / std::sqrt(static_cast<double>(aperture));
      // 1500 independent means at least: their RMS is known to 2 %. What chance makes of an outline costs the rest.
      EXPECT_GT(result.error(), 0.95 * ideal) << aperture << " columns, " << degrees << " deg";
      EXPECT_LT(result.error(), 1.12 * ideal) << aperture << " columns, " << degrees << " deg";
      EXPECT_GT(result.ratio(), 0.85) << aperture << " columns, " << degrees << " deg";
      EXPECT_LT(result.ratio(), 1.15) << aperture << " columns, " << degrees << " deg";
    }
}

TEST(AlongStripe, TellsOverHowManyColumns)
{
  AlongStripe along;
  for (const int aperture : { 3, 9, 27 })
  {
    along.join(trackOf(lineOf(10.0)), aperture);
    int all = 0;
    for (int u = 20; u < kColumns - 20; ++u)
    {
      ASSERT_GE(along.aperture()[slotOf(u)], 3.0F) << u;
      ASSERT_LE(along.aperture()[slotOf(u)], static_cast<float>(aperture)) << u;
      all += along.aperture()[slotOf(u)] == static_cast<float>(aperture) ? 1 : 0;
    }
    EXPECT_GT(all, 0.9 * (kColumns - 40)) << aperture;
  }
}

TEST(AlongStripe, TellsTheErrorAtTheEndsOfAPiece)
{
  for (const double degrees : { 0.0, 30.0 })
  {
    const Judged ends = judged(lineOf(degrees), 27, kColumns - 14, kColumns);
    EXPECT_LT(ends.error(), lineOf(degrees).noise) << degrees;
    EXPECT_GT(ends.ratio(), 1.0 / 1.5) << degrees;
    EXPECT_LT(ends.ratio(), 1.5) << degrees;
  }
}

TEST(AlongStripe, KeepsANotch)
{
  constexpr double kDepth = 3.0;
  Columns columns;
  columns.reference = [](double) { return 300.0; };
  columns.row = [](double u) { return 300.0 + kDepth * std::exp(-0.5 * std::pow((u - 750.0) / 4.0, 2.0)); };
  AlongStripe along;
  double depth = 0.0;
  for (columns.seed = 1; columns.seed <= 30; ++columns.seed)
  {
    along.join(trackOf(columns), 27);
    depth += (along.row()[slotOf(750)] - 300.0) / 30.0;
  }
  // The mean of 30 draws of three columns: 0.1 %.
  EXPECT_GE(depth, 0.97 * kDepth);
  EXPECT_LE(depth, 1.01 * kDepth);
}

TEST(AlongStripe, TakesOffWhatCurvatureAddsToMeans)
{
  for (const double bend : { 6e-4, -2e-3 })
  {
    Columns columns;
    columns.row = [bend](double u) { return 800.0 + 0.5 * bend * (u - 750.0) * (u - 750.0); };
    // A mean of 27 columns lies 91/3 times the bend off: 0.018 and 0.06 px.
    const Judged result = judged(columns, 27, 400, 1100);
    EXPECT_LT(result.error(), 1.4 * columns.noise / std::sqrt(27.0)) << bend;
    EXPECT_LT(result.ratio(), 1.25) << bend;
  }
}

TEST(AlongStripe, TakesOffWhatStrongCurvatureAddsToMeansOfNine)
{
  Columns columns;
  columns.row = [](double u) { return 800.0 + 0.5 * 0.01 * (u - 750.0) * (u - 750.0); };
  // A mean of 9 columns lies 10/3 times the bend off: 0.033 px.
  const Judged result = judged(columns, 9, 700, 800);
  EXPECT_LT(result.error(), 1.4 * columns.noise / 3.0);
  EXPECT_LT(result.ratio(), 1.25);
}

TEST(AlongStripe, LeavesALineWithHolesWhereItIs)
{
  Columns columns = lineOf(30.0);
  columns.noise = 0.0;
  columns.light_noise = 0.0;
  ColumnTrack track = trackOf(columns);
  const auto dark = [](int u) { return u % 18 < 3 || (u >= 700 && u < 720); };
  for (int u = 0; u < kColumns; ++u)
    if (dark(u))
      track.weight[slotOf(u)] = 0.0F;
  AlongStripe along;
  along.join(track, 27);
  for (int u = 0; u < kColumns; ++u)
  {
    ASSERT_EQ(along.aperture()[slotOf(u)] > 0.0F, !dark(u)) << u;
    if (dark(u))
      continue;
    // Sums of 27 rows of up to 1200 px in single precision.
    EXPECT_NEAR(along.row()[slotOf(u)], columns.row(u), 1e-3) << u;
  }
}

TEST(AlongStripe, DoesNotMixPieces)
{
  constexpr int kShift = kColumns + ColumnTrack::kGuard;
  Columns columns = lineOf(5.0);
  columns.noise = 0.0;
  const ColumnTrack one = trackOf(columns);
  ColumnTrack two = one;
  two.resize(one.slots() + static_cast<std::size_t>(kShift));
  for (int u = 0; u < kColumns; ++u)
    for (std::vector<float>* field :
         { &two.v, &two.sigma, &two.core, &two.flanks, &two.light, &two.spread, &two.weight })
      (*field)[slotOf(u + kShift)] = (*field)[slotOf(u)] + (field == &two.v ? 40.0F : 0.0F);
  two.pieces.push_back(ColumnTrack::Piece{ ColumnTrack::kGuard + kShift, 0, kColumns });
  for (const ColumnTrack::Piece& piece : two.pieces)
    two.layOn(piece);
  AlongStripe along;
  along.join(two, 27);
  for (int u = 0; u < kColumns; ++u)
  {
    ASSERT_GT(along.aperture()[slotOf(u)], 0.0F) << u;
    ASSERT_GT(along.aperture()[slotOf(u + kShift)], 0.0F) << u;
    EXPECT_NEAR(along.row()[slotOf(u)], columns.row(u), 1e-3) << u;
    EXPECT_NEAR(along.row()[slotOf(u + kShift)], columns.row(u) + 40.0, 1e-3) << u;
  }
}

TEST(AlongStripe, MovesTheReferenceLineWhereItIsFarOff)
{
  Columns columns = lineOf(0.0);
  AlongStripe along;
  ColumnTrack near = trackOf(columns);
  along.join(near, 27);
  EXPECT_FALSE(along.moveReference(near));
  EXPECT_EQ(near.v[slotOf(700)], 300.0F);
  columns.row = [](double u) { return u < 700.0 ? 300.0 : 300.0 + std::min(0.6, 0.01 * (u - 700.0)); };
  columns.reference = [](double) { return 300.0; };
  ColumnTrack off = trackOf(columns);
  along.join(off, 27);
  EXPECT_TRUE(along.moveReference(off));
  EXPECT_NEAR(off.v[slotOf(1200)], 300.6, 0.05);  // five sigmas of a mean over 27 columns
  EXPECT_NEAR(off.v[slotOf(300)], 300.0, 0.05);
}

TEST(AlongStripe, SettlesTheReferenceLineOnTheColumns)
{
  Columns columns = lineOf(0.0);
  columns.reference = [](double) { return 299.2; };
  columns.noise = 0.05;
  ColumnTrack track = trackOf(columns);
  for (int u = 0; u < kColumns; ++u)
  {
    track.spread[slotOf(u)] = 1.21F;
    if (u >= 600 && u < 604)
      track.weight[slotOf(u)] = 0.0F;
  }
  AlongStripe along;
  along.settle(track);
  for (int u = 0; u < kColumns; ++u)
  {
    EXPECT_NEAR(track.v[slotOf(u)], 300.0, 0.15) << u;  // five sigmas of a mean over three columns
    EXPECT_NEAR(track.sigma[slotOf(u)], 2.2, 1e-3) << u;
  }
}
}  // namespace
}  // namespace weld_profiler
