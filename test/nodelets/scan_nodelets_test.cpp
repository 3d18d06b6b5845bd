#include <filesystem>

#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>

#include "support/chain_under_test.h"
#include "support/collector.h"
#include "weld_profiler/SaveScan.h"
#include "weld_profiler/StripeProfile.h"

namespace weld_profiler
{
namespace
{
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
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "scan_nodelets_test");
  const ros::NodeHandle node;  // keeps the node up while managers come and go
  return RUN_ALL_TESTS();
}
