#include "weld_profiler/geometry/scan_frame.h"

#include <random>

#include <gtest/gtest.h>

#include "geometry/random_rig.h"

using weld_profiler::Calibration;
using weld_profiler::ScanFrame;

TEST(ScanFrame, IsTheDefaultRigsByHand)
{
  const Eigen::Isometry3d frame = ScanFrame(Calibration{}).cameraTScan(0.0);
  const double c30 = 0.8660254037844386;
  EXPECT_TRUE(frame.linear().col(0).isApprox(Eigen::Vector3d(1.0, 0.0, 0.0), 1e-12)) << "x to the right in the image";
  EXPECT_TRUE(frame.linear().col(1).isApprox(Eigen::Vector3d(0.0, -c30, -0.5), 1e-12)) << "y = the stage axis";
  EXPECT_TRUE(frame.linear().col(2).isApprox(Eigen::Vector3d(0.0, 0.5, -c30), 1e-12)) << "z toward the sensor";
  EXPECT_TRUE(frame.translation().isApprox(Eigen::Vector3d(0.0, 0.0, 0.25), 1e-12));
}

TEST(ScanFrame, IsRightHandedAndLooksTowardTheSensor)
{
  std::mt19937 generator(11);
  for (int i = 0; i < 200; ++i)
  {
    const Calibration rig = randomRig(generator);
    const Eigen::Isometry3d frame = ScanFrame(rig).cameraTScan(0.3);
    const Eigen::Matrix3d& r = frame.linear();
    EXPECT_LT((r.transpose() * r - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(r.determinant(), 1.0, 1e-12);
    EXPECT_LT(r(2, 2), 0.0) << "z points against the optical axis";
    EXPECT_LT((r.col(1) - axisOf(rig)).norm(), 1e-12);
    EXPECT_TRUE((ScanFrame(rig).scanTCamera(0.3) * frame).matrix().isIdentity(1e-12));
  }
}

TEST(ScanFrame, PutsTheOriginWhereTheOpticalAxisMeetsTheLaserPlane)
{
  std::mt19937 generator(12);
  for (int i = 0; i < 50; ++i)
  {
    const Calibration rig = randomRig(generator);
    const Eigen::Vector3d origin = ScanFrame(rig).cameraTScan(0.0).translation();
    EXPECT_EQ(origin.head<2>(), Eigen::Vector2d::Zero());
    EXPECT_NEAR(normalOf(rig).dot(origin), rig.laser_plane.distance, 1e-12);
    EXPECT_GT(origin.z(), 0.0);
  }
}

TEST(ScanFrame, KeepsAPointOfThePartInPlaceWhileTheSensorMoves)
{
  std::mt19937 generator(13);
  for (int i = 0; i < 50; ++i)
  {
    const Calibration rig = randomRig(generator);
    const ScanFrame frame(rig);
    const Eigen::Vector3d at_start(0.01, -0.02, 0.3);  // camera frame, stage position 0
    for (const double stage : { -0.04, 0.0, 0.05 })
    {
      // the sensor moved by stage along the axis: what stands still comes toward it
      const Eigen::Vector3d seen = at_start - stage * axisOf(rig);
      EXPECT_LT((frame.scanTCamera(stage) * seen - frame.scanTCamera(0.0) * at_start).norm(), 1e-12);
    }
  }
}

TEST(ScanFrame, KeepsAPointOfAPartThatMovesUnderAFixedSensor)
{
  const Eigen::Vector3d d(0.0, 0.8660254037844386, 0.5);  // the part moves along d: axis = -d
  Calibration rig;
  rig.stage.axis = { { -d.x(), -d.y(), -d.z() } };
  const ScanFrame frame(rig);
  const Eigen::Vector3d at_start(0.01, -0.02, 0.3);
  for (const double stage : { -0.04, 0.05 })
    EXPECT_LT((frame.scanTCamera(stage) * (at_start + stage * d) - frame.scanTCamera(0.0) * at_start).norm(), 1e-12);
}

TEST(ScanFrame, TurnsByHalfATurnAboutZWhenTheAxisIsReversed)
{
  std::mt19937 generator(14);
  for (int i = 0; i < 50; ++i)
  {
    const Calibration rig = randomRig(generator);
    Calibration reversed = rig;
    for (double& component : reversed.stage.axis)
      component = -component;
    const Eigen::Vector3d seen(0.02, 0.01, 0.27);
    const Eigen::Vector3d p = ScanFrame(rig).scanTCamera(0.0) * seen;
    const Eigen::Vector3d q = ScanFrame(reversed).scanTCamera(0.0) * seen;
    EXPECT_LT((q - Eigen::Vector3d(-p.x(), -p.y(), p.z())).norm(), 1e-12);
    // and at any stage position: the reversed axis counts the same motion the other way
    const Eigen::Vector3d later = ScanFrame(reversed).scanTCamera(-0.03) * seen;
    const Eigen::Vector3d same = ScanFrame(rig).scanTCamera(0.03) * seen;
    EXPECT_LT((later - Eigen::Vector3d(-same.x(), -same.y(), same.z())).norm(), 1e-12);
  }
}
