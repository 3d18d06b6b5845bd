#include "weld_profiler/weld/scan_comparison.h"

#include <gtest/gtest.h>

#include "weld/compared.h"
#include "weld/ground_weld.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
/// Shift and turn within 4 sigma of the inverse of the part's motion.
void expectAligned(const ScanAlignment& aligned, const Eigen::Isometry3d& motion)
{
  const Eigen::Isometry3d truth = motion.inverse();
  const Eigen::Vector3d shift = truth * aligned.about - aligned.about;
  const Eigen::AngleAxisd turn(truth.linear());
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(aligned.shift[i], shift[i], 4.0 * std::sqrt(aligned.covariance(i, i))) << "shift "
                                                                                       << "xyz"[i];
    EXPECT_NEAR(aligned.rotation[i], turn.angle() * turn.axis()[i],
                4.0 * std::sqrt(aligned.covariance(i + 3, i + 3)) + 3e-5)  // rotation vectors add up only nearly
        << "turn "
        << "xyz"[i];
  }
}

const Eigen::Isometry3d kRefixed = motionAbout({ 0.0, 0.006, 0.0 }, { 0.0008, -0.0006, 0.0015 }, { 1.2, -0.9, 0.6 });
}  // namespace

TEST(ScanComparison, TellsWhatWasTakenOffAndWhatIsLeft)
{
  IdealWeld weld;
  const Scan before = IdealScanner()(weld);
  weld.height = 0.0003;
  const Scan after = moved(longerScanner(5)(weld), kRefixed);
  const ScanComparison comparison = ScanComparer().compare(before, after);
  EXPECT_EQ(comparison.kind, WeldKind::BeadOnPlate);
  const double left = segmentArea(0.008, 0.0003);
  expectVolume("removed", comparison.removed_volume, (segmentArea(0.008, 0.0015) - left) * kLength, 0.008);
  expectVolume("remaining", comparison.remaining_volume, left * kLength, 0.008);
  expectAligned(comparison.aligned, kRefixed);
  EXPECT_GT(comparison.measured_share, 0.99);
  EXPECT_TRUE(comparison.over_ground.empty());
  EXPECT_LT(comparison.aligned.residual, 3e-6);
}

TEST(ScanComparison, NeedsNoBeadInTheScanAfter)
{
  IdealWeld weld;
  const Scan before = IdealScanner()(weld);
  weld.width = 0.0;
  const Scan after = moved(longerScanner(6)(weld), kRefixed);
  const ScanComparison comparison = ScanComparer().compare(before, after);
  expectVolume("removed", comparison.removed_volume, segmentArea(0.008, 0.0015) * kLength, 0.008);
  expectVolume("remaining", comparison.remaining_volume, 0.0, 0.008);
  expectAligned(comparison.aligned, kRefixed);
  EXPECT_FALSE(comparison.aligned.across_told) << "a plate is the same everywhere";
  EXPECT_FALSE(comparison.aligned.along_told);
  EXPECT_FALSE(comparison.aligned.turn_told);
  EXPECT_FALSE(comparison.aligned.by_toes);
  ASSERT_FALSE(comparison.notes.empty());
  EXPECT_NE(comparison.notes.front().find("shift across the weld"), std::string::npos) << comparison.notes.front();
}

TEST(ScanComparison, AFilletsPlatesTellTheShiftAcross)
{
  IdealWeld weld;
  weld.angle = 90.0 * kDegree;
  weld.height = 0.0006;
  const Scan before = IdealScanner()(weld);
  weld.height = 1e-9;
  const Scan after = moved(longerScanner(7)(weld), kRefixed);
  const ScanComparison comparison = ScanComparer().compare(before, after);
  EXPECT_EQ(comparison.kind, WeldKind::Fillet);
  EXPECT_TRUE(comparison.aligned.across_told);
  EXPECT_TRUE(comparison.aligned.turn_told);
  EXPECT_FALSE(comparison.aligned.along_told);
  EXPECT_LT(std::sqrt(comparison.aligned.covariance(0, 0)), 1e-5);
  expectAligned(comparison.aligned, kRefixed);
  expectVolume("removed", comparison.removed_volume, segmentArea(0.008, 0.0006) * kLength, 0.008);
  expectVolume("remaining", comparison.remaining_volume, 0.0, 0.008);
}

