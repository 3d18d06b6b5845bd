// Tops that stand out of their own surroundings, whatever light lies under them.
#include "stripe/group_peaks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/on_path.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::blank;
using test_support::OnPath;
using test_support::Picture;
using test_support::render;
using test_support::straight;
using test_support::StripePicture;

struct Found
{
  GroupSums sums;
  GroupPeaks peaks;
};

constexpr float kLeastHeight = 8.0F * 8.0F;  // of 8 grey levels

void find(const Picture& picture, Found& found, int row_step = 1)
{
  found.sums.layOut(picture.view(), row_step);
  found.sums.sum(picture.view(), 0, found.sums.rows());
  found.peaks.find(found.sums, kLeastHeight, RowRange{ 0, found.sums.rows() });
}

StripePicture levelStripe(double row, double peak)
{
  StripePicture stripe = straight(0.0, row);
  stripe.width = 200;
  stripe.height = 320;
  stripe.peak = peak;
  return stripe;
}

/// One peak a group, at the row and as high as said.
void expectOne(const Found& found, int row, double height, double tolerance)
{
  ASSERT_EQ(found.sums.groups(), 25);
  for (int group = 0; group < found.sums.groups(); ++group)
  {
    ASSERT_EQ(found.peaks.size(group), 1) << "group " << group;
    EXPECT_NEAR(found.peaks.at(group, 0).row, row, 1) << "group " << group;
    EXPECT_NEAR(found.peaks.at(group, 0).height / found.sums.perLevel(), height, tolerance) << "group " << group;
  }
}

void expectNone(const Found& found)
{
  ASSERT_GT(found.sums.groups(), 0);
  for (int group = 0; group < found.sums.groups(); ++group)
    EXPECT_EQ(found.peaks.size(group), 0) << "group " << group;
}

using GroupPeaksTest = test_support::OnEachPath;

TEST_P(GroupPeaksTest, AreTheStripeOnALevelBackground)
{
  Found found;
  find(render(levelStripe(140.0, 60.0)), found);
  expectOne(found, 140, 60.0, 0.5);
  find(render(levelStripe(140.0, 60.0)), found, 4);
  expectOne(found, 35, 60.0, 0.5);
}

TEST_P(GroupPeaksTest, StandOutOverAGlow)
{
  StripePicture scene = levelStripe(120.0, 30.0);
  scene.ambient = [](double /*u*/, double v) { return 150.0 * std::exp(-0.5 * std::pow((v - 160.0) / 70.0, 2.0)); };
  Found found;
  find(render(scene), found);
  ASSERT_EQ(found.sums.groups(), 25);
  for (int group = 0; group < found.sums.groups(); ++group)
  {
    int seen = 0;
    for (int i = 0; i < found.peaks.size(group); ++i)
      seen += std::abs(found.peaks.at(group, i).row - 120) <= 2 ? 1 : 0;
    EXPECT_EQ(seen, 1) << "group " << group;
  }
}

TEST_P(GroupPeaksTest, StandOutOverAGradient)
{
  StripePicture scene = levelStripe(160.0, 40.0);
  scene.ambient = [](double /*u*/, double v) { return 0.5 * v; };
  Found found;
  find(render(scene), found);
  // Seen from the brighter side: what lies a few rows above the foot of 3 sigmas costs 3 levels and more.
  expectOne(found, 160, 36.0, 2.5);
}

TEST_P(GroupPeaksTest, AreNotAGradientNorTheEdgeOfABrightPart)
{
  StripePicture scene = levelStripe(-500.0, 40.0);
  scene.ambient = [](double /*u*/, double v) { return 0.7 * v; };
  Found found;
  find(render(scene), found);
  expectNone(found);
  scene.ambient = [](double /*u*/, double v) { return v < 150.0 ? 20.0 : 200.0; };
  find(render(scene), found);
  expectNone(found);
}

/// A flat top with a dip that leaves a share of its height.
StripePicture tornStripe(double left)
{
  StripePicture scene = levelStripe(150.0, 120.0);
  scene.profile = [left](double d)
  { return std::exp(-0.5 * std::pow(d / 6.0, 4.0)) * (1.0 - (1.0 - left) * std::exp(-0.5 * std::pow(d / 1.5, 2.0))); };
  return scene;
}

TEST_P(GroupPeaksTest, TornBySpeckleAreOne)
{
  Found found;
  find(render(tornStripe(0.7)), found);
  expectOne(found, 147, 105.0, 10.0);  // the higher of the two tops
}

TEST_P(GroupPeaksTest, WithADeepValleyBetweenAreTwo)
{
  Found found;
  find(render(tornStripe(0.4)), found);
  ASSERT_EQ(found.sums.groups(), 25);
  for (int group = 0; group < found.sums.groups(); ++group)
  {
    ASSERT_EQ(found.peaks.size(group), 2) << "group " << group;
    EXPECT_LT(found.peaks.at(group, 0).row, 150);
    EXPECT_GT(found.peaks.at(group, 1).row, 150);
  }
}

