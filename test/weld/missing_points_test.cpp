// Scans of which many points are missing, scattered: what is left tells nearly as much.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "weld/ideal_scan.h"
#include "weld/mean_outline.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace
{
/// Sections with a reinforcement, and the median of its sigma.
struct Told
{
  std::size_t sections = 0;
  double sigma = 0.0;

  explicit Told(const WeldResult& result)
  {
    std::vector<double> sigmas;
    for (const WeldSection& section : result.sections)
    {
      if (section.reinforcement.measured())
        sigmas.push_back(section.reinforcement.sigma);
    }
    sections = sigmas.size();
    std::sort(sigmas.begin(), sigmas.end());
    sigma = sigmas.empty() ? std::nan("") : sigmas[sigmas.size() / 2];
  }
};
}  // namespace

TEST(MissingPoints, TakeNoHeightsAwayBesideAHoleInTheFace)
{
  IdealWeld weld;
  weld.width = 0.010, weld.height = 6e-4, weld.ripple = 1e-4;
  weld.yaw = 18.0 * M_PI / 180.0, weld.x = 0.003;
  // a band along the weld, well away from the crest, that the sensor does not see
  const auto hidden = [&weld](double x, double y)
  {
    const double q = std::cos(weld.yaw) * (x - weld.x) + std::sin(weld.yaw) * y;
    return q > 0.0025 && q < 0.0035 ? std::nan("") : weld(x, y);
  };
  IdealScanner scanner;
  scanner.rows = 100;
  const Told all(WeldMeasurer().measure(scanner(hidden)));
  ASSERT_GE(all.sections, 80u);
  scanner.holes = 0.4;
  const Told some(WeldMeasurer().measure(scanner(hidden)));
  EXPECT_GE(some.sections + 5, all.sections);
}

TEST(MissingPoints, MakeNoRippleOfTheEndOfABead)
{
  IdealWeld weld;
  weld.begin = 0.004;
  IdealScanner scanner;
  scanner.cells = 1200, scanner.spacing = 2e-5;
  const Told all(WeldMeasurer().measure(scanner(weld)));
  ASSERT_GE(all.sections, 35u);
  scanner.holes = 0.4;
  const Told some(WeldMeasurer().measure(scanner(weld)));
  EXPECT_GE(some.sections + 5, all.sections);
  EXPECT_LT(some.sigma, 2.0 * all.sigma) << "six of ten points tell a height 1.3 times worse";
}

/// A point that one row off the plane tells alone may lie before the one that precedes it.
TEST(MissingPoints, LeaveAMeanOutlineWithinItself)
{
  weld::ToeQuestion question;
  question.guess = -0.004, question.opposite = 0.004;
  weld::MeanOutline mean(question);
  const double from = -0.007;  // 3 mm outside of the toe
  weld::SectionProfile profile;
  for (const double q : { -2.0, -1.0, 1.0, 2.0, -0.5, 3.0, 4.0 })
  {
    profile.q.push_back(from + q * 1e-4);
    profile.z.push_back(1e-3);
  }
  mean.add(profile, weld::Line{ 0.0, 0.0 }, 1.0);
  const weld::SectionProfile outline = mean.above(weld::Line{ 0.0, 0.0 }, 0.5);
  ASSERT_EQ(4u, outline.size());
  EXPECT_NEAR(from + 1e-4, outline.q.front(), 1e-9);
  EXPECT_NEAR(from + 4e-4, outline.q.back(), 1e-9);
}
}  // namespace weld_profiler
