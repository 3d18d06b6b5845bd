#include "weld_profiler/geometry/camera_model.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include "weld_profiler/core/errors.h"

using weld_profiler::CameraCalibration;
using weld_profiler::CameraModel;
using weld_profiler::ConfigError;

namespace
{
CameraCalibration camera(double focal, std::array<double, 5> distortion)
{
  CameraCalibration c;
  c.fx = focal;
  c.fy = focal * 1.01;
  c.cx = 700.3;
  c.cy = 551.8;
  c.distortion = distortion;
  return c;
}

/// From none to far beyond a machine-vision lens: at focal 900 the corner lies 45 deg off the axis.
const std::vector<CameraCalibration>& cameras()
{
  static const std::vector<CameraCalibration> all = {
    camera(6000.0, { { 0.0, 0.0, 0.0, 0.0, 0.0 } }),       camera(2500.0, { { -0.12, 0.3, 1e-3, -2e-3, 0.1 } }),
    camera(900.0, { { -0.28, 0.09, 2e-3, 1e-3, -0.01 } }), camera(900.0, { { 0.35, 0.2, -3e-3, 4e-3, 0.1 } }),
    camera(1200.0, { { -0.1, 0.0, 0.03, -0.03, 0.0 } }),
  };
  return all;
}

/// The oracle: OpenCV's projection.
std::vector<cv::Point2d> openCvProject(const CameraCalibration& c, const std::vector<Eigen::Vector2d>& rays)
{
  std::vector<cv::Point3d> points;
  for (const Eigen::Vector2d& ray : rays)
    points.emplace_back(ray.x(), ray.y(), 1.0);
  const cv::Matx33d k(c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0);
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), k, c.distortion, pixels);
  return pixels;
}

std::vector<Eigen::Vector2d> randomPixels(const CameraModel& model, int count)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> u(-0.5, model.width() - 0.5);
  std::uniform_real_distribution<double> v(-0.5, model.height() - 0.5);
  std::vector<Eigen::Vector2d> pixels = { { -0.5, -0.5 }, { model.width() - 0.5, model.height() - 0.5 }, { 0.0, 0.0 } };
  for (int i = 0; i < count; ++i)
    pixels.emplace_back(u(generator), v(generator));
  return pixels;
}

class EveryCamera : public ::testing::TestWithParam<CameraCalibration>
{
};
}  // namespace

TEST_P(EveryCamera, ProjectsAsOpenCvDoes)
{
  const CameraModel model(GetParam());
  std::vector<Eigen::Vector2d> rays;
  for (const Eigen::Vector2d& pixel : randomPixels(model, 500))
    rays.push_back(model.ray(pixel.x(), pixel.y()));
  const auto expected = openCvProject(GetParam(), rays);
  ASSERT_EQ(expected.size(), 503u);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const Eigen::Vector2d pixel = model.project(rays[i]);
    EXPECT_NEAR(pixel.x(), expected[i].x, 1e-9);  // rounding of a few thousand pixels
    EXPECT_NEAR(pixel.y(), expected[i].y, 1e-9);
  }
}

TEST_P(EveryCamera, SendsTheRayThroughThePixelWithinABillionth)
{
  const CameraModel model(GetParam());
  const auto pixels = randomPixels(model, 20000);
  std::vector<Eigen::Vector2d> rays;
  for (const Eigen::Vector2d& pixel : pixels)
    rays.push_back(model.ray(pixel.x(), pixel.y()));
  const auto seen = openCvProject(GetParam(), rays);
  ASSERT_EQ(seen.size(), pixels.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    worst = std::max(
        worst, std::hypot((seen[i].x - pixels[i].x()) / GetParam().fx, (seen[i].y - pixels[i].y()) / GetParam().fy));
  EXPECT_LT(worst, 1e-9);
}

TEST_P(EveryCamera, FindsTheRayThatOpenCvFinds)
{
  const CameraModel model(GetParam());
  std::vector<cv::Point2d> pixels;
  for (const Eigen::Vector2d& pixel : randomPixels(model, 300))
    if (std::abs(pixel.x() - 720.0) < 350.0 && std::abs(pixel.y() - 540.0) < 250.0)
      pixels.emplace_back(pixel.x(), pixel.y());  // OpenCV's fixed-point iteration does not converge in every corner
  ASSERT_GT(pixels.size(), 30u);
  const CameraCalibration& c = GetParam();
  const cv::Matx33d k(c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0);
  std::vector<cv::Point2d> expected;
  cv::undistortPoints(pixels, expected, k, c.distortion, cv::noArray(), cv::noArray(),
                      cv::TermCriteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 500, 1e-14));
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    const Eigen::Vector2d ray = model.ray(pixels[i].x, pixels[i].y);
    EXPECT_NEAR(ray.x(), expected[i].x, 1e-9);
    EXPECT_NEAR(ray.y(), expected[i].y, 1e-9);
  }
}

