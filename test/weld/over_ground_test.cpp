#include <gtest/gtest.h>

#include "weld/ground_weld.h"
#include "weld_profiler/weld/scan_comparison.h"

namespace weld_profiler
{
namespace
{
/// A weld of 8 mm, ground flush, with dips.
class Ground
{
public:
  explicit Ground(const IdealWeld& weld = IdealWeld()) : weld_(weld) {}

  ScanComparison compared(const std::vector<Dip>& dips, const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity(),
                          const CompareParams& params = CompareParams()) const
  {
    IdealWeld flush = weld_;
    flush.height = 1e-9;
    const auto after = [&](double x, double y)
    {
      double z = flush(x, y);
      for (const Dip& dip : dips)
        z -= dip(x, y);
      return z;
    };
    return ScanComparer(WeldParams(), params).compare(IdealScanner()(weld_), moved(longerScanner(31)(after), motion));
  }

private:
  IdealWeld weld_;
};

/// Of the points whose number is set: x from, x to, y from, y to.
std::array<double, 4> boxOf(const ScanComparison& comparison, float number)
{
  const IdealScanner scanner;
  std::array<double, 4> box{ { 1.0, -1.0, 1.0, -1.0 } };
  for (std::size_t i = 0; i < comparison.spot.size(); ++i)
  {
    if (comparison.spot[i] != number)
      continue;
    const std::size_t row = i / 1000u;
    const double x = (static_cast<double>(i % 1000u) - 500.0) * scanner.spacing;
    const double y = static_cast<double>(row) * scanner.pitch;
    box = { { std::min(box[0], x), std::max(box[1], x), std::min(box[2], y), std::max(box[3], y) } };
  }
  return box;
}
}  // namespace

TEST(OverGround, FindsAGougeInTheWeldAndOneInThePlate)
{
  const Dip deep{ 0.001, 0.004, 0.0008, 1.5e-4 }, shallow{ -0.009, 0.008, 0.0012, 6e-5 };
  const ScanComparison comparison = Ground().compared({ shallow, deep });
  ASSERT_EQ(comparison.over_ground.size(), 2u);
  const OverGroundSpot &first = comparison.over_ground[0], &second = comparison.over_ground[1];
  EXPECT_NEAR(first.depth.value, deep.depth, 5e-6) << "deepest first";
  EXPECT_LT(std::abs(first.depth.value - deep.depth), 4.0 * first.depth.sigma);
  EXPECT_NEAR(first.x, deep.x, deep.radius) << "on its floor";
  EXPECT_NEAR(first.y, deep.y, deep.radius);
  EXPECT_NEAR(first.s, deep.y, deep.radius);
  // the slope is 0.05 mm below the target at two thirds of its 0.4 mm
  EXPECT_NEAR(first.area, M_PI * std::pow(deep.radius + 4e-4 * (1.0 - 0.05 / 0.15), 2.0), 0.2 * first.area);
  EXPECT_NEAR(second.depth.value, shallow.depth, 5e-6);
  EXPECT_NEAR(second.x, shallow.x, shallow.radius);
  const std::array<double, 4> box = boxOf(comparison, 1.0F);
  EXPECT_NEAR(box[0], deep.x - 0.00107, 3e-4) << "the map shows where";
  EXPECT_NEAR(box[1], deep.x + 0.00107, 3e-4);
  EXPECT_NEAR(box[2], deep.y - 0.00107, 3e-4);
  EXPECT_NEAR(box[3], deep.y + 0.00107, 3e-4);
}

TEST(OverGround, FortyMicrometresAreNotOverTheLimitOfFifty)
{
  const Dip dip{ 0.001, 0.004, 0.0015, 4e-5 };
  EXPECT_TRUE(Ground().compared({ dip }).over_ground.empty());
  CompareParams fine;
  fine.over_ground_limit = 3e-5;
  EXPECT_EQ(Ground().compared({ dip }, Eigen::Isometry3d::Identity(), fine).over_ground.size(), 1u);
}

TEST(OverGround, FindsTheGougeWhereverThePartWasPutBack)
{
  const Dip dip{ 0.001, 0.005, 0.0012, 1.2e-4 };
  const Eigen::Isometry3d motion = motionAbout({ 0.0, 0.006, 0.0 }, { 5e-4, -4e-4, 1e-3 }, { 0.8, -1.1, 0.4 });
  const ScanComparison comparison = Ground().compared({ dip }, motion);
  ASSERT_EQ(comparison.over_ground.size(), 1u);
  EXPECT_NEAR(comparison.over_ground.front().depth.value, dip.depth, 6e-6);
  EXPECT_NEAR(comparison.over_ground.front().x, dip.x, dip.radius + 1e-3) << "nothing tells the shift along a plate";
}

TEST(OverGround, AnUndercutThatWasThereBeforeIsNone)
{
  IdealWeld weld;
  weld.undercut = 0.0003;
  const Ground ground(weld);
  for (const Eigen::Isometry3d& motion :
       { Eigen::Isometry3d::Identity(), motionAbout({ 0.0, 0.006, 0.0 }, { 4e-4, 3e-4, 0.0 }, { 0.0, 0.0, 0.3 }) })
  {
    const ScanComparison comparison = ground.compared({}, motion);
    EXPECT_TRUE(comparison.over_ground.empty());
    bool noted = false;
    for (const std::string& note : comparison.notes)
      noted = noted || note.find("did so before grinding") != std::string::npos;
    EXPECT_TRUE(noted) << "but it is said that it lies there";
  }
  const Dip dip{ 0.0045, 0.006, 0.0015, 1e-4 };
  EXPECT_FALSE(ground.compared({ dip }).over_ground.empty()) << "an undercut that was ground deeper is";
  CompareParams clamped;  // the part has not been taken out: the undercut's walls are where they were
  clamped.placement = 2e-5, clamped.placement_turn_deg = 0.02;
  EXPECT_EQ(ground.compared({ dip }, Eigen::Isometry3d::Identity(), clamped).over_ground.size(), 1u);
}

TEST(OverGround, SpatterThatCameOffAnUndercutLeavesNone)
{
  IdealWeld weld;
  weld.undercut = 0.0003;
  const auto spattered = [&weld](double x, double y)
  {
    double z = weld(x, y);
    for (const double ball_x : { 0.0045, 0.010 })
    {
      const double rest = 1.6e-7 - std::pow(x - ball_x, 2.0) - std::pow(y - 0.006, 2.0);
      z = rest > 0.0 ? std::max(z, std::sqrt(rest) - 1e-4) : z;
    }
    return z;
  };
  const Scan before = IdealScanner()(spattered);
  weld.height = 1e-9;
  CompareParams clamped;
  clamped.placement = 2e-5, clamped.placement_turn_deg = 0.02;
  const ScanComparer comparer(WeldParams(), clamped);
  const ScanComparison clean = comparer.compare(before, longerScanner(33)(weld));
  EXPECT_TRUE(clean.over_ground.empty());
  const Dip gouge{ 0.010, 0.006, 0.0004, 1.5e-4 };
  const auto deeper = [&](double x, double y) { return weld(x, y) - gouge(x, y); };
  EXPECT_EQ(comparer.compare(before, longerScanner(33)(deeper)).over_ground.size(), 1u)
      << "under the ball on the plate";
}

TEST(OverGround, NoiseIsNoGouge)
{
  IdealWeld weld;
  IdealScanner noisy = longerScanner(40);
  noisy.noise = 2.5e-5;
  const Scan before = IdealScanner()(weld);
  weld.height = 1e-9;
  const ScanComparison comparison = ScanComparer().compare(before, noisy(weld));
  EXPECT_TRUE(comparison.over_ground.empty()) << comparison.over_ground.size();
  EXPECT_NEAR(comparison.remaining_volume.value, 0.0, 3.0 * comparison.remaining_volume.sigma);
}

TEST(OverGround, SmallPlacesAreLeftOut)
{
  const Dip dip{ 0.001, 0.005, 0.0006, 1.2e-4 };
  CompareParams params;
  params.min_spot_area = 5e-6;
  EXPECT_EQ(Ground().compared({ dip }).over_ground.size(), 1u);
  EXPECT_TRUE(Ground().compared({ dip }, Eigen::Isometry3d::Identity(), params).over_ground.empty());
}

TEST(OverGround, InATaperingEndDepthsAreBelowWhatWasThere)
{
  // the bead fades out over 6 mm; a rest of 0.5 mm is asked for, all but 0.2 mm is ground off
  const IdealWeld plain;
  const auto faded = [&plain](double x, double y) { return plain(x, y) * std::clamp((0.011 - y) / 0.006, 0.0, 1.0); };
  const auto low = [&faded](double x, double y) { return std::min(faded(x, y), 2e-4); };
  WeldParams measuring;
  measuring.target = "rest";
  measuring.rest_height = 5e-4;
  const ScanComparison comparison = ScanComparer(measuring).compare(IdealScanner()(faded), longerScanner(34)(low));
  ASSERT_FALSE(comparison.over_ground.empty());
  for (const OverGroundSpot& spot : comparison.over_ground)
    EXPECT_LT(spot.depth.value, 3e-4 + 4.0 * spot.depth.sigma) << "0.3 mm at most is missing";
  EXPECT_NEAR(comparison.over_ground.front().depth.value, 3e-4, 5e-6);
}

TEST(OverGround, GrindingToARestLeavesTheRest)
{
  IdealWeld weld;
  const Scan before = IdealScanner()(weld);
  const auto rest = [&weld](double x, double y) { return std::min(weld(x, y), 2e-4); };
  WeldParams measuring;
  measuring.target = "rest";
  measuring.rest_height = 2e-4;
  const ScanComparison comparison = ScanComparer(measuring).compare(before, longerScanner(32)(rest));
  EXPECT_TRUE(comparison.over_ground.empty()) << "between face and target at the toes nothing was taken";
  EXPECT_LT(comparison.remaining_volume.value, 3.0 * comparison.remaining_volume.sigma);
  EXPECT_FALSE(ScanComparer(measuring).compare(before, longerScanner(32)(IdealWeld{ 0.0, 0.0 })).over_ground.empty())
      << "flush is too deep";
}
}  // namespace weld_profiler