TEST(ScanComparison, ToesThatWereLeftStandingTellTheShiftAcross)
{
  IdealWeld weld;
  weld.yaw = 10.0 * kDegree;
  const Scan before = IdealScanner()(weld);
  weld.height = 0.0010;
  const Eigen::Isometry3d far = motionAbout({ 0.0, 0.006, 0.0 }, { 0.0022, 0.0, -0.002 }, { -1.0, 1.5, 1.8 });
  const ScanComparison comparison = ScanComparer().compare(before, moved(longerScanner(8)(weld), far));
  EXPECT_TRUE(comparison.aligned.by_toes);
  EXPECT_TRUE(comparison.aligned.across_told);
  EXPECT_TRUE(comparison.aligned.turn_told) << std::sqrt(comparison.aligned.covariance(5, 5)) / kDegree << " deg";
  EXPECT_FALSE(comparison.aligned.along_told);
  const Eigen::Vector3d off =
      comparison.aligned.before_T_after * far * comparison.aligned.about - comparison.aligned.about;
  EXPECT_NEAR(std::cos(weld.yaw) * off.x() + std::sin(weld.yaw) * off.y(), 0.0, 6e-5) << "across the weld";
  EXPECT_NEAR(off.z(), 0.0, 5e-6);
}

TEST(ScanComparison, SaysTheSameHoweverRowsAndCellsAreOrdered)
{
  IdealWeld weld;
  weld.misalignment = 0.0002;
  const Scan before = IdealScanner()(weld);
  weld.height = 0.0004;
  const Scan after = longerScanner(9)(weld);
  const ScanComparer comparer;
  const ScanComparison a = comparer.compare(before, after), b = comparer.compare(turnedRound(before), after),
                       c = comparer.compare(before, turnedRound(after));
  EXPECT_DOUBLE_EQ(a.removed_volume.value, b.removed_volume.value);
  EXPECT_DOUBLE_EQ(a.removed_volume.value, c.removed_volume.value);
  EXPECT_DOUBLE_EQ(a.remaining_volume.value, b.remaining_volume.value);
  EXPECT_FLOAT_EQ(a.removed[20u * 1000u + 470u], b.removed[39u * 1000u + 529u]);
  EXPECT_FLOAT_EQ(a.removed[20u * 1000u + 470u], c.removed[20u * 1000u + 470u]);
}

TEST(ScanComparison, TakesOtherRowsAndColumnsAfter)
{
  IdealWeld weld;
  const Scan before = IdealScanner()(weld);
  weld.height = 0.0002;
  IdealScanner coarse = longerScanner(10);
  coarse.rows = 45, coarse.pitch = 4e-4;
  coarse.cells = 700, coarse.spacing = 6e-5;
  const ScanComparison comparison = ScanComparer().compare(before, coarse(weld));
  const double left = segmentArea(0.008, 0.0002);
  expectVolume("removed", comparison.removed_volume, (segmentArea(0.008, 0.0015) - left) * kLength, 0.008);
  EXPECT_EQ(comparison.rows, 60u);
  EXPECT_EQ(comparison.cells, 1000u);
  ASSERT_EQ(comparison.after.size(), 60000u);
}

