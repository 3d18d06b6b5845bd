// The paper's chain once more, as a reader of the paper would write it with Eigen, in double, sharing nothing with
// stripe/ but the pixel blocks that the method started from.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "support/extract.h"

namespace weld_profiler
{
namespace
{
using test_support::Picture;

struct OracleCentre
{
  bool defined = false;   ///< the template's first moment is
  bool settled = false;   ///< the step ended inside its pixel, near the initial point
  bool at_limit = false;  ///< a step came within 1e-3 of half a pixel
  double u = 0.0, v = 0.0;
};

double gaussian(double x, double sigma)
{
  return std::exp(-0.5 * x * x / (sigma * sigma));
}

/// The five derivatives by direct two-dimensional convolution.
Eigen::Matrix<double, 5, 1> derivativesAt(const Picture& picture, int u, int v, double sigma)
{
  const int reach = sigma > 0.0 ? static_cast<int>(std::ceil(4.0 * sigma)) : 1;
  double sum = 0.0, second = 0.0, fourth = 0.0;
  for (int x = -reach; x <= reach; ++x)
  {
    const double weight = sigma > 0.0 ? gaussian(x, sigma) : (x == 0 ? 2.0 : 1.0);
    sum += weight;
    second += weight * x * x;
    fourth += weight * x * x * x * x;
  }
  second /= sum;
  fourth /= sum;
  Eigen::Matrix<double, 5, 1> d = Eigen::Matrix<double, 5, 1>::Zero();
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x)
    {
      const auto smooth = [&](int t) { return (sigma > 0.0 ? gaussian(t, sigma) : (t == 0 ? 2.0 : 1.0)) / sum; };
      const auto slope = [&](int t) { return smooth(t) * t / second; };
      const auto bend = [&](int t) { return 2.0 * smooth(t) * (t * t - second) / (fourth - second * second); };
      const double gray = picture.at(u + x, v + y);
      d += gray * (Eigen::Matrix<double, 5, 1>() << slope(x) * smooth(y), smooth(x) * slope(y), bend(x) * smooth(y),
                   slope(x) * slope(y), smooth(x) * bend(y))
                      .finished();
    }
  return d;
}

OracleCentre oracle(const Picture& picture, const InitialPoint& initial, double line_slope, double sigma)
{
  OracleCentre result;
  const int u = static_cast<int>(initial.block_u);
  int v = static_cast<int>(initial.block_v);
  Eigen::Matrix<double, 49, 3> p;
  for (int i = 0; i < 49; ++i)
    p.row(i) << i % 7 - 3, i / 7 - 3, picture.at(u + i % 7 - 3, v + i / 7 - 3);
  const double moment = std::hypot(p.col(0).dot(p.col(2)), p.col(1).dot(p.col(2)));
  result.defined = moment > 1e-6 * p.squaredNorm();
  if (!result.defined)
    return result;
  const Eigen::JacobiSVD<Eigen::Matrix<double, 49, 3>> svd(p, Eigen::ComputeFullV);
  Eigen::Vector2d n = svd.matrixV().col(2).head<2>().normalized();
  int moved = 0;
  for (int step = 0; step <= 2; ++step)
  {
    const Eigen::Matrix<double, 5, 1> d = derivativesAt(picture, u, v, sigma);
    const double bend = n.x() * n.x() * d[2] + 2.0 * n.x() * n.y() * d[3] + n.y() * n.y() * d[4];
    if (bend >= 0.0)
      return result;
    const double t = -(n.x() * d[0] + n.y() * d[1]) / bend;
    const int direction = t * n.y() > 0.0 ? 1 : -1;
    const bool swings = moved == -direction;
    const double limit = swings ? 0.55 : 0.5;  // half-way between two pixels the step is a little longer from either
    result.at_limit = result.at_limit || std::abs(std::abs(t) - limit) <= 1e-3;
    if (std::abs(t) <= limit)
    {
      result.u = u + t * n.x();
      result.v = v + t * n.y();
      result.settled = std::abs(result.v - line_slope * (result.u - u) - initial.v) <= 1.0;
      return result;
    }
    if (swings)
      return result;
    moved = direction;
    v += direction;
  }
  return result;
}

struct Case
{
  const char* derivatives;
  double sigma;  ///< of the Gaussian, 0 = Sobel
};

class SvdOracle : public ::testing::TestWithParam<Case>
{
};

TEST_P(SvdOracle, AgreesWithTheMethodInEveryDefinedCell)
{
  int cells = 0;
  int compared = 0;
  int stayed = 0;
  for (const double degrees : { 0.0, 10.0, 25.0, 40.0 })
  {
    const double slope = std::tan(degrees * std::acos(-1.0) / 180.0);
    test_support::StripePicture scene = test_support::straight(degrees, 25.37);
    scene.width = 400;
    scene.height = static_cast<int>(60 + 400 * slope);
    scene.snr = 50.0;
    const Picture picture = test_support::render(scene);
    StripeParams params = test_support::paramsOf("svd");
    params.derivatives = GetParam().derivatives;
    params.hessian_sigma_px = GetParam().sigma;
    params.max_gap_px = 0;
    Workspace workspace;
    workspace.keep_trace = true;
    Stripe stripe;
    StripeStage(params).process(picture.raw(), workspace, stripe);
    ASSERT_EQ(stripe.size(), 400U);
    ASSERT_EQ(workspace.initial.size(), stripe.size());
    for (std::size_t i = 12; i + 12 < stripe.size(); ++i)
    {
      const OracleCentre expected = oracle(picture, workspace.initial[i], slope, GetParam().sigma);
      ++cells;
      if (expected.at_limit)
        continue;
      ++compared;
      const bool stays = !expected.defined || !expected.settled;
      stayed += stays ? 1 : 0;
      const double u = stays ? workspace.initial[i].u : expected.u;
      const double v = stays ? workspace.initial[i].v : expected.v;
      EXPECT_NEAR(stripe.u[i], u, 1e-4) << degrees << " deg, cell " << stripe.cell[i];
      EXPECT_NEAR(stripe.v[i], v, 1e-4) << degrees << " deg, cell " << stripe.cell[i];
    }
  }
  EXPECT_EQ(cells, 4 * 376);
  EXPECT_GE(compared, 0.99 * cells);
  EXPECT_LE(stayed, 0.05 * cells) << "the step settles nearly everywhere, or nothing is compared";
}

TEST(SvdMethod, KeepsTheInitialPointWhereTheNormalIsUndefined)
{
  // Without noise, in the middle of a pixel row: every template is symmetric.
  test_support::StripePicture scene = test_support::straight(0.0, 30.0);
  scene.width = 100;
  scene.height = 61;
  const Picture picture = test_support::render(scene);
  const Stripe stripe = test_support::extract(test_support::paramsOf("svd"), picture);
  ASSERT_EQ(stripe.size(), 100U);
  for (std::size_t i = 3; i + 3 < stripe.size(); ++i)
  {
    EXPECT_FALSE(
        oracle(picture, InitialPoint{ static_cast<float>(i), 30.0F, static_cast<float>(i), 30.0F }, 0.0, 2.0).defined);
    EXPECT_EQ(stripe.u[i], static_cast<float>(stripe.cell[i]));
    EXPECT_NEAR(stripe.v[i], 30.0, 1e-4);
    // Which of the two ends of the range it is, the last bit of the line's slope decides.
    EXPECT_NEAR(std::abs(stripe.normal_angle[i]), 0.5 * std::acos(-1.0), 1e-6) << "across the column";
  }
}

INSTANTIATE_TEST_SUITE_P(Derivatives, SvdOracle,
                         ::testing::Values(Case{ "gaussian", 2.31 }, Case{ "gaussian", 1.5 }, Case{ "sobel", 0.0 }),
                         [](const auto& info) {
                           return std::string(info.param.derivatives) +
                                  std::to_string(static_cast<int>(100.0 * info.param.sigma));
                         });
}  // namespace
}  // namespace weld_profiler