TEST_P(EveryCamera, KnowsHowTheRayTurnsWithThePixel)
{
  const CameraModel model(GetParam());
  const double step = 0.01;
  for (const Eigen::Vector2d& p : randomPixels(model, 200))
  {
    const CameraModel::Ray ray = model.rayWithSlope(p.x(), p.y());
    Eigen::Matrix2d numeric;
    numeric.col(0) = (model.ray(p.x() + step, p.y()) - model.ray(p.x() - step, p.y())) / (2.0 * step);
    numeric.col(1) = (model.ray(p.x(), p.y() + step) - model.ray(p.x(), p.y() - step)) / (2.0 * step);
    EXPECT_LT((ray.slope - numeric).norm(), 1e-4 * numeric.norm());  // first order: the start's Jacobian is good enough
  }
}

TEST_P(EveryCamera, SolvesInFullOutsideTheImage)
{
  const CameraModel model(GetParam());
  for (const Eigen::Vector2d& pixel : { Eigen::Vector2d(-30.0, 500.0), Eigen::Vector2d(1460.0, -12.0) })
    EXPECT_LT((model.project(model.ray(pixel.x(), pixel.y())) - pixel).norm(), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(NoneToExtreme, EveryCamera, ::testing::ValuesIn(cameras()));

TEST(CameraModel, ShiftsByTheRegionOfInterest)
{
  CameraCalibration cut = cameras()[1];
  cut.roi_x = 200;
  cut.roi_y = 300;
  cut.roi_width = 640;
  cut.roi_height = 480;
  const CameraModel whole(cameras()[1]);
  const CameraModel model(cut);
  EXPECT_EQ(model.width(), 640);
  EXPECT_EQ(model.height(), 480);
  EXPECT_LT((model.ray(10.25, 20.5) - whole.ray(210.25, 320.5)).norm(), 1e-12);
  EXPECT_LT((model.project(whole.ray(250.0, 330.0)) - Eigen::Vector2d(50.0, 30.0)).norm(), 1e-8);
}

TEST(CameraModel, TakesTheMiddleOfTheSensorPixelsThatABinnedPixelMerges)
{
  CameraCalibration binned = cameras()[1];
  binned.roi_x = 100;
  binned.roi_width = 1200;
  binned.roi_height = 1080;
  binned.binning_x = 2;
  binned.binning_y = 4;
  const CameraModel whole(cameras()[1]);
  const CameraModel model(binned);
  EXPECT_EQ(model.width(), 600);
  EXPECT_EQ(model.height(), 270);
  EXPECT_LT((model.ray(0.0, 0.0) - whole.ray(100.5, 1.5)).norm(), 1e-12);
  EXPECT_LT((model.ray(33.0, 50.0) - whole.ray(166.5, 201.5)).norm(), 1e-10);
  EXPECT_LT((model.project(whole.ray(166.5, 201.5)) - Eigen::Vector2d(33.0, 50.0)).norm(), 1e-8);
}

TEST(CameraModel, AnswersNanForAPixelThatIsNotFinite)
{
  const CameraModel model(cameras()[2]);
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    EXPECT_TRUE(std::isnan(model.ray(bad, 10.0).x()));
    EXPECT_TRUE(std::isnan(model.ray(10.0, bad).y()));
  }
}

TEST(CameraModel, RefusesADistortionThatFoldsTheImage)
{
  try
  {
    CameraModel model(camera(900.0, { { -0.9, 0.0, 0.0, 0.0, 0.0 } }));
    FAIL() << "the corner has no ray";
  }
  catch (const ConfigError& error)
  {
    EXPECT_NE(std::string(error.what()).find("distortion_coefficients"), std::string::npos) << error.what();
  }
}
