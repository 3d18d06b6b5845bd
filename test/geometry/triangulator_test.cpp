#include "weld_profiler/geometry/triangulator.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include "geometry/random_rig.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/geometry/scan_frame.h"

using namespace weld_profiler;

namespace
{
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kHalfPi = 1.5707964F;

Stripe stripeOf(const StripePoint& point)
{
  Stripe stripe;
  stripe.status = StripeStatus::Ok;
  stripe.push_back(point);
  return stripe;
}

SensorProfile triangulate(const Calibration& rig, const Stripe& stripe)
{
  SensorProfile profile;
  Triangulator(rig).triangulate(stripe, profile);
  return profile;
}

/// The one point of a profile, in the scan frame at stage position 0.
Eigen::Vector3d inScanFrame(const Calibration& rig, float u, float v)
{
  const SensorProfile profile = triangulate(rig, stripeOf(StripePoint{ 0, u, v, kHalfPi, 10.0F, 2.0F, 0.1F, 0 }));
  EXPECT_EQ(profile.points.size(), 1u);
  return profile.points.empty() ? Eigen::Vector3d::Constant(kNan)
                                : ScanFrame(rig).scanTCamera(0.0) * profile.points[0].position;
}
}  // namespace

TEST(Triangulator, HasThePitchOfTheDefaultRig)
{
  const Calibration rig;
  const Eigen::Vector3d centre = inScanFrame(rig, 719.5F, 539.5F);
  EXPECT_LT(centre.norm(), 1e-12) << "the optical axis meets the plane in the origin";
  const Eigen::Vector3d right = inScanFrame(rig, 720.5F, 539.5F);
  EXPECT_TRUE(right.isApprox(Eigen::Vector3d(0.25 / 6000.0, 0.0, 0.0), 1e-9)) << "41.7 um a column, x to the right";
  const Eigen::Vector3d below = inScanFrame(rig, 719.5F, 540.5F);
  EXPECT_NEAR(below.z(), 83.3e-6, 0.1e-6) << "one row down in the image is 83.3 um toward the sensor";
  EXPECT_NEAR(below.x(), 0.0, 1e-12);
  EXPECT_NEAR(below.y(), 0.0, 1e-12) << "the stage moves along the plane's normal: height does not shift y";
}

TEST(Triangulator, AgreesWithTheClosedFormOfTheDefaultRig)
{
  // A point at height h above the origin is o + h z = (0, h/2, 0.25 - h cos 30): seen at v = cy + f (h/2) / depth.
  const Calibration rig;
  for (const double height : { -0.03, -0.01, 0.0, 0.002, 0.02 })
  {
    const double v = 539.5 + 6000.0 * 0.5 * height / (0.25 - height * 0.8660254037844386);
    EXPECT_NEAR(inScanFrame(rig, 719.5F, static_cast<float>(v)).z(), height, 6e-9)  // float rows: 6e-5 px
        << "height " << height;
  }
}

TEST(Triangulator, ReturnsPointsOfThePlaneThatOpenCvProjected)
{
  std::mt19937 generator(21);
  std::uniform_real_distribution<double> along(-0.02, 0.02);
  int inside = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Calibration rig = randomRig(generator);
    const Eigen::Vector3d n = normalOf(rig);
    const Eigen::Vector3d origin(0.0, 0.0, rig.laser_plane.distance / n.z());
    const Eigen::Vector3d t = n.unitOrthogonal();
    const Eigen::Vector3d p = origin + along(generator) * t + along(generator) * n.cross(t);
    const CameraCalibration& c = rig.camera;
    std::vector<cv::Point2d> pixel;
    cv::projectPoints(std::vector<cv::Point3d>{ { p.x(), p.y(), p.z() } }, cv::Vec3d(), cv::Vec3d(),
                      cv::Matx33d(c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0), c.distortion, pixel);
    if (pixel[0].x < 0.0 || pixel[0].x > 1439.0 || pixel[0].y < 0.0 || pixel[0].y > 1079.0)
      continue;
    ++inside;
    const SensorProfile profile = triangulate(
        rig, stripeOf(StripePoint{ 0, static_cast<float>(pixel[0].x), static_cast<float>(pixel[0].y), 0, 1, 1, 1, 0 }));
    ASSERT_EQ(profile.points.size(), 1u);
    EXPECT_LT((profile.points[0].position - p).norm(), 5e-7);  // 6e-5 px of a float, 0.2 mm/px on the flattest plane
    EXPECT_NEAR(n.dot(profile.points[0].position), rig.laser_plane.distance, 1e-12);
  }
  EXPECT_GT(inside, 100);
}

TEST(Triangulator, CarriesSigmaAcrossTheStripeToMetres)
{
  std::mt19937 generator(22);
  std::uniform_real_distribution<float> angle(-1.57F, 1.57F);
  std::uniform_real_distribution<float> u(100.0F, 1300.0F);
  std::uniform_real_distribution<float> v(100.0F, 900.0F);
  int compared = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Calibration rig = randomRig(generator);
    const StripePoint centre{ 0, u(generator), v(generator), angle(generator), 1.0F, 1.0F, 0.3F, 0 };
    const SensorProfile profile = triangulate(rig, stripeOf(centre));
    const auto moved = [&](float by)
    {
      StripePoint point = centre;
      point.u += by * std::cos(centre.normal_angle);
      point.v += by * std::sin(centre.normal_angle);
      return triangulate(rig, stripeOf(point));
    };
    const SensorProfile ahead = moved(0.5F);
    const SensorProfile behind = moved(-0.5F);
    if (profile.points.empty() || ahead.points.empty() || behind.points.empty() || profile.points[0].position.z() > 1.0)
      continue;
    ++compared;
    const Eigen::Vector3d numeric = 0.3 * (ahead.points[0].position - behind.points[0].position);
    const Eigen::Vector3d spread = profile.points[0].spread.cast<double>();
    EXPECT_LT((spread - numeric).norm(), 2e-3 * numeric.norm());  // second order over +-0.5 px, float pixels
  }
  EXPECT_GT(compared, 100);
}

