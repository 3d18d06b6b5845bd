#include <cmath>
#include <fstream>

#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>
#include <opencv2/imgcodecs.hpp>

#include "support/chain_under_test.h"
#include "support/collector.h"
#include "weld_profiler/StripeProfile.h"

namespace weld_profiler
{
namespace
{
TEST(Nodelets, EachUnloadsInLessThanASecondAndLoadsAgain)
{
  Chain chain("/reload", 3);
  chain.manager.set("camera", "images", chain.folder.file("*.png"));
  cv::imwrite(chain.folder.file("one.png"), cv::Mat(240, 1440, CV_8UC1, cv::Scalar(10)));
  chain.manager.set("camera", "loop", true);
  chain.manager.set("simulated_rig", "wait_for_subscriber", false);
  for (const std::string name : { "camera", "simulated_rig", "stripe_centre", "triangulation" })
  {
    for (int turn = 0; turn < 3; ++turn)
    {
      ASSERT_TRUE(chain.manager.load(name)) << name << ", turn " << turn;
      ros::WallDuration(0.1).sleep();
      const ros::WallTime begin = ros::WallTime::now();
      ASSERT_TRUE(chain.manager.unload(name)) << name << ", turn " << turn;
      EXPECT_LT((ros::WallTime::now() - begin).toSec(), 1.0) << name;  // the promise of the architecture, not a timing
    }
  }
  EXPECT_TRUE(chain.manager.loaded().empty());
}

TEST(Nodelets, AChainWorksAgainAfterItsNodeletsWereReloadedInMidScan)
{
  Chain chain("/reload_in_scan", 12);
  chain.load();
  const Collector<StripeProfile> stripes(chain.manager.topic("stripe"));
  const Collector<sensor_msgs::PointCloud2> profiles(chain.manager.topic("profile_points"));
  for (int frame = 0; frame < 4; ++frame)
    chain.feed.publishFrame(frame);
  for (const std::string name : { "stripe_centre", "triangulation" })
  {
    ASSERT_TRUE(chain.manager.unload(name)) << "with frames under way";
    ASSERT_TRUE(chain.manager.load(name));
  }
  ASSERT_TRUE(
      waitFor([&] { return chain.feed.connected() && stripes.publishers() == 1 && profiles.publishers() == 1; }));
  const std::size_t before = profiles.size();
  for (int frame = 4; frame < 12; ++frame)
    chain.feed.publishFrame(frame);
  EXPECT_TRUE(waitFor([&] { return profiles.size() >= before + 8; }));
  EXPECT_GT(profiles.all().back()->width, 1000U);
}

TEST(Nodelets, RefuseToLoadWithABadConfigurationAndTheManagerLivesOn)
{
  Chain chain("/refuse", 3);
  InProcessManager& manager = chain.manager;
  manager.set("stripe_centre", "method", "gray_center");
  EXPECT_FALSE(manager.load("stripe_centre"));
  manager.set("stripe_centre", "method", "squared_centroid");
  manager.set("stripe_centre", "min_peak_counts", "many");
  EXPECT_FALSE(manager.load("stripe_centre")) << "wrong type";
  manager.set("stripe_centre", "min_peak_counts", std::nan(""));
  EXPECT_FALSE(manager.load("stripe_centre")) << "NaN";
  manager.set("stripe_centre", "min_peak_counts", 10.0);
  EXPECT_TRUE(manager.load("stripe_centre"));

  manager.set("triangulation", "calibration", chain.folder.file("nowhere.yaml"));
  EXPECT_FALSE(manager.load("triangulation")) << "missing file";
  std::ofstream(chain.folder.file("broken.yaml"))
      << "version: 1\n"
         "camera: {image_width: 1440, image_height: 1080, camera_matrix: [6000, 0, 719.5, 0, 6000, 539.5, 0, 0, 1], "
         "distortion_model: plumb_bob, distortion_coefficients: [0, 0, 0, 0, 0]}\n"
         "laser_plane: {normal: [0, 0, 0], distance: 0.125}\n"
         "stage: {type: linear, joint: stage_joint, axis: [0, -0.8660254, -0.5], metres_per_unit: 1}\n";
  manager.set("triangulation", "calibration", chain.folder.file("broken.yaml"));
  EXPECT_FALSE(manager.load("triangulation")) << "normal of length zero";
  manager.set("triangulation", "calibration", chain.folder.file("calibration.yaml"));
  manager.set("triangulation", "motion", "tf");
  EXPECT_FALSE(manager.load("triangulation")) << "no fixed_frame";
  manager.set("triangulation", "motion", "stage");
  EXPECT_TRUE(manager.load("triangulation"));

  manager.set("camera", "images", chain.folder.file("none/*.png"));
  EXPECT_FALSE(manager.load("camera")) << "no images";
  manager.set("simulated_rig", "scene", "surrealistic");
  EXPECT_FALSE(manager.load("simulated_rig"));
}

TEST(Nodelets, AnOperatorTurnsKnobsLiveAndABadSettingChangesNothing)
{
  Chain chain("/knobs", 3);
  chain.load();
  const Collector<StripeProfile> stripes(chain.manager.topic("stripe"));
  const auto set = [&](const dynamic_reconfigure::Config& config)
  {
    dynamic_reconfigure::Reconfigure call;
    call.request.config = config;
    EXPECT_TRUE(ros::service::call(chain.manager.topic("stripe_centre/set_parameters"), call));
    return call.response.config;
  };
  dynamic_reconfigure::Config method;
  method.strs.resize(1);
  method.strs[0].name = "method";
  method.strs[0].value = "svd";
  set(method);
  chain.feed.publishFrame(0);
  ASSERT_TRUE(waitFor([&] { return stripes.size() == 1; }));
  EXPECT_EQ(stripes.all().back()->method, "svd");

  dynamic_reconfigure::Config widths;
  widths.doubles.resize(2);
  widths.doubles[0].name = "min_stripe_width_px";
  widths.doubles[0].value = 9.0;
  widths.doubles[1].name = "max_stripe_width_px";
  widths.doubles[1].value = 2.0;
  for (const auto& value : set(widths).doubles)
  {
    if (value.name == "min_stripe_width_px")
    {
      EXPECT_EQ(value.value, 0.5) << "refused, and the server says what holds";
    }
  }
  chain.feed.publishFrame(1);
  ASSERT_TRUE(waitFor([&] { return stripes.size() == 2; }));
  EXPECT_GT(stripes.all().back()->cell.size(), 1000U);
}

TEST(Nodelets, TheOverlayIsDrawnOnlyWhileSomebodyLooks)
{
  Chain chain("/overlay", 3);
  chain.load();
  const Collector<StripeProfile> stripes(chain.manager.topic("stripe"));
  chain.feed.publishFrame(0);
  ASSERT_TRUE(waitFor([&] { return stripes.size() == 1; }));
  const Collector<sensor_msgs::Image> overlays(chain.manager.topic("stripe_image"));
  ASSERT_TRUE(waitFor([&] { return overlays.publishers() == 1; }));
  chain.feed.publishFrame(1);
  ASSERT_TRUE(waitFor([&] { return overlays.size() == 1; }));
  const auto overlay = overlays.all().front();
  EXPECT_EQ(overlay->encoding, "bgr8");
  EXPECT_EQ(overlay->width, 1440U);
  std::size_t blue = 0;
  for (std::size_t i = 0; i + 2 < overlay->data.size(); i += 3)
    blue += overlay->data[i] > 200 && overlay->data[i + 1] < 100 && overlay->data[i + 2] < 100 ? 1 : 0;
  EXPECT_GT(blue, 300U) << "exact points are blue";
}

TEST(Nodelets, ABrokenImageIsDroppedAndTheNextOneIsServed)
{
  Chain chain("/broken", 3);
  chain.load();
  const Collector<StripeProfile> stripes(chain.manager.topic("stripe"));
  const auto empty = boost::make_shared<sensor_msgs::Image>();
  empty->header.seq = 1;
  chain.feed.publish(empty);
  auto unknown = chain.feed.image(0);
  unknown->encoding = "infrared9";
  unknown->header.seq = 2;
  chain.feed.publish(unknown);
  auto short_of_pixels = chain.feed.image(0);
  short_of_pixels->data.resize(100);
  short_of_pixels->header.seq = 3;
  chain.feed.publish(short_of_pixels);
  auto good = chain.feed.image(1);
  good->header.seq = 4;
  chain.feed.publish(good);
  ASSERT_TRUE(waitFor([&] { return stripes.size() == 1; }));
  EXPECT_GT(stripes.all().front()->cell.size(), 1000U);
  ASSERT_TRUE(waitFor([&] { return chain.stripe.count("dropped bad_image") == 3; }));
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelets_test");
  const ros::NodeHandle node;  // keeps the node up while managers come and go
  return RUN_ALL_TESTS();
}
