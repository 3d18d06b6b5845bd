#include <cmath>
#include <filesystem>
#include <fstream>

#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>
#include <opencv2/imgcodecs.hpp>

#include "support/collector.h"
#include "support/diagnostics_reader.h"
#include "support/in_process_manager.h"
#include "support/rig_feed.h"
#include "support/small_scene.h"
#include "support/temporary_folder.h"
#include "weld_profiler/SaveScan.h"
#include "weld_profiler/StripeProfile.h"
#include "weld_profiler/geometry/calibration_file.h"

namespace weld_profiler
{
namespace
{
/// Both nodelets of the chain, fed by the test.
class Chain
{
public:
  Chain(const std::string& name, int frames)
    : manager(name),
      feed(name, smallScene(frames)),
      triangulation(name + "/triangulation"),
      stripe(name + "/stripe_centre")
  {
    saveCalibration(feed.scan().calibration(), folder.file("calibration.yaml"));
    manager.set("triangulation", "calibration", folder.file("calibration.yaml"));
  }

  void load()
  {
    ASSERT_TRUE(manager.load("stripe_centre"));
    ASSERT_TRUE(manager.load("triangulation"));
    ASSERT_TRUE(waitFor([this] { return feed.connected(); }));
  }

  template <class Service>
  typename Service::Response call(const std::string& name, const typename Service::Request& request = {})
  {
    typename Service::Request copy = request;
    typename Service::Response response;
    EXPECT_TRUE(ros::service::call(manager.topic(name), copy, response)) << name;
    return response;
  }

  TemporaryFolder folder;
  InProcessManager manager;
  RigFeed feed;
  DiagnosticsReader triangulation;
  DiagnosticsReader stripe;
};

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

TEST(Nodelets, ScanOnRequestSaveItAndSayNoWhenThereIsNothing)
{
  Chain chain("/services", 12);
  chain.manager.set("triangulation", "auto_start", false);
  chain.load();
  const Collector<sensor_msgs::PointCloud2> scans(chain.manager.topic("scan_points"));
  const Collector<sensor_msgs::PointCloud2> profiles(chain.manager.topic("profile_points"));
  SaveScan::Request save;
  save.path = chain.folder.file("scan.pcd");
  EXPECT_FALSE(chain.call<SaveScan>("save_scan", save).success) << "there is no scan yet";
  EXPECT_FALSE(chain.call<std_srvs::Trigger>("stop_scan").success);

  chain.feed.publishFrame(0);
  ASSERT_TRUE(waitFor([&] { return profiles.size() == 1; })) << "live profiles before a scan";
  ASSERT_TRUE(chain.call<std_srvs::Trigger>("start_scan").success);
  for (int frame = 1; frame < 12; ++frame)
    chain.feed.publishFrame(frame);
  ASSERT_TRUE(waitFor([&] { return profiles.size() == 12; }));
  ASSERT_TRUE(chain.call<std_srvs::Trigger>("stop_scan").success);
  ASSERT_TRUE(waitFor([&] { return scans.size() > 0 && scans.all().back()->height == 11; }));
  EXPECT_EQ(scans.all().back()->width, 1440U);
  EXPECT_EQ(scans.all().back()->point_step, 32U);
  EXPECT_EQ(scans.all().back()->header.frame_id, "weld_profiler_scan");

  EXPECT_TRUE(chain.call<SaveScan>("save_scan", save).success);
  EXPECT_GT(std::filesystem::file_size(save.path), 11U * 1440U * 29U);
  save.format = "dwg";
  EXPECT_FALSE(chain.call<SaveScan>("save_scan", save).success);
  save.path = chain.folder.file("no/such/folder/scan.ply");
  save.format = "ply";
  EXPECT_FALSE(chain.call<SaveScan>("save_scan", save).success);
}

TEST(Nodelets, TheBalanceOfFramesClosesExactlyUnderOverload)
{
  Chain chain("/overload", 4);
  chain.manager.set("stripe_centre", "method", "steger");
  chain.manager.set("stripe_centre", "queue_size", 2);
  chain.load();
  const Collector<StripeProfile> stripes(chain.manager.topic("stripe"));
  std::vector<sensor_msgs::ImagePtr> prepared;
  for (int i = 0; i < 4; ++i)
    prepared.push_back(chain.feed.image(i));
  constexpr std::uint32_t kFrames = 400;
  const Stamp begin = chain.feed.scan().stamp(0);
  chain.feed.publishSample(begin - 1000, 0.0);
  for (std::uint32_t i = 0; i < kFrames; ++i)
  {
    auto image = boost::make_shared<sensor_msgs::Image>(*prepared[i % 4]);
    const Stamp stamp = begin + fromSeconds(0.001 * i);
    image->header.seq = i + 1;
    image->header.stamp = toRosTime(stamp);
    chain.feed.publish(image);
    chain.feed.publishSample(stamp + 1000, 1e-5 * (i + 1));
  }
  ASSERT_TRUE(
      waitFor([&] { return chain.stripe.count("frames in") == kFrames && chain.stripe.count("waiting") == 0; }));
  EXPECT_GT(chain.stripe.count("dropped"), 0U) << "there was no overload";
  EXPECT_EQ(chain.stripe.count("frames in"), chain.stripe.count("stripes out") + chain.stripe.count("dropped"));
  EXPECT_EQ(stripes.size(), chain.stripe.count("stripes out"));
  ASSERT_TRUE(waitFor([&] { return chain.triangulation.count("frames in") == stripes.size(); }));
  EXPECT_EQ(chain.triangulation.count("frames in"),
            chain.triangulation.count("rows") + chain.triangulation.count("no stripe") +
                chain.triangulation.count("skipped") + chain.triangulation.count("unplaced") +
                chain.triangulation.count("dropped") + chain.triangulation.count("waiting"));
}

TEST(Nodelets, AFrameWhoseCameraInfoDoesNotFitIsDroppedAndCounted)
{
  Chain chain("/mismatch", 3);
  Calibration other = chain.feed.scan().calibration();
  other.camera.fx *= 1.001;
  saveCalibration(other, chain.folder.file("calibration.yaml"));
  chain.load();
  for (int frame = 0; frame < 3; ++frame)
    chain.feed.publishFrame(frame);
  ASSERT_TRUE(waitFor([&] { return chain.triangulation.count("frames in") == 3; }));
  EXPECT_EQ(chain.triangulation.count("dropped camera_info"), 3U);
  EXPECT_EQ(chain.triangulation.count("rows"), 0U);
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