TEST(Triangulator, GivesTheDefaultRig8MicrometresForATenthOfAPixel)
{
  const SensorProfile profile =
      triangulate(Calibration{}, stripeOf(StripePoint{ 0, 719.5F, 539.5F, kHalfPi, 1.0F, 1.0F, 0.1F, 0 }));
  ASSERT_EQ(profile.points.size(), 1u);
  const Eigen::Vector3d spread =
      ScanFrame(Calibration{}).scanTCamera(0.0).linear() * profile.points[0].spread.cast<double>();
  EXPECT_NEAR(std::abs(spread.z()), 8.333e-6, 1e-9);
  EXPECT_NEAR(spread.x(), 0.0, 1e-11);
}

TEST(Triangulator, KeepsCellIntensityFlagsAndOrder)
{
  Stripe stripe = stripeOf(StripePoint{ 3, 3.0F, 500.0F, kHalfPi, 77.0F, 2.0F, 0.1F, stripe_flag::kInterpolated });
  stripe.push_back(StripePoint{ 900, 900.0F, 501.0F, kHalfPi, 5.0F, 2.0F, 0.1F, 0 });
  const SensorProfile profile = triangulate(Calibration{}, stripe);
  EXPECT_EQ(profile.cells, 1440u);
  ASSERT_EQ(profile.points.size(), 2u);
  EXPECT_EQ(profile.points[0].cell, 3);
  EXPECT_EQ(profile.points[0].intensity, 77.0F);
  EXPECT_EQ(profile.points[0].flags, stripe_flag::kInterpolated);
  EXPECT_EQ(profile.points[1].cell, 900);
}

TEST(Triangulator, HasACellForEachRowWhenTheStripeRunsAlongTheColumns)
{
  Stripe stripe = stripeOf(StripePoint{ 1079, 3.0F, 500.0F, 0.0F, 77.0F, 2.0F, 0.1F, 0 });
  stripe.direction = Direction::AlongV;
  const SensorProfile profile = triangulate(Calibration{}, stripe);
  EXPECT_EQ(profile.cells, 1080u);
  EXPECT_EQ(profile.direction, Direction::AlongV);
}

TEST(Triangulator, LeavesOutWhatIsNotFinite)
{
  const StripePoint good{ 0, 700.0F, 500.0F, kHalfPi, 1.0F, 1.0F, 0.1F, 0 };
  for (float StripePoint::*field :
       { &StripePoint::u, &StripePoint::v, &StripePoint::sigma, &StripePoint::normal_angle, &StripePoint::intensity })
    for (const float bad : { kNan, std::numeric_limits<float>::infinity() })
    {
      StripePoint point = good;
      point.*field = bad;
      EXPECT_TRUE(triangulate(Calibration{}, stripeOf(point)).points.empty());
    }
  EXPECT_EQ(triangulate(Calibration{}, stripeOf(good)).points.size(), 1u);
}

TEST(Triangulator, LeavesOutARayThatDoesNotMeetThePlaneInFrontOfTheCamera)
{
  Calibration rig;
  rig.camera.fx = rig.camera.fy = 600.0;  // 42 deg up: the ray and the 30 deg plane part
  const auto count = [&](float v) {
    return triangulate(rig, stripeOf(StripePoint{ 0, 719.5F, v, kHalfPi, 1.0F, 1.0F, 0.1F, 0 })).points.size();
  };
  const float parallel = 539.5F - 600.0F * 0.57735027F;  // tan 30 deg
  EXPECT_EQ(count(parallel + 5.0F), 1u);
  EXPECT_EQ(count(parallel - 5.0F), 0u);
  EXPECT_EQ(count(parallel), 0u);
}

TEST(Triangulator, RefusesAStripeWhoseArraysOrCellsAreWrong)
{
  const Triangulator triangulator{ Calibration{} };
  SensorProfile profile;
  Stripe ragged = stripeOf(StripePoint{});
  ragged.v.push_back(1.0F);
  EXPECT_THROW(triangulator.triangulate(ragged, profile), PreconditionError);
  EXPECT_THROW(triangulator.triangulate(stripeOf(StripePoint{ 1440, 0, 0, 0, 0, 0, 0, 0 }), profile),
               PreconditionError);
  Stripe twice = stripeOf(StripePoint{});
  twice.push_back(StripePoint{});
  EXPECT_THROW(triangulator.triangulate(twice, profile), PreconditionError);
}

TEST(Triangulator, RefusesAnUnusableCalibration)
{
  Calibration rig;
  rig.laser_plane.normal = { { 0.0, 0.0, 0.0 } };
  EXPECT_THROW(Triangulator{ rig }, ConfigError);
}
