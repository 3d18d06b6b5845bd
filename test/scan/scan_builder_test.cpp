#include "weld_profiler/scan/scan_builder.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scan/bench.h"
#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

TEST(ScanBuilder, PlacesAProfileOnceItIsBracketed)
{
  Bench bench;
  bench.sample(0, 0.0);
  bench.frame(5 * kMs);
  EXPECT_TRUE(bench.profiles.empty());
  EXPECT_EQ(bench.builder->waiting(), 1u);
  bench.sample(10 * kMs, 0.02);
  ASSERT_EQ(bench.profiles.size(), 1u);
  EXPECT_EQ(bench.builder->waiting(), 0u);
  const Profile& profile = bench.profiles[0];
  EXPECT_EQ(profile.stamp, 5 * kMs);
  EXPECT_EQ(profile.frame, 1u);
  EXPECT_NEAR(profile.stage, 0.01, 1e-15);
  ASSERT_EQ(profile.points.size(), 2u);
  EXPECT_NEAR(profile.points[1].x, 0.001, 1e-9);
  EXPECT_NEAR(profile.points[1].y, 0.01, 1e-9) << "the sensor has gone on by 10 mm";
  EXPECT_NEAR(profile.points[1].z, 0.0, 1e-9);
  EXPECT_NEAR(profile.points[1].sigma, 2e-5 * 0.8660254, 1e-10) << "the spread's share in z, without a sign";
  EXPECT_EQ(bench.balance().rows, 1u);
}