TEST(ScanComparison, GuessesNothingAcrossAGap)
{
  IdealWeld weld;
  const Scan before = IdealScanner()(weld);
  weld.height = 0.0003;
  const auto holed = [&weld](double x, double y)
  { return std::abs(x) < 0.002 && y > 0.004 && y < 0.007 ? NAN : weld(x, y); };
  const ScanComparison comparison = ScanComparer().compare(before, longerScanner(11)(holed));
  int in_hole = 0;
  for (std::size_t row = 21; row <= 34; ++row)  // y of 4.2 to 6.8 mm
  {
    for (std::size_t cell = 460; cell <= 540; ++cell)  // x of -1.7 to 1.7 mm
    {
      EXPECT_TRUE(std::isnan(comparison.after[row * 1000u + cell]));
      EXPECT_TRUE(std::isnan(comparison.removed[row * 1000u + cell]));
      EXPECT_TRUE(std::isnan(comparison.remaining[row * 1000u + cell]));
      ++in_hole;
    }
  }
  EXPECT_EQ(in_hole, 14 * 81);
  const double zone = (0.008 + 2.0 * 0.0025) * kLength, hole = 0.004 * 0.003;
  EXPECT_NEAR(comparison.measured_share, 1.0 - hole / zone, 0.01);
  // only where both saw it: the middle third of the arc is higher than its mean
  const auto rise = [](double x, double height)
  {
    const double radius = 0.5 * (0.004 * 0.004 + height * height) / height;
    return std::sqrt(radius * radius - x * x) - (radius - height);
  };
  double in_gap = 0.0;
  for (double x = -0.002 + 5e-6; x < 0.002; x += 1e-5)
    in_gap += (rise(x, 0.0015) - rise(x, 0.0003)) * 1e-5 * 0.003;
  const double whole = (segmentArea(0.008, 0.0015) - segmentArea(0.008, 0.0003)) * kLength;
  EXPECT_NEAR(comparison.removed_volume.value, whole - in_gap, 0.1 * in_gap) << "the gap's rim is a row or cell wide";
  bool noted = false;
  for (const std::string& note : comparison.notes)
    noted = noted || note.find("missing in the scan after") != std::string::npos;
  EXPECT_TRUE(noted);
}

TEST(ScanComparison, HolesInAThirdOfThePointsAreNoGaps)
{
  IdealWeld weld;
  IdealScanner scanner;
  scanner.holes = 0.33;
  const Scan before = scanner(weld);
  weld.height = 0.0003;
  IdealScanner later = longerScanner(12);
  later.holes = 0.33;
  const ScanComparison comparison = ScanComparer().compare(before, later(weld));
  const double left = segmentArea(0.008, 0.0003);
  EXPECT_GT(comparison.measured_share, 0.997);
  expectVolume("removed", comparison.removed_volume, (segmentArea(0.008, 0.0015) - left) * kLength, 0.008);
}

TEST(ScanComparison, ToldSigmasFitTheErrors)
{
  IdealWeld weld;
  const IdealScanner scanner;
  const Scan before = scanner(weld);
  weld.height = 0.0002;
  const double removed = (segmentArea(0.008, 0.0015) - segmentArea(0.008, 0.0002)) * kLength;
  double sum = 0.0;
  constexpr int kTimes = 12;
  for (unsigned seed = 0; seed < kTimes; ++seed)
  {
    IdealScanner first = scanner;
    first.seed = 100 + seed;
    IdealWeld whole;
    const ScanComparison comparison =
        ScanComparer().compare(first(whole), moved(longerScanner(200 + seed)(weld), kRefixed));
    ASSERT_TRUE(comparison.removed_volume.measured());
    const double error = (comparison.removed_volume.value - removed) / comparison.removed_volume.sigma;
    EXPECT_LT(std::abs(error), 3.0) << "seed " << seed;
    sum += error * error;
  }
  // the ideal scanner has no systematic errors, which the sigma allows for
  EXPECT_LT(std::sqrt(sum / kTimes), 1.3);
  EXPECT_GT(std::sqrt(sum / kTimes), 0.1) << "a sigma that is ten times too large says nothing";
}
}  // namespace weld_profiler
