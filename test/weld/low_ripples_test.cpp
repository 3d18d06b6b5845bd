// Low beads whose ripples are not much lower than they.
#include "weld/low_ripples.h"

#include <gtest/gtest.h>

#include "weld/statistics.h"
#include "weld/toe_fit.h"
#include "weld/toe_unrest.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace
{
/// Angle of the left toe by its definition: the first millimetre of the face, or a third of its height.
double trueToeAngle(const Crescents& face, double y)
{
  constexpr double kStep = 2e-6;
  const double half = 0.5 * face.weld.width;
  double height = 0.0;
  for (double x = -half; x < half; x += kStep)
    height = std::max(height, face(x, y));
  double n = 0.0, u = 0.0, z = 0.0, uu = 0.0, uz = 0.0;
  for (double d = 0.0; d < 1e-3; d += kStep)
  {
    const double at = face(-half + d + 1e-12, y);
    if (at > height / 3.0)
      break;
    n += 1.0, u += d, z += at, uu += d * d, uz += d * at;
  }
  return kPi - std::atan((n * uz - u * z) / (n * uu - u * u));
}
}  // namespace

TEST(LowRipples, DoNotPullTheToesInward)
{
  const Crescents face;
  const WeldResult result = WeldMeasurer().measure(fineRows()(face));
  ASSERT_EQ(result.sections.size(), 100u);
  Errors widths;
  for (const WeldSection& section : result.sections)
    widths.add(section.width, face.weld.width);
  EXPECT_GE(widths.errors.size(), 95u) << "where a ripple's trough lies at the toe the bead goes on: " << result.reason;
  EXPECT_LT(std::abs(weld::median(widths.errors)), 3e-5);
  EXPECT_LT(widths.quadraticMean(), 1.3);
}

TEST(LowRipples, ToeAnglesFollowThemWithinTheirSigmas)
{
  const Crescents face;
  const WeldResult result = WeldMeasurer().measure(fineRows()(face));
  Errors angles;
  for (const WeldSection& section : result.sections)
    angles.add(section.toe_angle_left, trueToeAngle(face, section.row * 2e-4));
  ASSERT_GE(angles.errors.size(), 95u);
  EXPECT_LT(weld::robustSigma(angles.errors), 0.85 * kPi / 180.0) << "ripples alone change it by 1.1 deg either way";
  EXPECT_LT(angles.quadraticMean(), 1.3);
}

TEST(LowRipples, HeightsBetweenMissingRowsAreLessCertain)
{
  IdealWeld weld;
  weld.ripple = 1e-4;
  IdealScanner scanner = fineRows();
  scanner.holes = 0.6;
  const WeldResult result = WeldMeasurer().measure(scanner(weld));
  Errors heights;
  for (const WeldSection& section : result.sections)
  {
    const double wave = std::sin(2.0 * kPi * section.row * 2e-4 / 0.0012);
    heights.add(section.reinforcement, weld.height + 0.5 * weld.ripple * wave);
  }
  ASSERT_GE(heights.errors.size(), 80u);
  EXPECT_LT(heights.quadraticMean(), 1.5);
}

TEST(LowRipples, AToeThatRunsObliquelyIsAtRest)
{
  std::vector<double> places, oblique, wavy;
  for (int k = 0; k < 60; ++k)
  {
    places.push_back(k * 2e-4);
    oblique.push_back(0.2 * places.back());
    wavy.push_back(1e-4 * std::sin(2.0 * kPi * places.back() / 0.0012));
  }
  EXPECT_LT(weld::robustSigma(weld::toeUnrest(places, oblique)), 3e-5) << "rows do not lie half a millimetre apart";
  EXPECT_GT(weld::robustSigma(weld::toeUnrest(places, wavy)), 7e-5);
  wavy[10] = weld::kNaN;
  EXPECT_TRUE(std::isnan(weld::toeUnrest(places, wavy)[10]));
}

TEST(LowRipples, AFlatKinkIsBlurredByTheWholeWindowOfTheStripe)
{
  EXPECT_GT(weld::faceBias(0.1), 1.5 * weld::faceBias(0.6));
  EXPECT_DOUBLE_EQ(weld::faceBias(-0.1), weld::faceBias(0.1));
}
}  // namespace weld_profiler
