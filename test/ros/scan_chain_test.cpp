#include <gtest/gtest.h>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/messages.h"
#include "weld_profiler/ros/scan_chain.h"

namespace weld_profiler
{
namespace
{
/// A chain for the default rig and stripes of one flat line through the image's middle.
class ScanChainTest : public ::testing::Test
{
protected:
  ScanChainTest()
  {
    ScanBuilder::Sinks sinks;
    sinks.on_profile = [this](const Profile& profile) { profiles_.push_back(profile); };
    chain_ = std::make_unique<ScanChain>(ScanChainParams(), Calibration(), transforms_, std::move(sinks));
  }

  StripeProfile stripe(double seconds, std::size_t centres = 100) const
  {
    StripeProfile message;
    message.header.stamp = toRosTime(fromSeconds(seconds));
    message.image_width = 1440;
    message.image_height = 1080;
    for (std::size_t i = 0; i < centres; ++i)
    {
      message.cell.push_back(static_cast<std::uint16_t>(i + 600));
      message.u.push_back(static_cast<float>(i + 600));
      message.v.push_back(539.5F);
      message.normal_angle.push_back(1.5707963F);
      message.intensity.push_back(100.0F);
      message.stripe_width.push_back(2.0F);
      message.sigma.push_back(0.03F);
      message.flags.push_back(0);
    }
    return message;
  }

  void encoder(double seconds, double position)
  {
    chain_->addJoints(jointStateMessage(fromSeconds(seconds), "stage_joint", position));
  }

  tf2::BufferCore transforms_;
  std::vector<Profile> profiles_;
  std::unique_ptr<ScanChain> chain_;
};

TEST_F(ScanChainTest, PlacesAProfileWhereTheEncoderWasAtItsStamp)
{
  encoder(1.00, 0.010);
  chain_->addStripe(stripe(1.01));
  EXPECT_TRUE(profiles_.empty()) << "placed before it was bracketed";
  encoder(1.02, 0.012);
  ASSERT_EQ(profiles_.size(), 1U);
  EXPECT_NEAR(profiles_[0].stage, 0.011, 1e-12);
  ASSERT_EQ(profiles_[0].points.size(), 100U);
  EXPECT_NEAR(profiles_[0].points[0].y, 0.011, 1e-7);
  EXPECT_NEAR(profiles_[0].points[0].z, 0.0, 1e-6) << "the optical axis meets the plane at z = 0";
  EXPECT_NEAR(profiles_[0].points[0].sigma, 0.03 * 83.3e-6, 2e-7) << "a pixel row is 83.3 um in z";
}

TEST_F(ScanChainTest, RefusesAnImageOfAnotherSizeAndSaysBoth)
{
  StripeProfile other = stripe(1.0);
  other.image_width = 640;
  chain_->addStripe(other);
  EXPECT_EQ(chain_->builder().balance().dropped.at("image_size"), 1U);
  const std::string problem = chain_->takeProblem();
  EXPECT_NE(problem.find("640"), std::string::npos);
  EXPECT_NE(problem.find("1440"), std::string::npos);
}

TEST_F(ScanChainTest, RefusesACameraInfoThatDoesNotFitAndTakesItWhenItDoes)
{
  sensor_msgs::CameraInfo info = cameraInfoMessage(CameraCalibration());
  info.K[0] = 5000.0;
  chain_->addCameraInfo(info);
  chain_->addStripe(stripe(1.0));
  EXPECT_EQ(chain_->builder().balance().dropped.at("camera_info"), 1U);
  chain_->addCameraInfo(cameraInfoMessage(CameraCalibration()));
  chain_->addStripe(stripe(1.1));
  EXPECT_EQ(chain_->builder().balance().droppedTotal(), 1U);
}

TEST_F(ScanChainTest, WithUseCameraInfoTheInfoDecides)
{
  ScanChainParams params;
  params.use_camera_info = true;
  ScanChain chain(params, Calibration(), transforms_, {});
  CameraCalibration camera;
  camera.fx = camera.fy = 3000.0;
  chain.addCameraInfo(cameraInfoMessage(camera));
  chain.addStripe(stripe(1.0));
  EXPECT_EQ(chain.builder().balance().droppedTotal(), 0U);
}

TEST_F(ScanChainTest, CountsAStripeWhoseArraysDoNotFit)
{
  StripeProfile broken = stripe(1.0);
  broken.v.pop_back();
  chain_->addStripe(broken);
  StripeProfile falling = stripe(1.0);
  std::swap(falling.cell[3], falling.cell[4]);
  chain_->addStripe(falling);
  EXPECT_EQ(chain_->builder().balance().dropped.at("bad_message"), 2U);
}

TEST_F(ScanChainTest, AJointThatIsNotThereIsSaid)
{
  EXPECT_FALSE(chain_->addJoints(jointStateMessage(1, "other_joint", 0.0)));
  sensor_msgs::JointState without_position = jointStateMessage(1, "stage_joint", 0.0);
  without_position.position.clear();
  EXPECT_FALSE(chain_->addJoints(without_position));
}

TEST_F(ScanChainTest, RefusesParametersOutOfRange)
{
  const auto refuses = [this](auto change)
  {
    ScanChainParams params;
    change(params);
    EXPECT_THROW(ScanChain(params, Calibration(), transforms_, {}), ConfigError);
  };
  refuses([](ScanChainParams& p) { p.motion = "walk"; });
  refuses([](ScanChainParams& p) { p.motion = "tf"; });
  refuses([](ScanChainParams& p) { p.scan_frame = ""; });
  refuses([](ScanChainParams& p) { p.encoder.max_encoder_gap = -1.0; });
  refuses([](ScanChainParams& p) { p.scan.trigger = "never"; });
}
}  // namespace
}  // namespace weld_profiler
