// Low rippled beads that begin, end or change their width: what is evened out along a weld must not be carried there.
#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "weld/low_ripples.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace
{
/// Of a bead of changing width, 0.4 mm high where it is 10 mm wide.
Errors widthErrors(const std::function<double(double)>& width)
{
  const auto surface = [&width](double x, double y)
  {
    Crescents face;
    face.weld.width = std::max(1e-5, width(y));
    face.weld.height = 0.04 * face.weld.width;
    face.ripple = 0.01 * face.weld.width;
    return face(x, y);
  };
  Errors widths;
  for (const WeldSection& section : WeldMeasurer().measure(fineRows()(surface)).sections)
    widths.add(section.width, width(section.row * 2e-4));
  return widths;
}
}  // namespace

TEST(RippledEnds, ABeadThatEndsDoesNotGoOnInItsEvenedFace)
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

TEST(RippledEnds, ARippledBeadThatEndsJustBeforeTheScanDoesIsNotToldWider)
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

TEST(RippledEnds, ABeadThatRisesOverAnEllipseIsToldWithinItsSigmas)
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

TEST(RippledEnds, ATaperIsNotEvenedOut)
{
  const auto narrows = [](double y) { return 0.010 - 0.005 * std::clamp((y - 0.008) / 0.002, 0.0, 1.0); };
  const auto neck = [](double y) { return 0.005 + 0.005 * std::min(1.0, std::abs(y - 0.010) / 0.002); };
  for (const std::function<double(double)>& width : std::vector<std::function<double(double)>>{ narrows, neck })
  {
    const Errors widths = widthErrors(width);
    EXPECT_GE(widths.errors.size(), 80u);
    for (const double error : widths.errors)
      EXPECT_LT(error, 0.7e-3) << "evened out over 5 mm the narrow part is told 1.4 to 2.2 mm too wide";
  }
}

TEST(RippledEnds, AGapBetweenTwoTacksIsNotEvenedOut)
{
  const auto width = [](double y)
  {
    const double into = std::clamp((std::abs(y - 0.010) - 0.6e-3) / 2e-4, 0.0, 1.0);
    return 0.010 * std::sqrt(into * (2.0 - into));
  };
  const Errors widths = widthErrors(width);
  EXPECT_GE(widths.errors.size(), 75u);
  for (const double error : widths.errors)
    EXPECT_LT(error, 0.2e-3) << "evened toes of either tack would run on through the gap, 10 mm apart";
}
}  // namespace weld_profiler
