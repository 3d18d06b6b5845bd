// The columns' centres joined along the stripe: what is noise goes, what is outline stays, and sigma tells what is left.
#include "stripe/along_stripe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "stripe/column_moments.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::Picture;
using test_support::render;
using test_support::straight;
using test_support::StripePicture;

constexpr int kColumns = 1500;

std::size_t slotOf(int u)
{
  return static_cast<std::size_t>(u + ColumnTrack::kGuard);
}

/// One piece without light over so many columns.
ColumnTrack emptyTrack(int columns)
{
  ColumnTrack track;
  track.resize(static_cast<std::size_t>(columns) + 2 * ColumnTrack::kGuard);
  track.pieces.push_back(ColumnTrack::Piece{ ColumnTrack::kGuard, 0, columns });
  return track;
}

/// What ColumnMoments measures of a stripe of sigma 2 px at SNR 50, without an image.
struct Columns
{
  std::function<double(double)> row;        ///< the outline
  std::function<double(double)> reference;  ///< the track's line; empty = the outline
  double noise = 0.026;                     ///< of one column's centre [px]
  double light_noise = 0.0075;              ///< relative
  double lean = 0.0;                        ///< flanks minus core of a lopsided profile [px]
  unsigned seed = 1;
};

ColumnTrack trackOf(const Columns& columns)
{
  std::mt19937 random(columns.seed);
  std::normal_distribution<double> normal;
  ColumnTrack track = emptyTrack(kColumns);
  for (int u = 0; u < kColumns; ++u)
  {
    const std::size_t slot = slotOf(u);
    const double reference = columns.reference ? columns.reference(u) : columns.row(u);
    const double core = columns.row(u) + columns.noise * normal(random) - reference;
    track.v[slot] = static_cast<float>(reference);
    track.sigma[slot] = 2.0F;
    track.core[slot] = static_cast<float>(core);
    // The best weights' error and the difference to any others are not correlated.
    track.flanks[slot] = static_cast<float>(core + columns.lean + 2.0 * columns.noise * normal(random));
    track.light[slot] = static_cast<float>(200.0 * (1.0 + columns.light_noise * normal(random)));
    track.spread[slot] = 1.0F;
    track.weight[slot] = 1.0F;
  }
  track.layOn(track.pieces.front());
  return track;
}

/// RMS of the rows' errors, and of error over the sigma told.
struct Judged
{
  double squares = 0.0, relative = 0.0;
  int count = 0;

  double error() const { return std::sqrt(squares / count); }
  double ratio() const { return std::sqrt(relative / count); }

  /// Columns [begin, end).
  void add(const AlongStripe& along, const std::function<double(double)>& row, int begin, int end)
  {
    for (int u = begin; u < end; ++u)
    {
      const std::size_t slot = slotOf(u);
      if (!(along.aperture()[slot] > 0.0F))
        continue;
      const double error = along.row()[slot] - row(u);
      squares += error * error;
      relative += std::pow(error / along.sigma()[slot], 2.0);
      ++count;
    }
  }
};

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