TEST_P(GroupPeaksTest, KeptAreTheEightHighestInRisingRows)
{
  // Heights of 12 stripes; the eight from 45 on are kept.
  const int heights[] = { 50, 30, 90, 20, 70, 45, 120, 40, 60, 35, 150, 80 };
  StripePicture scene = levelStripe(-500.0, 40.0);
  scene.height = 400;
  scene.ambient = [&](double /*u*/, double v)
  {
    double light = 0.0;
    for (int i = 0; i < 12; ++i)
      light += heights[i] * std::exp(-0.5 * std::pow((v - 25.0 - 30.0 * i) / 2.0, 2.0));
    return light;
  };
  Found found;
  find(render(scene), found);
  ASSERT_EQ(found.sums.groups(), 25);
  for (int group = 0; group < found.sums.groups(); ++group)
  {
    ASSERT_EQ(found.peaks.size(group), GroupPeaks::kMost);
    int k = 0;
    for (int i = 0; i < 12; ++i)
    {
      if (heights[i] < 45)
        continue;
      EXPECT_EQ(found.peaks.at(group, k++).row, 25 + 30 * i) << "group " << group;
    }
    EXPECT_EQ(k, GroupPeaks::kMost);
  }
}

TEST_P(GroupPeaksTest, LowerThanWantedDoNotCount)
{
  Found found;
  find(render(levelStripe(140.0, 7.0)), found);
  expectNone(found);
  find(render(levelStripe(140.0, 9.5)), found);
  expectOne(found, 140, 9.5, 0.5);
}

TEST_P(GroupPeaksTest, LieInTheRowsThatAreSearched)
{
  const Picture picture = render(levelStripe(140.0, 60.0));
  Found found;
  found.sums.layOut(picture.view(), 1);
  found.sums.sum(picture.view(), 0, found.sums.rows());
  found.peaks.find(found.sums, kLeastHeight, RowRange{ 90, 200 });
  expectOne(found, 140, 60.0, 0.5);
  found.peaks.find(found.sums, kLeastHeight, RowRange{ 150, 320 });
  expectNone(found);
}

TEST_P(GroupPeaksTest, OutsideTheRowsOfTheLastStripeAreNoticed)
{
  Picture picture = render(levelStripe(140.0, 60.0));
  GroupSums sums;
  const auto rises = [&](const RowRange& rows)
  {
    sums.layOut(picture.view(), 1);
    sums.sum(picture.view(), 0, sums.rows());
    return GroupPeaks::risesOutside(sums, kLeastHeight, rows);
  };
  EXPECT_FALSE(rises(RowRange{ 91, 190 }));
  EXPECT_FALSE(rises(RowRange{ 0, 320 }));
  EXPECT_TRUE(rises(RowRange{ 150, 320 }));
  EXPECT_TRUE(rises(RowRange{ 0, 130 }));
  for (int u = 197; u < 200; ++u)  // a few pixels of the last group, above and below
    picture.set(u, 300, 200.0);
  EXPECT_TRUE(rises(RowRange{ 91, 190 }));
  EXPECT_FALSE(rises(RowRange{ 91, 302 }));
}

INSTANTIATE_TEST_SUITE_P(BothPaths, GroupPeaksTest, ::testing::Values(VectorPath::Plain, VectorPath::Avx2));

TEST(GroupPeaks, AreTheSameOnBothPaths)
{
  if (widestVectorPath() == VectorPath::Plain)
    GTEST_SKIP() << "this processor has one path";
  std::mt19937 random(5);
  std::uniform_int_distribution<int> level(0, 255);
  Picture picture = blank(267, 300);
  for (int v = 0; v < picture.height; ++v)
    for (int u = 0; u < picture.width; ++u)
      picture.set(u, v, level(random));
  const auto findOn = [&](VectorPath path, Found& found)
  {
    const OnPath on(path);
    find(picture, found);
  };
  Found plain, wide;
  findOn(VectorPath::Plain, plain);
  findOn(widestVectorPath(), wide);
  int count = 0;
  ASSERT_EQ(plain.sums.groups(), 34);
  for (int group = 0; group < 34; ++group)
  {
    ASSERT_EQ(plain.peaks.size(group), wide.peaks.size(group)) << "group " << group;
    for (int i = 0; i < plain.peaks.size(group); ++i, ++count)
    {
      EXPECT_EQ(plain.peaks.at(group, i).row, wide.peaks.at(group, i).row);
      EXPECT_EQ(plain.peaks.at(group, i).top, wide.peaks.at(group, i).top);
      EXPECT_EQ(plain.peaks.at(group, i).height, wide.peaks.at(group, i).height);
    }
  }
  EXPECT_GT(count, 34);  // there was something to compare
}
}  // namespace
}  // namespace weld_profiler
