#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/extract.h"

namespace weld_profiler
{
namespace
{
using test_support::extract;
using test_support::paramsOf;
using test_support::Picture;
using test_support::render;
using test_support::StripePicture;

StripePicture lineScene()
{
  StripePicture scene;
  scene.width = 600;
  scene.height = 300;
  scene.snr = 50.0;
  scene.peak = 120.0;
  scene.row = [](double u) { return 150.0 + 25.0 * std::sin(u / 90.0); };
  return scene;
}

/// Share of the centres more than 2 px off the true line, and of the columns without a centre.
struct Outcome
{
  double off = 0.0, missing = 0.0;
};

Outcome judge(const StripePicture& scene, const Stripe& stripe)
{
  Outcome outcome;
  for (std::size_t i = 0; i < stripe.size(); ++i)
    if (std::abs(distanceAcross(scene, stripe.u[i], stripe.v[i])) > 2.0)
      outcome.off += 1.0 / static_cast<double>(stripe.size());
  outcome.missing = 1.0 - static_cast<double>(stripe.size()) / scene.width;
  return outcome;
}

TEST(Finding, KeepsToTheStripeAmongSpatterGhostAndGlow)
{
  StripePicture scene = lineScene();
  scene.ambient = [](double u, double v)
  {
    const double ghost = 215.0 + 0.05 * u;  // a reflection, brighter than the stripe in a third of the columns
    const double gain = u > 350.0 && u < 550.0 ? 150.0 : 60.0;
    return gain * std::exp(-0.5 * std::pow((v - ghost) / 3.5, 2.0)) * (u > 330.0 ? 1.0 : 0.6) *
               (u < 570.0 ? 1.0 : 0.0) +
           35.0 * std::exp(-0.5 * (std::pow((u - 300.0) / 120.0, 2.0) + std::pow((v - 150.0) / 60.0, 2.0)));
  };
  Picture picture = render(scene);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> column(5, scene.width - 6);
  std::uniform_int_distribution<int> row(5, scene.height - 6);
  for (int spatter = 0; spatter < 60; ++spatter)
  {
    const int u = column(random);
    const int v = row(random);
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i)
        if (i * i + j * j <= 5)
          picture.set(u + i, v + j, 255.0);
  }
  for (const std::string& method : stripeMethods())
  {
    const Outcome outcome = judge(scene, extract(paramsOf(method), picture));
    EXPECT_LE(outcome.off, 0.02) << method;
    EXPECT_LE(outcome.missing, 0.05) << method;
  }
}

TEST(Finding, IsNotDisturbedByPepperNoise)
{
  const StripePicture scene = lineScene();
  Picture picture = render(scene);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  for (int v = 0; v < picture.height; ++v)
    for (int u = 0; u < picture.width; ++u)
      if (chance(random) < 0.003)
        picture.set(u, v, chance(random) < 0.5 ? 255.0 : 0.0);
  const Outcome outcome = judge(scene, extract(paramsOf("squared_centroid"), picture));
  // Sums over 8 columns keep single pixels out of detection; one in the window of 13 still pulls the centroid (4 % of
  // the columns).
  EXPECT_LE(outcome.off, 0.01);
  EXPECT_LE(outcome.missing, 0.02);
}

TEST(Finding, DropsACentroidThatLeavesItsStripe)
{
  // Blobs four times as bright as the stripe, just outside its window.
  StripePicture scene = lineScene();
  scene.peak = 60.0;
  Picture picture = render(scene);
  for (int u = 20; u < scene.width - 20; u += 40)
  {
    const int v = static_cast<int>(scene.row(u)) + 8;
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i)
        picture.set(u + i, v + j, 255.0);
  }
  for (const std::string& method : stripeMethods())
  {
    const Stripe stripe = extract(paramsOf(method), picture);
    ASSERT_GE(stripe.size(), 500U) << method;
    for (std::size_t i = 0; i < stripe.size(); ++i)
      EXPECT_LT(std::abs(distanceAcross(scene, stripe.u[i], stripe.v[i])), 4.5)
          << method << ", cell " << stripe.cell[i];
  }
}

TEST(Finding, TakesAStepAndBothItsSides)
{
  StripePicture scene = lineScene();
  scene.row = [](double u) { return u < 300.0 ? 120.0 : 190.0; };
  scene.slope = [](double) { return 0.0; };
  const Stripe stripe = extract(paramsOf("squared_centroid"), render(scene));
  ASSERT_GE(stripe.size(), 590U);
  for (std::size_t i = 0; i < stripe.size(); ++i)
    EXPECT_NEAR(stripe.v[i], stripe.cell[i] < 300 ? 120.0 : 190.0, 0.2);
}

TEST(Finding, FindsAStripeOfTwentyGreyLevelsInNoiseOfTwo)
{
  StripePicture scene = lineScene();
  scene.peak = 20.0;
  scene.snr = 10.0;
  const Outcome outcome = judge(scene, extract(paramsOf("squared_centroid"), render(scene)));
  EXPECT_LE(outcome.off, 0.005);
  EXPECT_LE(outcome.missing, 0.02);
}

TEST(Finding, FindsAStripeOfThirtyGreyLevelsInNoiseOfFive)
{
  // Otsu's mask then holds 41 % of the frame: the local contrast has to decide.
  StripePicture scene = lineScene();
  scene.peak = 30.0;
  scene.snr = 6.0;
  const Outcome outcome = judge(scene, extract(paramsOf("squared_centroid"), render(scene)));
  EXPECT_LE(outcome.off, 0.02);
  EXPECT_LE(outcome.missing, 0.10);
}

TEST(Finding, ASecondStripeBesideDoesNotPullTheCentre)
{
  // 5.5 half widths away, where the background would be looked for: taken for it, it pulls by 0.04 to 0.26 px.
  for (const double share : { 0.05, 0.2, 0.45 })
  {
    StripePicture scene = test_support::straight(5.71, 60.3);
    scene.width = 500;
    scene.height = 200;
    scene.sigma = 4.0;
    scene.peak = 150.0;
    scene.snr = 50.0;
    scene.ambient = [&scene, share](double u, double v)
    { return share * 150.0 * std::exp(-0.5 * std::pow((v - scene.row(u) - 22.0) * 0.995 / 4.0, 2.0)); };
    const Stripe stripe = extract(paramsOf("ridge"), render(scene));
    ASSERT_GE(stripe.size(), 480U) << share;
    double sum = 0.0;
    for (std::size_t i = 0; i < stripe.size(); ++i)
      sum += distanceAcross(scene, stripe.u[i], stripe.v[i]);
    EXPECT_NEAR(sum / static_cast<double>(stripe.size()), 0.0, 0.01) << share;
  }
}
}  // namespace
}  // namespace weld_profiler
