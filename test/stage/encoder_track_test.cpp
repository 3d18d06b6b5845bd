#include "weld_profiler/stage/encoder_track.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "weld_profiler/core/errors.h"

using namespace weld_profiler;
using Kind = PoseAnswer::Kind;

namespace
{
constexpr Stamp kMs = 1000000;
constexpr Stamp kStart = 1700000000LL * 1000000000LL;  // as a wall clock counts: differences must keep their digits
const double kNan = std::numeric_limits<double>::quiet_NaN();

EncoderTrack track(double max_gap = 0.05, int max_samples = 20000)
{
  EncoderParams params;
  params.max_encoder_gap = max_gap;
  params.max_samples = max_samples;
  return EncoderTrack(params);
}

void expectNever(const EncoderTrack::Answer& answer, const std::string& reason)
{
  EXPECT_EQ(answer.kind, Kind::Never);
  EXPECT_EQ(answer.reason, reason);
}

void expectPlaced(const EncoderTrack::Answer& answer, double position)
{
  ASSERT_EQ(answer.kind, Kind::Placed) << answer.reason;
  EXPECT_NEAR(answer.position, position, 1e-15);
}

void expectWait(const EncoderTrack::Answer& answer, const std::string& reason)
{
  EXPECT_EQ(answer.kind, Kind::Wait);
  EXPECT_EQ(answer.reason, reason);
}
}  // namespace

TEST(EncoderTrack, WaitsWithoutAnySample)
{
  expectWait(track().at(kStart), unplaced::kNoEncoder);
}

TEST(EncoderTrack, InterpolatesBetweenTheTwoSamplesAroundTheStamp)
{
  EncoderTrack t = track();
  t.add(kStart, 0.1);
  t.add(kStart + 10 * kMs, 0.2);
  t.add(kStart + 20 * kMs, 0.0);
  expectPlaced(t.at(kStart + 1 * kMs), 0.11);
  expectPlaced(t.at(kStart + 9 * kMs), 0.19);
  expectPlaced(t.at(kStart + 15 * kMs), 0.1);
}

TEST(EncoderTrack, FollowsALineExactlyAtRandomTimes)
{
  EncoderTrack t = track();
  std::mt19937 generator(3);
  std::uniform_int_distribution<Stamp> interval(1, 40 * kMs);
  std::vector<Stamp> stamps{ kStart };
  for (int i = 0; i < 1000; ++i)
    stamps.push_back(stamps.back() + interval(generator));
  const auto line = [](Stamp stamp) { return 0.005 * toSeconds(stamp - kStart) - 0.02; };
  for (const Stamp stamp : stamps)
    t.add(stamp, line(stamp));
  std::uniform_int_distribution<Stamp> anywhere(stamps.front(), stamps.back());
  for (int i = 0; i < 1000; ++i)
  {
    const Stamp stamp = anywhere(generator);
    const EncoderTrack::Answer answer = t.at(stamp);
    ASSERT_EQ(answer.kind, Kind::Placed);
    EXPECT_NEAR(answer.position, line(stamp), 1e-14);
  }
}

TEST(EncoderTrack, NeverExtrapolates)
{
  EncoderTrack t = track();
  t.add(kStart, 0.1);
  t.add(kStart + 10 * kMs, 0.2);
  expectNever(t.at(kStart - 1), unplaced::kBeforeFirstSample);
  expectWait(t.at(kStart + 10 * kMs + 1), unplaced::kAfterLastSample);
  t.add(kStart + 20 * kMs, 0.3);
  EXPECT_EQ(t.at(kStart + 10 * kMs + 1).kind, Kind::Placed) << "placed once it is bracketed";
}

TEST(EncoderTrack, IsPlacedByASampleExactlyAtTheStamp)
{
  EncoderTrack t = track();
  t.add(kStart, 0.1);
  expectPlaced(t.at(kStart), 0.1);
  t.add(kStart + 5000 * kMs, 0.2);  // far behind a gap
  expectPlaced(t.at(kStart), 0.1);
  expectPlaced(t.at(kStart + 5000 * kMs), 0.2);
}

TEST(EncoderTrack, DoesNotPlaceWithinAGap)
{
  EncoderTrack t = track(0.05);
  t.add(kStart, 0.0);
  t.add(kStart + 50 * kMs, 0.1);
  t.add(kStart + 100 * kMs + 1, 0.2);
  t.add(kStart + 110 * kMs, 0.3);
  EXPECT_EQ(t.at(kStart + 25 * kMs).kind, Kind::Placed) << "as wide as allowed";
  expectNever(t.at(kStart + 75 * kMs), unplaced::kEncoderGap);
  EXPECT_EQ(t.at(kStart + 105 * kMs).kind, Kind::Placed) << "behind the gap it goes on";
}

