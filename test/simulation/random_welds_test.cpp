#include "weld_profiler/simulation/random_welds.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "simulation/oracle.h"
#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
namespace
{
constexpr int kWelds = 200;
constexpr double kRadPerDeg = M_PI / 180.0;

/// Smallest and largest of a quantity over the welds, [mm] or [deg].
struct Span
{
  double low = 1e9, high = -1e9;
  void add(double value)
  {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

void expectSpan(const Span& span, const Span& within, const Span& covered, const std::string& name)
{
  EXPECT_GE(span.low, within.low) << name;
  EXPECT_LE(span.high, within.high) << name;
  EXPECT_LE(span.low, covered.low) << name << " is not covered";
  EXPECT_GE(span.high, covered.high) << name << " is not covered";
}

TEST(RandomWelds, CoverTheirRanges)
{
  std::map<std::string, int> kinds;
  std::map<std::string, Span> span;
  int bent = 0, rippled = 0, splashed = 0;
  for (int seed = 0; seed < kWelds; ++seed)
  {
    const SceneParams scene = randomWeldScene(static_cast<std::uint64_t>(seed));
    const SceneWeld& weld = scene.weld;
    ASSERT_NO_THROW(scene.validate()) << "seed " << seed;
    ++kinds[weld.kind];
    span["width"].add(weld.width * 1e3);
    span[weld.kind == "fillet" ? "convexity" : "reinforcement"].add(weld.reinforcement * 1e3);
    span["misalignment"].add(scene.plates.misalignment * 1e3);
    span["pitch"].add(scene.speed / scene.frame_rate * 1e3);
    const double rise = 0.5 * scene.plates.angle_deg * kRadPerDeg;
    span["undercut"].add(std::max(weld.undercut_left, weld.undercut_right) * std::cos(rise) * 1e3);
    span["undercut width"].add(weld.undercut_width / std::cos(rise) * 1e3);
    for (const double y : { -0.01, 0.01 })
      span["yaw"].add(weld.yaw_deg + weld.curvature * y / kRadPerDeg);
    bent += weld.curvature != 0.0;
    rippled += weld.ripple_height > 0.0;
    splashed += scene.spatter.count > 0;
  }
  for (const char* kind : { "butt", "fillet", "bead_on_plate" })
    EXPECT_NEAR(kinds[kind], kWelds / 3.0, 1.0) << kind;
  expectSpan(span["width"], { 4.0, 20.0 }, { 4.5, 19.5 }, "width");
  expectSpan(span["reinforcement"], { 0.0, 4.0 }, { 0.2, 3.6 }, "reinforcement");
  expectSpan(span["convexity"], { -1.6, 3.6 }, { -0.8, 2.5 }, "convexity");
  expectSpan(span["misalignment"], { -1.0, 1.0 }, { -0.8, 0.8 }, "misalignment");
  expectSpan(span["pitch"], { 0.1, 0.2 }, { 0.105, 0.195 }, "pitch");
  expectSpan(span["undercut"], { 0.0, 0.6001 }, { 0.0, 0.5 }, "undercut");
  expectSpan(span["undercut width"], { 0.8, 2.0 }, { 0.9, 1.9 }, "undercut width");
  expectSpan(span["yaw"], { -20.0, 20.0 }, { -18.0, 18.0 }, "yaw");
  EXPECT_GT(bent, kWelds / 3);
  EXPECT_GT(rippled, kWelds / 2);
  EXPECT_GT(splashed, kWelds / 2);
}

TEST(RandomWelds, HaveFlanksOfAtMostSixtyDegreesAndFreeSegments)
{
  for (int seed = 0; seed < kWelds; ++seed)
  {
    const SceneParams scene = randomWeldScene(static_cast<std::uint64_t>(seed));
    const SceneWeld& weld = scene.weld;
    const double edge = 2.0 * std::atan(2.0 * std::abs(weld.reinforcement) / weld.width);
    const double lean = 2.0 * std::abs(weld.crest_offset) / (1.0 - weld.crest_offset * weld.crest_offset);
    ASSERT_LE(std::atan(std::tan(edge) * (1.0 + lean)), 60.001 * kRadPerDeg) << "seed " << seed;
    if (weld.kind == "butt")
    {
      ASSERT_TRUE(std::abs(scene.plates.misalignment) >= 0.00015 || std::abs(scene.plates.angle_deg) >= 1.0)
          << "seed " << seed << " might as well be one plate";
    }
    ASSERT_LE(weld.ripple_height, 0.1 * weld.ripple_pitch) << "seed " << seed;
    ASSERT_LE(std::abs(scene.plates.misalignment), 0.15 * weld.width + 1e-12) << "seed " << seed;
  }
}

/// Where the section's line, `beyond` metres outside a toe along its plate, is in the image at its own stage position.
Vector2d besideToe(const SimulatedScan& scan, const WeldTruth& section, double side, double beyond)
{
  const std::array<double, 3>& toe = side < 0.0 ? section.toe_left : section.toe_right;
  const double x = toe[0] + side * beyond * std::cos(section.yaw);
  const double y = toe[1] + side * beyond * std::sin(section.yaw);
  return project(scan.calibration().camera, toCamera(scan.calibration(), { x, y, scan.surfaceHeight(x, y) }, y));
}

TEST(RandomWelds, AreInViewWithTheirPlates)
{
  constexpr double kPlate = 0.006;              // level, on either side
  for (int seed = 0; seed < kWelds; seed += 4)  // a scan takes a while to build
  {
    const SimulatedScan scan(randomWeldScene(static_cast<std::uint64_t>(seed)));
    ASSERT_EQ(scan.width(), 1440);
    ASSERT_EQ(scan.height(), 400);
    for (const double y : { 0.0, 0.01, 0.02 })
    {
      const auto section = scan.weldSection(scan.scene().plates.x, y);
      ASSERT_TRUE(section.has_value()) << "seed " << seed << " y " << y;
      for (const double side : { -1.0, 1.0 })
      {
        const Vector2d pixel = besideToe(scan, *section, side, kPlate);
        ASSERT_TRUE(pixel.x() >= 0.0 && pixel.x() <= 1439.0) << "seed " << seed << " column " << pixel.x();
        ASSERT_TRUE(pixel.y() >= 5.0 && pixel.y() <= 394.0) << "seed " << seed << " row " << pixel.y();
      }
    }
    const auto truth = scan.truth(scan.frameCount() / 2);
    const auto visible =
        std::count_if(truth.begin(), truth.end(), [](const TruthCentre& centre) { return centre.visible; });
    ASSERT_GT(visible, 1390) << "seed " << seed;
  }
}

TEST(RandomWelds, AreTheSameForTheSameSeedOnly)
{
  const SceneParams first = randomWeldScene(7), again = randomWeldScene(7), other = randomWeldScene(10);
  EXPECT_EQ(first.weld.width, again.weld.width);
  EXPECT_EQ(first.calibration.camera.roi_y, again.calibration.camera.roi_y);
  EXPECT_EQ(first.speed, again.speed);
  EXPECT_EQ(first.weld.kind, other.weld.kind);
  EXPECT_NE(first.weld.width, other.weld.width);
  EXPECT_EQ(first.seed, 7U);
}
}  // namespace
}  // namespace weld_profiler
