#include "stripe/template_normal.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::Picture;

/// Cosine of the angle between two undirected lines.
double alike(const TemplateNormal& normal, const Eigen::Vector2d& other)
{
  return std::abs(normal.u * other.x() + normal.v * other.y()) / other.norm();
}

Picture noisyStripe(double degrees, double offset, unsigned seed)
{
  test_support::StripePicture stripe = test_support::straight(degrees, offset);
  stripe.width = 61;
  stripe.height = static_cast<int>(40 + 61 * std::tan(degrees * std::acos(-1.0) / 180.0));
  stripe.snr = 50.0;
  stripe.seed = seed;
  return test_support::render(stripe);
}

Eigen::Matrix<double, 49, 3> templateMatrix(const Picture& picture, int block_u, int block_v)
{
  Eigen::Matrix<double, 49, 3> matrix;
  for (int i = 0; i < 49; ++i)
  {
    const int x = i % 7 - 3;
    const int y = i / 7 - 3;
    matrix.row(i) << x, y, picture.at(block_u + x, block_v + y);
  }
  return matrix;
}

TEST(SvdNormal, IsTheProjectionOfTheSmallestRightSingularVector)
{
  int compared = 0;
  for (const double degrees : { 0.0, 12.0, 31.0, 45.0, 60.0 })
  {
    const Picture picture = noisyStripe(degrees, 15.3, 11);
    for (int u = 5; u < 56; ++u)
    {
      const int v = static_cast<int>(std::lround(15.3 + u * std::tan(degrees * std::acos(-1.0) / 180.0)));
      const TemplateNormal normal = svdNormal(picture.view(), Levels{}, Block{ u, v });
      const Eigen::JacobiSVD<Eigen::Matrix<double, 49, 3>> svd(templateMatrix(picture, u, v), Eigen::ComputeFullV);
      ASSERT_TRUE(normal.defined);
      // 1e-9: the cosine of 3e-3 deg, a hundred times what the field notes saw on 4000 templates.
      EXPECT_NEAR(alike(normal, svd.matrixV().col(2).head<2>()), 1.0, 1e-9);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 5 * 51);
}

TEST(SvdNormal, IsUndefinedWhereTheTemplateIsSymmetric)
{
  Picture picture = test_support::blank(9, 9, 30.0);
  for (int u = 0; u < 9; ++u)
    picture.set(u, 4, 200.0);
  EXPECT_FALSE(svdNormal(picture.view(), Levels{}, Block{ 4, 4 }).defined);
  picture.set(4, 6, 31.0);
  const TemplateNormal normal = svdNormal(picture.view(), Levels{}, Block{ 4, 4 });
  ASSERT_TRUE(normal.defined) << "one grey level of asymmetry is above 1e-6 of |P|^2";
  EXPECT_NEAR(normal.v, 1.0, 1e-12);
}

TEST(SvdNormal, IsUndefinedUpToAMillionthOfTheMatrixsNorm)
{
  // Three rows of 250: |P|^2 = 392 + 21 * 62500 = 1312892, so the moment has to be larger than 1.31.
  Picture picture = test_support::blank(9, 9, 0.0);
  for (int v = 3; v <= 5; ++v)
    for (int u = 0; u < 9; ++u)
      picture.set(u, v, 250.0);
  picture.set(4, 5, 251.0);
  EXPECT_FALSE(svdNormal(picture.view(), Levels{}, Block{ 4, 4 }).defined) << "moment 1";
  picture.set(3, 5, 251.0);
  EXPECT_TRUE(svdNormal(picture.view(), Levels{}, Block{ 4, 4 }).defined) << "moment 2";
}

TEST(PcaNormal, IsTheSmallestEigenvectorOfTheWeightedCovariance)
{
  for (const double degrees : { 0.0, 20.0, 50.0 })
  {
    const Picture picture = noisyStripe(degrees, 14.8, 5);
    const int v = static_cast<int>(std::lround(14.8 + 30 * std::tan(degrees * std::acos(-1.0) / 180.0)));
    const Eigen::Matrix<double, 49, 3> points = templateMatrix(picture, 30, v);
    const Eigen::VectorXd weight = points.col(2) / points.col(2).sum();
    const Eigen::Vector2d mean = points.leftCols<2>().transpose() * weight;
    const Eigen::Matrix<double, 49, 2> centred = points.leftCols<2>().rowwise() - mean.transpose();
    const Eigen::Matrix2d covariance = centred.transpose() * weight.asDiagonal() * centred;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
    const TemplateNormal normal = pcaNormal(picture.view(), Levels{}, Block{ 30, v });
    ASSERT_TRUE(normal.defined);
    EXPECT_NEAR(alike(normal, solver.eigenvectors().col(0)), 1.0, 1e-9) << degrees << " deg";
  }
}

TEST(PcaNormal, IsUndefinedInAFlatTemplate)
{
  EXPECT_FALSE(pcaNormal(test_support::blank(9, 9, 30.0).view(), Levels{}, Block{ 4, 4 }).defined);
  EXPECT_FALSE(pcaNormal(test_support::blank(9, 9, 0.0).view(), Levels{}, Block{ 4, 4 }).defined);
}

TEST(Template, MustLieInsideTheImage)
{
  const Picture picture = test_support::blank(9, 8);
  EXPECT_TRUE(holdsTemplate(picture.view(), Block{ 3, 3 }));
  EXPECT_TRUE(holdsTemplate(picture.view(), Block{ 5, 4 }));
  EXPECT_FALSE(holdsTemplate(picture.view(), Block{ 2, 3 }));
  EXPECT_FALSE(holdsTemplate(picture.view(), Block{ 6, 4 }));
  EXPECT_FALSE(holdsTemplate(picture.view(), Block{ 5, 5 }));
}
}  // namespace
}  // namespace weld_profiler
