#include "weld_profiler/stripe/stripe_params.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/stripe/stripe_methods.h"
#include "weld_profiler/stripe/stripe_stage.h"

namespace weld_profiler
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Refusal
{
  const char* name;  ///< of the parameter, which the error must tell
  std::function<void(StripeParams&)> spoil;
};

std::vector<Refusal> refusals()
{
  return {
    { "method", [](StripeParams& p) { p.method = "gray_center"; } },
    { "direction", [](StripeParams& p) { p.direction = "x"; } },
    { "channel", [](StripeParams& p) { p.channel = "infrared"; } },
    { "roi_x", [](StripeParams& p) { p.roi_x = -1; } },
    { "roi_y", [](StripeParams& p) { p.roi_y = -1; } },
    { "roi_width", [](StripeParams& p) { p.roi_width = -5; } },
    { "roi_height", [](StripeParams& p) { p.roi_height = 70000; } },
    { "min_stripe_width_px", [](StripeParams& p) { p.min_stripe_width_px = kNan; } },
    { "min_stripe_width_px", [](StripeParams& p) { p.min_stripe_width_px = p.max_stripe_width_px + 1.0; } },
    { "max_stripe_width_px", [](StripeParams& p) { p.max_stripe_width_px = kNan; } },
    { "max_stripe_width_px", [](StripeParams& p) { p.max_stripe_width_px = 51.0; } },
    { "min_peak_counts", [](StripeParams& p) { p.min_peak_counts = kNan; } },
    { "min_peak_counts", [](StripeParams& p) { p.min_peak_counts = 0.0; } },
    { "saturation_level", [](StripeParams& p) { p.saturation_level = kNan; } },
    { "saturation_level", [](StripeParams& p) { p.saturation_level = 1e6; } },
    { "median_size_px", [](StripeParams& p) { p.median_size_px = 4; } },
    { "hessian_sigma_px", [](StripeParams& p) { p.hessian_sigma_px = kNan; } },
    { "hessian_sigma_px", [](StripeParams& p) { p.hessian_sigma_px = 0.1; } },
    { "derivatives", [](StripeParams& p) { p.derivatives = "scharr"; } },
    { "taylor", [](StripeParams& p) { p.taylor = "third"; } },
    { "max_aperture_px", [](StripeParams& p) { p.max_aperture_px = 5; } },
    { "fit", [](StripeParams& p) { p.fit = "likelihood"; } },
    { "max_gap_px", [](StripeParams& p) { p.max_gap_px = -1; } },
    { "edge_trim_px", [](StripeParams& p) { p.edge_trim_px = 2000; } },
  };
}

TEST(StripeParams, AreRefusedByNameOutsideTheirRange)
{
  EXPECT_NO_THROW(StripeParams{}.validate());
  for (const Refusal& refusal : refusals())
  {
    StripeParams params;
    refusal.spoil(params);
    try
    {
      const StripeStage stage(params);
      ADD_FAILURE() << refusal.name << " was accepted";
    }
    catch (const ConfigError& error)
    {
      EXPECT_NE(std::string(error.what()).find(std::string("stripe/") + refusal.name), std::string::npos)
          << error.what();
    }
  }
}

TEST(StripeMethods, AreListedWhenANameIsUnknown)
{
  StripeParams params;
  params.method = "gray_center";
  try
  {
    makeStripeExtractor(params);
    FAIL();
  }
  catch (const ConfigError& error)
  {
    for (const std::string& name : stripeMethods())
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

TEST(StripeMethods, HoldThePapersAndThoseToCompareThemWith)
{
  const std::vector<std::string> names = stripeMethods();
  for (const char* name :
       { "svd", "pca", "steger", "gray_centroid", "squared_centroid", "gauss_fit", "fir_peak", "log_parabola" })
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
}
}  // namespace
}  // namespace weld_profiler
