// Method `svd`, which looks at the band around the stripe alone, against the paper's chain over the whole frame.
#include "reference/plain_svd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/extract.h"

namespace weld_profiler
{
namespace
{
constexpr double kHessianSigma = 2.25;

test_support::Picture beadFrame()
{
  test_support::StripePicture scene;
  scene.width = 1440;
  scene.height = 400;
  scene.snr = 50.0;
  scene.speckle = 0.05;
  scene.row = [](double u) { return 250.3 + 0.05 * u - 150.0 * std::exp(-0.5 * std::pow((u - 700.0) / 140.0, 2.0)); };
  return render(scene);
}

cv::Mat matOf(const test_support::Picture& picture)
{
  return { picture.height, picture.width, CV_8U, const_cast<std::uint8_t*>(picture.bytes.data()) };
}

TEST(PlainSvd, HasTheCentresOfMethodSvd)
{
  const test_support::Picture picture = beadFrame();
  StripeParams params = test_support::paramsOf("svd");
  params.hessian_sigma_px = kHessianSigma;
  params.max_gap_px = 0;
  Workspace workspace;
  workspace.keep_trace = true;
  Stripe stripe;
  StripeStage(params).process(picture.raw(), workspace, stripe);
  ASSERT_EQ(stripe.size(), 1440U);
  ASSERT_EQ(workspace.initial.size(), stripe.size());
  std::vector<double> rows(1440, std::numeric_limits<double>::quiet_NaN());
  for (const InitialPoint& point : workspace.initial)
    rows[static_cast<std::size_t>(point.u)] = point.v;

  const std::vector<reference::PlainCentre> plain = reference::plainSvd(matOf(picture), kHessianSigma, rows);
  ASSERT_EQ(plain.size(), stripe.size());
  int compared = 0;
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    ASSERT_EQ(plain[i].cell, stripe.cell[i]);
    // More than 1e-4 px only where rounding decides about a step of half a pixel: the centre is taken from the next
    // block then, whose second-order step ends elsewhere.
    const double difference = std::hypot(plain[i].u - stripe.u[i], plain[i].v - stripe.v[i]);
    compared += difference <= 1e-4 ? 1 : 0;
    EXPECT_LE(difference, 0.1) << "cell " << plain[i].cell;
  }
  EXPECT_GE(compared, 0.99 * 1440);
}

TEST(PlainSvd, FindsItsOwnInitialPoints)
{
  const test_support::Picture picture = beadFrame();
  const std::vector<reference::PlainCentre> plain = reference::plainSvd(matOf(picture), kHessianSigma);
  ASSERT_EQ(plain.size(), 1440U);
  int defined = 0;
  for (const reference::PlainCentre& centre : plain)
    defined += centre.defined ? 1 : 0;
  EXPECT_GE(defined, 0.9 * 1440)
      << "all but the edges, and where Otsu's mask puts the block beside the stripe's middle";
}
}  // namespace
}  // namespace weld_profiler