Columns lineOf(double degrees)
{
  Columns columns;
  const double slope = std::tan(degrees * M_PI / 180.0);
  columns.row = [slope](double u) { return 300.0 + slope * u; };
  return columns;
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
  Columns columns;
  columns.row = [](double u) { return 100.0 + 0.5 * 2e-3 * (u - 750.0) * (u - 750.0) / (1.0 + std::abs(u - 750.0) / 75.0); };
  columns.noise = 0.004;
  // A mean of 27 columns alone would lie 91/3 times 0.002 = 0.06 px off.
  const Judged result = judged(columns, 27, 730, 770);
  EXPECT_LT(result.error(), 0.004);
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
    for (std::vector<float>* field : { &two.v, &two.sigma, &two.core, &two.flanks, &two.light, &two.spread, &two.weight })
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

TEST(AlongStripe, IsNotDisturbedByALopsidedProfile)
{
  Columns even = lineOf(0.0);
  Columns lopsided = even;
  lopsided.lean = 0.4;
  AlongStripe first, second;
  first.join(trackOf(even), 27);
  second.join(trackOf(lopsided), 27);
  for (int u = 0; u < kColumns; ++u)
  {
    ASSERT_GT(second.aperture()[slotOf(u)], 0.0F);
    EXPECT_NEAR(second.row()[slotOf(u)], first.row()[slotOf(u)], 1e-3) << u;
    EXPECT_NEAR(second.sigma()[slotOf(u)], first.sigma()[slotOf(u)], 0.02 * first.sigma()[slotOf(u)]) << u;
  }
}

TEST(AlongStripe, TellsALargerSigmaWhereFlanksAndCoreDisagree)
{
  ColumnTrack track = trackOf(lineOf(0.0));
  for (int u = 500; u < 503; ++u)
    track.flanks[slotOf(u)] += 1.2F;
  AlongStripe along;
  along.join(track, 27);
  const float usual = along.sigma()[slotOf(300)];
  EXPECT_GT(along.sigma()[slotOf(501)], 0.5F);
  EXPECT_LT(along.sigma()[slotOf(480)], 1.3F * usual);
}

/// A rendered stripe, its columns measured about the true line.
ColumnTrack measured(const StripePicture& scene)
{
  ColumnTrack track = emptyTrack(scene.width);
  for (int u = 0; u < scene.width; ++u)
  {
    const double slope = scene.slope(u);
    track.v[slotOf(u)] = static_cast<float>(scene.row(u));
    track.sigma[slotOf(u)] = static_cast<float>(scene.sigma * std::sqrt(1.0 + slope * slope));
    track.background[slotOf(u)] = static_cast<float>(scene.background);
  }
  track.layOn(track.pieces.front());
  ColumnMoments::measure(render(scene).view(), static_cast<float>(scene.peak / scene.snr / std::sqrt(2.0)), track);
  return track;
}

TEST(AlongStripe, TakesOffWhatReflectanceFeigns)
{
  StripePicture scene = straight(45.0, 20.3);
  scene.width = 600;
  scene.height = 650;
  scene.peak = 150.0;
  scene.snr = 50.0;
  scene.gain = [](double u) { return 1.0 + 0.4 * std::sin(2.0 * M_PI * u / 20.0); };
  const ColumnTrack track = measured(scene);
  AlongStripe along;
  along.join(track, 27);
  double squares = 0.0;
  double feigned = 0.0;
  for (int u = 30; u < scene.width - 30; ++u)
  {
    ASSERT_GT(along.aperture()[slotOf(u)], 0.0F) << u;
    squares += std::pow(along.row()[slotOf(u)] - scene.row(u), 2.0);
    feigned += std::pow(track.core[slotOf(u)], 2.0);
  }
  // Without it the columns are off by 0.37 px RMS, most of it reflectance.
  ASSERT_GT(std::sqrt(feigned / (scene.width - 60)), 0.25);
  EXPECT_LT(std::sqrt(squares / (scene.width - 60)), 0.02);
}

TEST(AlongStripe, LooksAtTheFlanksWhereThereIsSpeckle)
{
  double with = 0.0;
  double without = 0.0;
  AlongStripe along;
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    StripePicture scene = straight(0.0, 30.3);
    scene.width = 1200;
    scene.height = 60;
    scene.sigma = 2.5;
    scene.snr = 100.0;
    scene.speckle = 0.2;
    scene.grain_px = 2.0;
    scene.seed = seed;
    ColumnTrack track = measured(scene);
    const auto error = [&]
    {
      along.join(track, 3);
      Judged judged;
      judged.add(along, scene.row, 20, scene.width - 20);
      EXPECT_GT(judged.count, 1100);
      return judged.error();
    };
    with += error();
    track.flanks = track.core;
    without += error();
  }
  EXPECT_LT(with, 0.8 * without);
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
