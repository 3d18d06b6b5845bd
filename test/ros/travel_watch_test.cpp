#include <gtest/gtest.h>

#include "weld_profiler/ros/travel_watch.h"

namespace weld_profiler
{
namespace
{
Profile at(double stage, bool seen = true)
{
  Profile profile;
  profile.stage = stage;
  if (seen)
    profile.points.resize(1);
  return profile;
}
}  // namespace

TEST(TravelWatch, IsFromTheFirstProfileThatHasAPlace)
{
  TravelWatch watch;
  watch.restart();
  watch.add(at(0.0, false), 0.1);  // before the part comes into view
  watch.add(at(0.300), 0.1);
  watch.add(at(0.302), 0.2);
  const TravelWatch::Travel travel = watch.travel();
  EXPECT_EQ(travel.profiles, 3u);
  EXPECT_DOUBLE_EQ(travel.first, 0.300);
  EXPECT_DOUBLE_EQ(travel.last, 0.302);
  EXPECT_DOUBLE_EQ(travel.age, 0.2);
}

TEST(TravelWatch, RestsWhileOnlyTheEncodersLastDigitMoves)
{
  TravelWatch watch;
  watch.restart();
  watch.add(at(0.1), 0.0);
  const ros::WallTime moved = watch.travel().moved;
  watch.add(at(0.1 + 1e-6), 0.0);
  EXPECT_EQ(watch.travel().moved, moved);
  EXPECT_DOUBLE_EQ(watch.travel().last, 0.1);
  watch.add(at(0.1 - 2e-5), 0.0);
  EXPECT_GE(watch.travel().moved, moved);
  EXPECT_DOUBLE_EQ(watch.travel().last, 0.1 - 2e-5);
}

TEST(TravelWatch, ForgetsWhatWasBefore)
{
  TravelWatch watch;
  watch.restart();
  watch.add(at(0.5), 0.0);
  watch.restart();
  EXPECT_EQ(watch.travel().profiles, 0u);
  watch.add(at(0.2), 0.0);
  EXPECT_DOUBLE_EQ(watch.travel().first, 0.2);
}
}  // namespace weld_profiler
