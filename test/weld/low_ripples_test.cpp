// Low beads whose ripples are not much lower than they.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "weld/ideal_scan.h"
#include "weld/statistics.h"
#include "weld/toe_fit.h"
#include "weld/toe_unrest.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

/// Errors of the sections that tell a value.
struct Errors
{
  std::vector<double> errors, in_sigmas;

  void add(const Quantity& told, double truth)
  {
    if (!told.measured())
      return;
    errors.push_back(told.value - truth);
    in_sigmas.push_back(errors.back() / told.sigma);
  }
  double quadraticMean() const
  {
    double sum = 0.0;
    for (const double one : in_sigmas)
      sum += one * one / static_cast<double>(in_sigmas.size());
    return std::sqrt(sum);
  }
};

/// A low bead whose ripples trail at the toes by a third of its width, as molten pools leave them.
struct Crescents
{
  IdealWeld weld;
  double ripple = 1e-4, pitch = 1.2e-3;

  Crescents() { weld.width = 0.010, weld.height = 2e-4; }

  double operator()(double x, double y) const
  {
    const double share = 4.0 * x * x / (weld.width * weld.width);
    if (share >= 1.0 || y < weld.begin)
      return weld(x, y);
    const double phase = (y + 0.3 * weld.width * share) / pitch;
    return weld(x, y) + 0.5 * ripple * (1.0 - share) * std::sin(2.0 * kPi * phase);
  }
};

IdealScanner fineRows()
{
  IdealScanner scanner;
  scanner.rows = 100;
  return scanner;
}

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

TEST(LowRipples, ABeadThatEndsDoesNotGoOnInItsEvenedFace)
{
  Crescents face;
  face.weld.begin = 0.006;
  const WeldResult result = WeldMeasurer().measure(fineRows()(face));
  int told = 0;
  for (const WeldSection& section : result.sections)
  {
    told += section.hasBead() ? 1 : 0;
    if (section.row * 2e-4 < face.weld.begin - 4e-4)
    {
      EXPECT_FALSE(section.hasBead()) << "row " << section.row;
    }
  }
  EXPECT_GE(told, 44);
}

TEST(LowRipples, ARippledBeadThatEndsJustBeforeTheScanDoesIsNotToldWider)
{
  constexpr double kEnd = 0.0190,
                   kTaper = 0.0005;  // of a scan of 19.8 mm; 0.4 mm before its end it is 0.16 mm narrower
  const auto widthAt = [](double y)
  {
    const double t = std::min(1.0, std::max(0.0, (kEnd - y) / kTaper));
    return 0.008 * std::sqrt(t * (2.0 - t));
  };
  const auto surface = [&](double x, double y)
  {
    Crescents face;
    face.weld.width = widthAt(y);
    face.weld.height = 0.0008 * face.weld.width / 0.008;
    face.ripple = 2e-4;
    return face(x, y);
  };
  const WeldResult result = WeldMeasurer().measure(fineRows()(surface));
  int told = 0;
  for (const WeldSection& section : result.sections)
  {
    if (!section.width.measured())
      continue;
    ++told;
    EXPECT_LT(section.width.value, widthAt(section.row * 2e-4) + 0.2e-3) << "row " << section.row;
  }
  EXPECT_GE(told, 85);
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

TEST(LowRipples, ATaperIsNotEvenedOut)
{
  // rises and widens over 5 mm, an ellipse's quarter, then runs on
  const auto halfAt = [](double y)
  {
    const double into = std::min(1.0, std::max(0.0, y - 0.002) / 0.005);
    return 0.004 * std::sqrt(1.0 - (1.0 - into) * (1.0 - into));
  };
  const auto surface = [&](double x, double y)
  {
    const double half = halfAt(y), share = half > 0.0 ? x * x / (half * half) : 1.0;
    const double ripple = 5e-5 * std::sin(2.0 * kPi * y / 1.2e-3);
    return share < 1.0 ? (1e-3 + ripple) * half / 0.004 * (1.0 - share) : 0.0;
  };
  IdealScanner scanner = fineRows();
  const WeldResult result = WeldMeasurer().measure(scanner(surface));
  Errors widths;
  for (const WeldSection& section : result.sections)
  {
    const double y = result.path[static_cast<std::size_t>(section.section)].y;
    widths.add(section.width, 2.0 * halfAt(y));
    EXPECT_FALSE(section.hasBead() && y < 0.002) << "where no bead is";
  }
  EXPECT_GT(widths.errors.size(), 60u);
  EXPECT_LT(widths.quadraticMean(), 2.0);
  for (const double one : widths.in_sigmas)
    EXPECT_LT(std::abs(one), 6.0);
}
}  // namespace weld_profiler