TEST(ScanBuilder, PlacesInOrderOfArrival)
{
  Bench bench;
  bench.frame(5 * kMs);
  bench.frame(15 * kMs);
  bench.frame(25 * kMs);
  bench.sample(0, 0.0);
  for (int i = 1; i < 4; ++i)
    bench.sample(i * 10 * kMs, 0.01 * i);
  ASSERT_EQ(bench.profiles.size(), 3u);
  bench.builder->finish();
  ASSERT_EQ(bench.scans.size(), 1u);
  ASSERT_EQ(bench.scans[0].rows.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(bench.scans[0].rows[i].frame, i + 1);
  EXPECT_EQ(bench.scans[0].frame_id, "part");
}

TEST(ScanBuilder, MakesARowOfNanForAPlacedFrameWithoutAStripe)
{
  Bench bench(timeTrigger());
  bench.sample(0, 0.0);
  bench.sample(20 * kMs, 0.0);
  bench.frame(5 * kMs, 2);
  bench.frame(6 * kMs, 0);
  EXPECT_EQ(bench.balance().rows, 1u);
  EXPECT_EQ(bench.balance().no_stripe, 1u);
  EXPECT_EQ(bench.profiles.size(), 2u);
  EXPECT_EQ(bench.builder->openScan().rows.size(), 2u);
}

TEST(ScanBuilder, CutsTheMetricWindow)
{
  ScanParams params = timeTrigger();
  params.max_x = 0.0005;
  Bench bench(params);
  bench.sample(0, 0.0);
  bench.sample(20 * kMs, 0.0);
  bench.frame(5 * kMs, 2);  // at x 0 and 0.001
  ASSERT_EQ(bench.profiles.size(), 1u);
  ASSERT_EQ(bench.profiles[0].points.size(), 1u);
  EXPECT_EQ(bench.profiles[0].points[0].cell, 0);
}

TEST(ScanBuilder, CutsEachSideOfTheWindow)
{
  const std::vector<std::pair<double ScanParams::*, double>> sides = {
    { &ScanParams::min_x, 0.5 },  { &ScanParams::max_x, -0.5 }, { &ScanParams::min_y, 0.5 },
    { &ScanParams::max_y, -0.5 }, { &ScanParams::min_z, 0.5 },  { &ScanParams::max_z, -0.5 },
  };
  for (const auto& side : sides)
  {
    ScanParams params = timeTrigger();
    params.*side.first = side.second;
    Bench bench(params);
    bench.sample(0, 0.0);
    bench.frame(0);
    ASSERT_EQ(bench.profiles.size(), 1u);
    EXPECT_TRUE(bench.profiles[0].points.empty());
    EXPECT_EQ(bench.balance().rows, 1u) << "the frame showed a stripe, the window cut it";
    EXPECT_EQ(bench.balance().no_stripe, 0u);
  }
}

TEST(ScanBuilder, GivesOutProfilesThatTheTriggerSkips)
{
  Bench bench;
  bench.sample(0, 0.0);
  bench.sample(20 * kMs, 0.0);
  for (int i = 0; i < 5; ++i)
    bench.frame(i * kMs);
  EXPECT_EQ(bench.profiles.size(), 5u);
  EXPECT_EQ(bench.balance().rows, 1u);
  EXPECT_EQ(bench.balance().skipped, 4u);
}

TEST(ScanBuilder, CountsWhyAProfileCannotBePlaced)
{
  Bench bench;
  bench.sample(10 * kMs, 0.0);
  bench.frame(5 * kMs);
  bench.frame(15 * kMs);
  bench.sample(100 * kMs, 0.1);
  bench.frame(105 * kMs);
  bench.sample(110 * kMs, kNan);
  EXPECT_EQ(bench.unplaced("before_first_sample"), 1u);
  EXPECT_EQ(bench.unplaced("encoder_gap"), 1u);
  EXPECT_EQ(bench.unplaced("encoder_not_finite"), 1u);
  EXPECT_TRUE(bench.profiles.empty());
  EXPECT_TRUE(bench.closes());
}

TEST(ScanBuilder, PushesTheOldestOutOfAFullQueue)
{
  ScanParams params;
  params.max_waiting = 3;
  Bench bench(params);
  for (int i = 0; i < 5; ++i)
    bench.frame(i * kMs);
  EXPECT_EQ(bench.builder->waiting(), 3u);
  EXPECT_EQ(bench.unplaced("waiting_too_long"), 2u);
  bench.sample(0, 0.0);
  bench.sample(20 * kMs, 0.2);
  ASSERT_EQ(bench.profiles.size(), 3u);
  EXPECT_EQ(bench.profiles[0].frame, 3u);
  EXPECT_TRUE(bench.closes());
}

TEST(ScanBuilder, GivesUpWhatWaitsWhenTheInputEnds)
{
  Bench bench;
  bench.frame(5 * kMs);
  bench.builder->finish();
  EXPECT_EQ(bench.unplaced("no_encoder"), 1u);
  EXPECT_TRUE(bench.scans.empty()) << "no scan without a row";
  bench.sample(0, 0.0);
  bench.sample(10 * kMs, 0.1);
  bench.frame(6 * kMs);
  bench.frame(12 * kMs);
  bench.builder->finish();
  EXPECT_EQ(bench.unplaced("after_last_sample"), 1u);
  ASSERT_EQ(bench.scans.size(), 1u);
  EXPECT_EQ(bench.scans[0].end, ScanEnd::Stopped);
  EXPECT_EQ(bench.builder->waiting(), 0u);
  EXPECT_TRUE(bench.closes());
  bench.builder->finish();
  EXPECT_EQ(bench.scans.size(), 1u) << "finish twice ends one scan";
}

TEST(ScanBuilder, ClosesTheScanWhenImagesRunBackwards)
{
  Bench bench(timeTrigger());
  for (int i = 0; i <= 10; ++i)
    bench.sample((1000 + i * 10) * kMs, 0.01 * i);
  bench.frame(1050 * kMs);
  bench.frame(1090 * kMs);
  bench.frame(1120 * kMs);  // waits
  bench.frame(10 * kMs);    // a looping bag
  EXPECT_EQ(bench.unplaced("time_backwards"), 1u);
  ASSERT_EQ(bench.scans.size(), 1u);
  EXPECT_EQ(bench.scans[0].rows.size(), 2u);
  EXPECT_EQ(bench.builder->waiting(), 1u) << "not placed by the encoder of the time before";
  bench.sample(0, 0.0);
  bench.sample(20 * kMs, 0.02);
  EXPECT_EQ(bench.builder->openScan().rows.size(), 1u);
  EXPECT_TRUE(bench.closes());
}

TEST(ScanBuilder, ClosesTheScanWhenTheEncoderRunsBackwards)
{
  Bench bench(timeTrigger());
  bench.sample(1000 * kMs, 0.0);
  bench.frame(1000 * kMs);
  bench.frame(1005 * kMs);
  bench.sample(0, 0.0);
  EXPECT_EQ(bench.unplaced("time_backwards"), 1u);
  ASSERT_EQ(bench.scans.size(), 1u);
  bench.frame(1010 * kMs);  // one of the time before that was under way: it must not stop the queue
  bench.sample(20 * kMs, 0.02);
  bench.frame(10 * kMs);
  EXPECT_EQ(bench.unplaced("time_backwards"), 2u);
  EXPECT_EQ(bench.builder->openScan().rows.size(), 1u);
  EXPECT_EQ(bench.scans.size(), 1u);
  EXPECT_TRUE(bench.closes());
}

TEST(ScanBuilder, BeginsFromNothingWithRestart)
{
  Bench bench(timeTrigger());
  bench.sample(0, 0.0);
  bench.frame(0);
  bench.frame(5 * kMs);
  bench.builder->countDropped("queue_full", 3);
  bench.builder->restart();
  EXPECT_EQ(bench.scans.size(), 1u);
  EXPECT_EQ(bench.balance().frames_in, 0u);
  EXPECT_EQ(bench.balance().accounted(), 0u);
  EXPECT_EQ(bench.builder->waiting(), 0u);
  EXPECT_FALSE(bench.encoder->track().empty()) << "encoder samples are measured, not learnt: the next frame needs them";
  EXPECT_TRUE(bench.builder->openScan().empty());
}

TEST(ScanBuilder, DoesNotPlaceByAPoseThatIsNotFinite)
{
  struct NanPoses : PoseSource
  {
    PoseAnswer at(Stamp) override
    {
      PoseAnswer answer;
      answer.kind = PoseAnswer::Kind::Placed;
      answer.pose.cloud_T_camera.translation().x() = kNan;
      return answer;
    }
    void reset() override {}
  };
  ScanBuilder builder(ScanParams{}, std::make_unique<NanPoses>(), "part", {});
  builder.addProfile(SensorProfile{});
  EXPECT_EQ(builder.balance().unplaced.at("pose_not_finite"), 1u);
  EXPECT_TRUE(builder.openScan().empty());
}

TEST(ScanBuilder, RefusesToBeBuiltWrongly)
{
  ScanParams params;
  params.max_rows = 0;
  EXPECT_THROW(Bench{ params }, ConfigError);
  EXPECT_THROW(ScanBuilder(ScanParams{}, nullptr, "part", {}), PreconditionError);
}
