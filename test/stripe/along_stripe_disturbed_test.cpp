// What disturbs the columns of a stripe together: reflectance, speckle, a lopsided profile.
#include <gtest/gtest.h>

#include <cmath>

#include "stripe/along_stripe.h"
#include "stripe/column_moments.h"
#include "support/measured_columns.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::Columns;
using test_support::emptyTrack;
using test_support::Judged;
using test_support::kColumns;
using test_support::lineOf;
using test_support::render;
using test_support::slotOf;
using test_support::straight;
using test_support::StripePicture;
using test_support::trackOf;

TEST(AlongStripeDisturbed, IsNotDisturbedByALopsidedProfile)
{
  Columns even = lineOf(0.0);
  Columns lopsided = even;
  lopsided.lean = 0.4;
  AlongStripe first, second;
  first.join(trackOf(even), 27);
  second.join(trackOf(lopsided), 27);
  for (int u = 1; u < kColumns - 1; ++u)  // at an end a mean over three columns holds two
  {
    ASSERT_GT(second.aperture()[slotOf(u)], 0.0F);
    EXPECT_NEAR(second.row()[slotOf(u)], first.row()[slotOf(u)], 1e-3) << u;
    EXPECT_NEAR(second.sigma()[slotOf(u)], first.sigma()[slotOf(u)], 0.02 * first.sigma()[slotOf(u)]) << u;
  }
}

TEST(AlongStripeDisturbed, DoesNotMoveALopsidedProfileWhereTheFlanksAreUsed)
{
  Columns columns = lineOf(0.0);
  columns.speckle = 0.15;
  columns.lean = 0.4;
  AlongStripe along;
  along.join(trackOf(columns), 27);
  double mean = 0.0;
  Judged judged;
  judged.add(along, columns.row, 40, kColumns - 40);
  ASSERT_EQ(judged.count, kColumns - 80);
  for (int u = 40; u < kColumns - 40; ++u)
    mean += (along.row()[slotOf(u)] - columns.row(u)) / (kColumns - 80);
  EXPECT_LT(judged.error(), 0.6 * columns.speckle / std::sqrt(27.0));  // the flanks were used
  EXPECT_NEAR(mean, 0.0, 5e-3);                                        // half of the flanks would move it by 0.2
}

TEST(AlongStripeDisturbed, TellsALargerSigmaWhereFlanksAndCoreDisagree)
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

TEST(AlongStripeDisturbed, TakesOffWhatReflectanceFeigns)
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

TEST(AlongStripeDisturbed, LooksAtTheFlanksWhereThereIsSpeckle)
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
}  // namespace
}  // namespace weld_profiler
