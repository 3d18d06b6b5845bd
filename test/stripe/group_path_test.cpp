// The peaks that lie on one line: not the spatter, not the reflection; steps and both of their sides.
#include "stripe/group_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::Picture;
using test_support::render;
using test_support::straight;
using test_support::StripePicture;

constexpr int kWidth = 640;
constexpr int kGroups = kWidth / kGroup;

StripePicture sceneOf(double degrees)
{
  StripePicture scene = straight(degrees, 110.0);
  scene.width = kWidth;
  scene.height = 300;
  scene.peak = 120.0;
  scene.snr = 30.0;
  return scene;
}

std::vector<PathNode> pathOf(const Picture& picture)
{
  GroupSums sums;
  GroupPeaks peaks;
  GroupPath path;
  std::vector<PathNode> nodes;
  sums.layOut(picture.view(), 1);
  sums.sum(picture.view(), 0, sums.rows());
  peaks.find(sums, 8.0F * 8.0F, RowRange{ 0, sums.rows() });
  path.choose(sums, peaks, nodes);
  return nodes;
}

double middleOf(const PathNode& node)
{
  return kGroup * node.group + 0.5 * (kGroup - 1);
}

/// @param tolerance  rows: a top is found to a row, an oblique stripe's anywhere over the group's width.
void expectOnLine(const std::vector<PathNode>& nodes, const StripePicture& scene, double tolerance)
{
  ASSERT_EQ(nodes.size(), static_cast<std::size_t>(kGroups));
  for (int i = 0; i < kGroups; ++i)
  {
    ASSERT_EQ(nodes[i].group, i);
    EXPECT_NEAR(nodes[i].peak.row, scene.row(middleOf(nodes[i])), tolerance) << "group " << i;
  }
}

int piecesOf(const std::vector<PathNode>& nodes)
{
  int pieces = 0;
  for (const PathNode& node : nodes)
    pieces += node.starts_piece ? 1 : 0;
  return pieces;
}

/// A second stripe this many rows below the first, between two columns.
void addSecond(StripePicture& scene, double below, double begin, double end, double peak)
{
  const auto row = scene.row;
  scene.ambient = [=](double u, double v)
  { return u >= begin && u < end ? peak * std::exp(-0.5 * std::pow((v - row(u) - below) / 2.0, 2.0)) : 0.0; };
}

TEST(GroupPath, IsTheStripeLevelOrOblique)
{
  for (const double degrees : { 0.0, -8.0, 15.0 })
  {
    const StripePicture scene = sceneOf(degrees);
    const std::vector<PathNode> nodes = pathOf(render(scene));
    expectOnLine(nodes, scene, 3.0);
    EXPECT_EQ(piecesOf(nodes), 1);
  }
}

TEST(GroupPath, DoesNotFollowSpatter)
{
  const StripePicture scene = sceneOf(5.0);
  Picture picture = render(scene);
  std::mt19937 random(3);
  std::uniform_int_distribution<int> column(10, kWidth - 10);
  std::uniform_int_distribution<int> away(12, 70);
  for (int i = 0; i < 40; ++i)
  {
    const int u0 = column(random);
    const int v0 = static_cast<int>(scene.row(u0)) + (i % 2 == 0 ? away(random) : -away(random));
    for (int v = v0 - 4; v <= v0 + 4; ++v)
      for (int u = u0 - 4; u <= u0 + 4; ++u)
        if ((u - u0) * (u - u0) + (v - v0) * (v - v0) <= 16)
          picture.set(u, v, 255.0);
  }
  const std::vector<PathNode> nodes = pathOf(picture);
  expectOnLine(nodes, scene, 3.0);
  EXPECT_EQ(piecesOf(nodes), 1);
}

TEST(GroupPath, DoesNotFollowABrighterReflectionOverAThirdOfTheLength)
{
  for (const double below : { 25.0, -40.0, 60.0 })
  {
    StripePicture scene = sceneOf(3.0);
    scene.peak = 100.0;
    addSecond(scene, below, 200.0, 420.0, 140.0);
    const std::vector<PathNode> nodes = pathOf(render(scene));
    expectOnLine(nodes, scene, 3.0);
    EXPECT_EQ(piecesOf(nodes), 1) << below;
  }
}

TEST(GroupPath, KeepsAStepAndBothItsSides)
{
  for (const double height : { 45.0, -70.0, 120.0 })
  {
    StripePicture scene = sceneOf(0.0);
    scene.row = [height](double u) { return u < 320.0 ? 140.0 : 140.0 + height; };
    scene.slope = [](double) { return 0.0; };
    const std::vector<PathNode> nodes = pathOf(render(scene));
    expectOnLine(nodes, scene, 1.0);
    EXPECT_EQ(piecesOf(nodes), 2);
    EXPECT_TRUE(nodes[40].starts_piece) << height;
  }
}

TEST(GroupPath, IsTornWhereMoreThanTwoGroupsAreDark)
{
  const auto piecesWithout = [](int dark_groups)
  {
    StripePicture scene = sceneOf(0.0);
    scene.gain = [=](double u) { return u >= 320.0 && u < 320.0 + kGroup * dark_groups ? 0.0 : 1.0; };
    const std::vector<PathNode> nodes = pathOf(render(scene));
    EXPECT_EQ(nodes.size(), static_cast<std::size_t>(kGroups - dark_groups));
    return piecesOf(nodes);
  };
  EXPECT_EQ(piecesWithout(2), 1);
  EXPECT_EQ(piecesWithout(3), 2);
}

TEST(GroupPath, FlagsGroupsWhereASecondPeakIsNearlyAsGood)
{
  StripePicture scene = sceneOf(0.0);
  addSecond(scene, 40.0, 160.0, 320.0, 0.8 * scene.peak);
  const std::vector<PathNode> nodes = pathOf(render(scene));
  expectOnLine(nodes, scene, 1.0);
  for (const PathNode& node : nodes)
    EXPECT_EQ(node.ambiguous, node.group >= 20 && node.group < 40) << "group " << node.group;
}

TEST(GroupPath, DoesNotFlagAFaintSecondPeak)
{
  StripePicture scene = sceneOf(0.0);
  addSecond(scene, 40.0, 160.0, 320.0, 0.3 * scene.peak);
  const std::vector<PathNode> nodes = pathOf(render(scene));
  expectOnLine(nodes, scene, 1.0);
  for (const PathNode& node : nodes)
    EXPECT_FALSE(node.ambiguous) << "group " << node.group;
}

TEST(GroupPath, IsEmptyWithoutPeaks)
{
  EXPECT_TRUE(pathOf(test_support::blank(kWidth, 100, 30.0)).empty());
}

PathNode nodeOf(int group, int height, bool starts)
{
  PathNode node;
  node.group = group;
  node.peak.height = static_cast<std::uint16_t>(height);
  node.starts_piece = starts;
  return node;
}

TEST(GroupPath, LosesLonersThatAreNotBright)
{
  // Three groups of a stripe, a dim and a bright single one, two dim ones side by side.
  std::vector<PathNode> nodes{ nodeOf(0, 100, true), nodeOf(1, 100, false), nodeOf(2, 100, false), nodeOf(9, 20, true),
                               nodeOf(20, 90, true), nodeOf(30, 20, true),  nodeOf(31, 20, false) };
  dropLoners(nodes);
  ASSERT_EQ(nodes.size(), 6U);
  EXPECT_EQ(nodes[3].group, 20);
  EXPECT_EQ(nodes[4].group, 30);
}
}  // namespace
}  // namespace weld_profiler