TEST(EncoderTrack, DoesNotPlaceBesideASampleThatIsNotFinite)
{
  for (const double bad : { kNan, std::numeric_limits<double>::infinity() })
  {
    EncoderTrack t = track();
    t.add(kStart, 0.1);
    t.add(kStart + 10 * kMs, bad);
    t.add(kStart + 20 * kMs, 0.3);
    t.add(kStart + 30 * kMs, 0.4);
    expectNever(t.at(kStart + 5 * kMs), unplaced::kEncoderNotFinite);
    expectNever(t.at(kStart + 10 * kMs), unplaced::kEncoderNotFinite);
    expectNever(t.at(kStart + 15 * kMs), unplaced::kEncoderNotFinite);
    expectPlaced(t.at(kStart + 25 * kMs), 0.35);
    expectPlaced(t.at(kStart), 0.1);
    EXPECT_TRUE(std::isfinite(t.speed()));
  }
}

TEST(EncoderTrack, ForgetsWhatWasBeforeTimeRanBackwards)
{
  EncoderTrack t = track();
  EXPECT_TRUE(t.add(kStart, 0.1));
  EXPECT_TRUE(t.add(kStart + 10 * kMs, 0.2));
  const Stamp again = kStart - 1000 * kMs;
  EXPECT_FALSE(t.add(again + 5 * kMs, 0.7));
  EXPECT_EQ(t.size(), 1u);
  expectNever(t.at(again + 2 * kMs), unplaced::kBeforeFirstSample);
  expectWait(t.at(again + 9 * kMs), unplaced::kAfterLastSample);
  EXPECT_TRUE(t.add(again + 15 * kMs, 0.8));
  expectPlaced(t.at(again + 10 * kMs), 0.75);
}

TEST(EncoderTrack, LeavesOutASampleThatCameLateOnItsWay)
{
  EncoderTrack t = track();
  EXPECT_TRUE(t.add(kStart, 0.1));
  EXPECT_TRUE(t.add(kStart + 10 * kMs, 0.2));
  EXPECT_TRUE(t.add(kStart + 5 * kMs, 0.9)) << "5 ms late is no looping bag";
  EXPECT_EQ(t.size(), 2u);
  expectPlaced(t.at(kStart + 5 * kMs), 0.15);
}

TEST(EncoderTrack, TakesTheLaterOfTwoSamplesOfOneStamp)
{
  EncoderTrack t = track();
  t.add(kStart, 0.1);
  EXPECT_TRUE(t.add(kStart, 0.3)) << "time stood still, it did not run backwards";
  t.add(kStart + 10 * kMs, 0.5);
  EXPECT_EQ(t.size(), 2u);
  expectPlaced(t.at(kStart), 0.3);
  expectPlaced(t.at(kStart + 5 * kMs), 0.4);
}

TEST(EncoderTrack, RemembersNoMoreThanItMay)
{
  EncoderTrack t = track(0.05, 10);
  for (int i = 0; i < 1000; ++i)
    t.add(kStart + i * kMs, i);
  EXPECT_EQ(t.size(), 10u);
  expectPlaced(t.at(kStart + 990 * kMs), 990.0);
  expectNever(t.at(kStart + 989 * kMs), unplaced::kBeforeFirstSample);
}

TEST(EncoderTrack, KnowsSpeedOverTheLastFiftyMilliseconds)
{
  EncoderTrack t = track();
  EXPECT_EQ(t.speed(), 0.0);
  t.add(kStart, 5.0);
  EXPECT_EQ(t.speed(), 0.0);
  for (int i = 1; i <= 100; ++i)  // fast at first, 5 mm/s from 40 ms before the end
    t.add(kStart + i * 2 * kMs, 5.0 + (i < 70 ? 1.0 * i : 70.0 + 1e-5 * (i - 70)));
  EXPECT_NEAR(t.speed(), 5e-3, 1e-9);
  EXPECT_EQ(t.latestStamp(), kStart + 200 * kMs);
  EXPECT_NEAR(t.latestPosition(), 75.0003, 1e-12);
}

TEST(EncoderTrack, KnowsSpeedFromTwoSamplesFarApart)
{
  EncoderTrack t = track();
  t.add(kStart, 1.0);
  t.add(kStart + 2000 * kMs, 0.9);
  EXPECT_NEAR(t.speed(), -0.05, 1e-12) << "negative when the stage goes back";
}

TEST(EncoderTrack, IsEmptyAfterReset)
{
  EncoderTrack t = track();
  t.add(kStart, 1.0);
  t.reset();
  EXPECT_TRUE(t.empty());
  EXPECT_EQ(t.latestStamp(), 0);
  EXPECT_EQ(t.latestPosition(), 0.0);
  expectWait(t.at(kStart), unplaced::kNoEncoder);
  EXPECT_TRUE(t.add(kStart - 10 * kMs, 1.0)) << "an earlier time is no step backwards now";
}

TEST(EncoderParams, RefuseAGapOutOfRange)
{
  for (const double bad : { 0.0, -0.05, 11.0, kNan, std::numeric_limits<double>::infinity() })
    try
    {
      track(bad);
      FAIL() << bad;
    }
    catch (const ConfigError& error)
    {
      EXPECT_NE(std::string(error.what()).find("max_encoder_gap"), std::string::npos);
    }
}

TEST(EncoderParams, RefuseToRememberFewerThanTwoSamples)
{
  for (const int bad : { 1, 0, -5, 10000001 })
    EXPECT_THROW(track(0.05, bad), ConfigError) << bad;
}
