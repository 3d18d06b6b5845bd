// The same frame through every path that this processor has: all of the stripe room, whatever of it is vector code.
#include <gtest/gtest.h>

#include <cmath>

#include "stripe/multiversion.h"
#include "support/extract.h"
#include "support/on_path.h"

namespace weld_profiler
{
namespace
{
using test_support::OnPath;
using test_support::Picture;

Stripe extractOn(VectorPath path, const StripeParams& params, const Picture& picture)
{
  const OnPath on(path);
  return test_support::extract(params, picture);
}

struct Scene
{
  const char* name;
  double degrees;
  double sigma;
  double speckle;
  int bit_depth;
  int width;
};

void PrintTo(const Scene& scene, std::ostream* out)
{
  *out << scene.name;
}

class Dispatch : public ::testing::TestWithParam<std::tuple<std::string, Scene>>
{
};

Picture pictureOf(const Scene& c)
{
  test_support::StripePicture scene = test_support::straight(c.degrees, 31.37);
  scene.width = c.width;
  scene.height = static_cast<int>(70 + c.width * std::tan(c.degrees * std::acos(-1.0) / 180.0));
  scene.sigma = c.sigma;
  scene.snr = 30.0;
  scene.speckle = c.speckle;
  scene.bit_depth = c.bit_depth;
  return render(scene);
}

TEST_P(Dispatch, GivesTheSameCentresOnEveryPath)
{
  if (widestVectorPath() == VectorPath::Plain)
    GTEST_SKIP() << "this processor has the plain path only";
  const auto& [method, scene] = GetParam();
  const Picture picture = pictureOf(scene);
  const StripeParams params = test_support::paramsOf(method);
  const Stripe plain = extractOn(VectorPath::Plain, params, picture);
  const Stripe wide = extractOn(widestVectorPath(), params, picture);
  ASSERT_EQ(plain.size(), static_cast<std::size_t>(scene.width));
  ASSERT_EQ(wide.cell, plain.cell);
  EXPECT_EQ(wide.flags, plain.flags);
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    EXPECT_NEAR(wide.u[i], plain.u[i], 1e-3) << "cell " << plain.cell[i];
    EXPECT_NEAR(wide.v[i], plain.v[i], 1e-3) << "cell " << plain.cell[i];
    EXPECT_NEAR(wide.sigma[i], plain.sigma[i], 0.02 * plain.sigma[i]) << "cell " << plain.cell[i];
  }
}

/// 1 if the compiler took the path that multiplies and adds without rounding between.
struct RoundsOnce
{
  WELD_PROFILER_KERNEL static void run(float a, float b, float c, bool* result) { *result = a * b + c != 0.0F; }
};

TEST(DispatchHeader, TakesThePathItIsToldTo)
{
  // (1 + e)^2 = 1 + 2 e + e^2: rounded to 1 + 2 e in single precision; e^2 is left only where it is not rounded.
  volatile float exponent_hidden = -12.0F;  // or the compiler computes it, always rounding
  const float e = std::exp2(exponent_hidden);
  bool once = false;
  {
    const OnPath on(VectorPath::Plain);
    dispatch<RoundsOnce>(1.0F + e, 1.0F + e, -(1.0F + 2.0F * e), &once);
#if !defined(__FMA__) && !defined(__aarch64__)
    EXPECT_FALSE(once);
#endif
  }
  if (widestVectorPath() == VectorPath::Plain)
    return;
  dispatch<RoundsOnce>(1.0F + e, 1.0F + e, -(1.0F + 2.0F * e), &once);
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)  // which does not join operations at -O1
  EXPECT_TRUE(once) << "the wide path is compiled for FMA";
#endif
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, Dispatch,
                         ::testing::Combine(::testing::ValuesIn(stripeMethods()),
                                            ::testing::Values(Scene{ "flat", 1.0, 2.0, 0.0, 8, 301 },
                                                              Scene{ "steep", 55.0, 1.5, 0.0, 8, 157 },
                                                              Scene{ "wide16", 12.0, 5.0, 0.0, 16, 203 },
                                                              Scene{ "speckled", 30.0, 2.0, 0.15, 8, 255 },
                                                              Scene{ "small", 8.0, 1.2, 0.0, 8, 13 })),
                         [](const auto& info) { return std::get<0>(info.param) + "_" + std::get<1>(info.param).name; });
}  // namespace
}  // namespace weld_profiler
