#include <string>

#include <gtest/gtest.h>

#include "weld/compared.h"
#include "weld/ground_weld.h"
#include "weld_profiler/weld/scan_comparison.h"

namespace weld_profiler
{
namespace
{
const Eigen::Isometry3d kRefixed = motionAbout({ 0.0, 0.006, 0.0 }, { 0.0008, -0.0006, 0.0015 }, { 1.2, -0.9, 0.6 });

/// Two offset plates whose weld was undercut.
IdealWeld offsetWeld()
{
  IdealWeld weld;
  weld.misalignment = 0.0008;
  weld.undercut = 0.0002;
  weld.yaw = 6.0 * kDegree;
  return weld;
}

IdealWeld groundFlush(IdealWeld weld)
{
  weld.height = 1e-9;
  return weld;
}

bool noted(const ScanComparison& comparison, const std::string& words)
{
  for (const std::string& note : comparison.notes)
    if (note.find(words) != std::string::npos)
      return true;
  return false;
}

double removedOf(const IdealWeld& weld)
{
  return segmentArea(weld.width, weld.height) * kLength / std::cos(weld.yaw);
}

/// How far beside its place the scan after was laid, across the weld.
double offAcross(const ScanAlignment& aligned, const Eigen::Isometry3d& motion, const IdealWeld& weld)
{
  const Eigen::Vector3d off = aligned.before_T_after * motion * aligned.about - aligned.about;
  return std::cos(weld.yaw) * off.x() + std::sin(weld.yaw) * off.y();
}

/// Ground flush, and the parent right of the weld ground, too, from one end of the scan to a place.
ScanComparison groundBeside(const IdealWeld& weld, double deep, double up_to_y)
{
  const IdealWeld flush = groundFlush(weld);
  const auto after = [&](double x, double y)
  {
    const double q = std::cos(flush.yaw) * x + std::sin(flush.yaw) * y;
    const bool ground = q > 0.0 && q < 0.0055 && y < up_to_y;
    return ground ? std::min(flush(x, y), flush.plate(q) - deep) : flush(x, y);
  };
  return ScanComparer().compare(IdealScanner()(weld), moved(longerScanner(14)(after), kRefixed));
}
}  // namespace

TEST(CompareUndercuts, ThoseLeftStandingTellTheShiftAcross)
{
  const IdealWeld weld = offsetWeld();
  const Scan before = IdealScanner()(weld);
  // the step between the plates is worth 0.8 mm x 11.8 mm of volume for every mm of shift
  for (const double shift : { 0.0008, -0.0012 })
  {
    const Eigen::Isometry3d motion = motionAbout({ 0.0, 0.006, 0.0 }, { shift, -0.0004, 0.001 }, { 0.8, -1.1, 0.5 });
    const ScanComparison comparison =
        ScanComparer().compare(before, moved(longerScanner(13)(groundFlush(weld)), motion));
    EXPECT_EQ(comparison.kind, WeldKind::Butt);
    EXPECT_TRUE(comparison.aligned.by_undercuts);
    EXPECT_TRUE(comparison.aligned.across_told);
    EXPECT_FALSE(comparison.aligned.along_told) << "they are the same all along";
    EXPECT_TRUE(noted(comparison, "undercuts were left standing"));
    EXPECT_NEAR(offAcross(comparison.aligned, motion, weld), 0.0, 4e-5);
    expectVolume("removed", comparison.removed_volume, removedOf(weld), weld.width);
    expectVolume("remaining", comparison.remaining_volume, 0.0, weld.width);
    EXPECT_TRUE(comparison.over_ground.empty());
  }
}

TEST(CompareUndercuts, OneThatWasGroundAwayTellsNothing)
{
  const IdealWeld weld = offsetWeld();
  const ScanComparison comparison = groundBeside(weld, 0.00025, 1.0);
  EXPECT_FALSE(comparison.aligned.by_undercuts);
  EXPECT_FALSE(comparison.aligned.across_told);
  EXPECT_FALSE(noted(comparison, "undercuts were left standing"));
  // nothing is told, so the volume's sigma has the whole placement: 0.5 mm of the step
  EXPECT_GT(comparison.removed_volume.sigma, 0.8 * 5e-4 * weld.misalignment * kLength);
  EXPECT_FALSE(comparison.over_ground.empty());
}

TEST(CompareUndercuts, HalfOfOneIsEnough)
{
  const IdealWeld weld = offsetWeld();
  const ScanComparison comparison = groundBeside(weld, 0.00025, 0.0045);
  EXPECT_TRUE(comparison.aligned.by_undercuts);
  EXPECT_NEAR(offAcross(comparison.aligned, kRefixed, weld), 0.0, 6e-5);
}

TEST(CompareUndercuts, TheBottomOfOneIsEnough)
{
  const IdealWeld weld = offsetWeld();
  const ScanComparison comparison = groundBeside(weld, 0.00006, 1.0);
  EXPECT_TRUE(comparison.aligned.by_undercuts);
  EXPECT_NEAR(offAcross(comparison.aligned, kRefixed, weld), 0.0, 6e-5);
}

TEST(CompareUndercuts, OneThatWasLoweredAllOverIsNotFoundElsewhere)
{
  const IdealWeld weld = offsetWeld(), flush = groundFlush(weld);
  for (const double lowered : { 4e-5, 6e-5, 1e-4 })
  {
    const auto after = [&](double x, double y)
    {
      const double q = std::cos(flush.yaw) * x + std::sin(flush.yaw) * y;
      return flush(x, y) - (q > 0.0 && q < 0.0055 ? lowered : 0.0);
    };
    const ScanComparison comparison =
        ScanComparer().compare(IdealScanner()(weld), moved(longerScanner(17)(after), kRefixed));
    EXPECT_FALSE(comparison.aligned.across_told)
        << lowered << ": " << offAcross(comparison.aligned, kRefixed, weld) << " m off";
  }
}

TEST(CompareUndercuts, WithoutThemAPartBesideItsPlaceLooksLikeDeeperGrinding)
{
  IdealWeld weld = offsetWeld();
  weld.undercut = 0.0, weld.yaw = 0.0;
  const Scan before = IdealScanner()(weld);
  const double shift = 0.0003, deeper = shift * weld.misalignment / weld.width;
  const IdealWeld flush = groundFlush(weld);
  // the disc's plane goes on into the higher plate
  const auto ground_deeper = [&](double x, double y)
  {
    const double disc = weld.misalignment * x / weld.width - deeper;
    return x > -0.5 * weld.width ? std::min(flush(x, y), disc) : flush(x, y);
  };
  const Eigen::Isometry3d beside = motionAbout({ 0.0, 0.006, 0.0 }, { shift, 0.0, 0.0 }, { 0.0, 0.0, 0.0 });
  const ScanComparer comparer;
  const ScanComparison moved_part = comparer.compare(before, moved(longerScanner(16)(flush), beside));
  const ScanComparison ground_part = comparer.compare(before, longerScanner(16)(ground_deeper));
  const double apart = deeper * weld.width * kLength;
  EXPECT_NEAR(moved_part.removed_volume.value, removedOf(weld) + apart, 0.1 * apart);
  EXPECT_NEAR(ground_part.removed_volume.value, moved_part.removed_volume.value, 0.1 * apart);
  for (const ScanComparison* comparison : { &moved_part, &ground_part })
  {
    EXPECT_FALSE(comparison->aligned.across_told);
    EXPECT_GT(comparison->removed_volume.sigma, apart) << "0.5 mm of placement, and it is said";
  }
}
}  // namespace weld_profiler
