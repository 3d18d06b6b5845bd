// `ridge` beside breaks, and where the stripe becomes wider: the last centres are as good as the others, or say so.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "support/extract.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::distanceAcross;
using test_support::extract;
using test_support::lightOf;
using test_support::paramsOf;
using test_support::render;
using test_support::StripePicture;

constexpr int kSeeds = 12;
constexpr int kWidth = 400;

struct Errors
{
  double squares = 0.0, in_sigmas = 0.0, sum = 0.0;
  int count = 0;

  double rms() const { return std::sqrt(squares / count); }
  double honesty() const { return std::sqrt(in_sigmas / count); }
  double bias() const { return sum / count; }
};

using Asked = std::function<bool(int cell)>;

/// Errors of the centres of the cells that are asked for, over all seeds. Columns that are `dark` hold no light.
Errors errorsOf(StripePicture scene, const Asked& asked, const Asked& dark = {})
{
  Errors errors;
  for (int seed = 1; seed <= kSeeds; ++seed)
  {
    scene.seed = 300 + static_cast<unsigned>(seed);
    std::vector<double> light = lightOf(scene);
    for (std::size_t i = 0; dark && i < light.size(); ++i)
      light[i] = dark(static_cast<int>(i) % scene.width) ? 0.0 : light[i];
    const Stripe stripe = extract(paramsOf("ridge"), render(scene, light));
    for (std::size_t i = 0; i < stripe.size(); ++i)
    {
      if ((stripe.flags[i] & stripe_flag::kInterpolated) != 0 || !asked(stripe.cell[i]))
        continue;
      const double error = distanceAcross(scene, stripe.u[i], stripe.v[i]);
      errors.squares += error * error;
      errors.sum += error;
      errors.in_sigmas += error * error / (stripe.sigma[i] * stripe.sigma[i]);
      ++errors.count;
    }
  }
  return errors;
}

/// Flanks of 45 deg, bent by up to 0.03 / px.
StripePicture bead()
{
  constexpr double kPi = 3.14159265358979323846;
  StripePicture scene;
  scene.width = kWidth;
  scene.height = 160;
  scene.snr = 50.0;
  scene.row = [](double u) { return 80.3 + 210.0 / (2.0 * kPi) * std::sin(2.0 * kPi * u / 210.0); };
  scene.slope = [](double u) { return std::cos(2.0 * kPi * u / 210.0); };
  return scene;
}

TEST(RidgeEnds, TheLastCentresBesideAStepAreNotDrawnTowardTheOtherSide)
{
  StripePicture scene;
  scene.width = kWidth;
  scene.height = 160;
  scene.snr = 50.0;
  scene.row = [](double u) { return 60.3 + 0.021 * u + (u > 199.5 ? 30.0 : 0.0); };
  scene.slope = [](double) { return 0.021; };
  for (const double half_break : { 0.0, 5.0 })
  {
    scene.gain = [=](double u) { return std::abs(u - 199.5) < half_break ? 0.0 : 1.0; };
    const Errors errors = errorsOf(scene, [](int cell) { return std::abs(cell - 199.5) < 14.0; });
    ASSERT_GT(errors.count, 100) << half_break;
    // Three columns of 26 mpx each make 15 mpx; a slope taken across the step made 500 mpx of the last one.
    EXPECT_LT(errors.rms(), 0.030) << half_break;
    EXPECT_LT(errors.honesty(), 1.3) << half_break;
    EXPECT_GT(errors.honesty(), 0.7) << half_break;
  }
}

TEST(RidgeEnds, OnAFlankTheLastCentresKnowTheCurvature)
{
  const auto dark = [](int cell) { return cell % 100 < 40; };
  const auto ends = [](int cell) { return cell > 45 && cell < 370 && (cell % 100 < 52 || cell % 100 > 87); };
  const Errors errors = errorsOf(bead(), ends, dark);
  ASSERT_GT(errors.count, 500);
  EXPECT_LT(errors.rms(), 0.028);
  EXPECT_LT(errors.honesty(), 1.4);
  EXPECT_GT(errors.honesty(), 0.7);
}

TEST(RidgeEnds, WhereTheLightFadesOutOnAFlankTheCentresStayOnTheLine)
{
  StripePicture scene = bead();
  constexpr double kSoft = 1.5;  // [px]
  scene.gain = [](double u)
  { return 0.5 * std::erfc((20.0 - std::abs(std::fmod(u, 100.0) - 60.0)) / (kSoft * std::sqrt(2.0))); };
  const auto ends = [](int cell)
  { return cell > 12 && cell < kWidth - 12 && std::abs(std::abs(cell % 100 - 60.0) - 20.0) < 8.0; };
  const Errors errors = errorsOf(scene, ends);
  ASSERT_GT(errors.count, 400);
  // What the light feigns there is 1 px and more. Not taken off, with the slope across the break, it leaves 0.28.
  EXPECT_LT(errors.rms(), 0.14);
  EXPECT_LT(errors.honesty(), 1.4);
}

TEST(RidgeEnds, AnObliqueStripeThatBecomesWiderIsNotDisplaced)
{
  StripePicture scene;
  scene.width = 1000;
  scene.height = 460;
  scene.snr = 50.0;
  scene.row = [](double u) { return 120.3 + 0.1763 * u; };
  scene.slope = [](double) { return 0.1763; };
  scene.sigma_at = [](double u) { return 1.2 * std::pow(8.0 / 1.2, u / 1000.0); };
  const Errors errors = errorsOf(scene, [](int cell) { return cell > 600 && cell < 960; });
  ASSERT_EQ(errors.count, kSeeds * 359);
  EXPECT_LT(std::abs(errors.bias()), 0.004);  // 0.02 at these widths without the correction
  EXPECT_LT(errors.honesty(), 1.25);
  EXPECT_GT(errors.honesty(), 0.75);
}
}  // namespace
}  // namespace weld_profiler
