#include <filesystem>
#include <map>

#include <gtest/gtest.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/UInt64MultiArray.h>
#include <opencv2/imgcodecs.hpp>

#include "support/collector.h"
#include "support/in_process_manager.h"
#include "support/small_scene.h"
#include "weld_profiler/StripeProfile.h"
#include "weld_profiler/geometry/calibration_file.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;
constexpr int kImages = 20;

/// A folder with the images of a simulated scan and its calibration.
class ImageFolder
{
public:
  ImageFolder() : path_(fs::temp_directory_path() / ("weld_profiler_zero_copy_" + std::to_string(::getpid())))
  {
    fs::create_directories(path_);
    const SimulatedScan scan(smallScene(kImages));
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < kImages; ++i)
    {
      scan.render(i, pixels);
      cv::imwrite((path_ / ("frame" + std::to_string(i) + ".png")).string(),
                  cv::Mat(scan.height(), scan.width(), CV_8UC1, pixels.data(), scan.step()));
    }
    saveCalibration(scan.calibration(), calibration());
  }
  ~ImageFolder() { fs::remove_all(path_); }

  std::string images() const { return (path_ / "*.png").string(); }
  std::string calibration() const { return (path_ / "calibration.yaml").string(); }

private:
  fs::path path_;
};

using Trace = std::map<std::uint64_t, std::uint64_t>;  // frame -> address of its pixels

Trace trace(const Collector<std_msgs::UInt64MultiArray>& collector)
{
  Trace addresses;
  for (const auto& message : collector.all())
    addresses[message->data.at(0)] = message->data.at(1);
  return addresses;
}

TEST(ZeroCopy, TheStripeNodeletReadsTheVeryPixelsThatTheCameraPublished)
{
  const ImageFolder folder;
  InProcessManager manager("/zero_copy");
  const Collector<sensor_msgs::Image> images(manager.topic("image_raw"));
  const Collector<std_msgs::UInt64MultiArray> published(manager.topic("pixels_published"));
  const Collector<std_msgs::UInt64MultiArray> read(manager.topic("pixels_read"));
  const Collector<StripeProfile> stripes(manager.topic("stripe"));

  manager.set("stripe_centre", "trace_pixels", true);
  manager.set("triangulation", "calibration", folder.calibration());
  manager.set("camera", "trace_pixels", true);
  manager.set("camera", "images", folder.images());
  manager.set("camera", "calibration", folder.calibration());
  manager.set("camera", "rate", 20.0);
  manager.set("camera", "loop", true);
  ASSERT_TRUE(manager.load("stripe_centre"));
  ASSERT_TRUE(manager.load("triangulation"));
  ASSERT_TRUE(manager.load("camera"));
  ASSERT_TRUE(waitFor([&] { return stripes.size() >= kImages && read.size() >= kImages; }));

  const Trace sent = trace(published);
  const Trace seen = trace(read);
  Trace received;  // this test's own subscription keeps every image alive: no address can have been used twice
  for (const auto& image : images.all())
    received[image->header.seq] = reinterpret_cast<std::uintptr_t>(image->data.data());
  std::size_t compared = 0;
  for (const auto& frame : seen)
  {
    if (sent.count(frame.first) == 0 || received.count(frame.first) == 0)
      continue;
    EXPECT_EQ(frame.second, sent.at(frame.first)) << "frame " << frame.first << " was copied on its way";
    EXPECT_EQ(frame.second, received.at(frame.first)) << "frame " << frame.first;
    ++compared;
  }
  EXPECT_GE(compared, 15U);
}

TEST(ZeroCopy, StripesReachTheirSubscribersInThePublishersMemory)
{
  const ImageFolder folder;
  InProcessManager manager("/zero_copy_stripes");
  const Collector<StripeProfile> first(manager.topic("stripe"));
  const Collector<StripeProfile> second(manager.topic("stripe"));
  manager.set("camera", "images", folder.images());
  manager.set("camera", "rate", 20.0);
  ASSERT_TRUE(manager.load("stripe_centre"));
  ASSERT_TRUE(manager.load("camera"));
  ASSERT_TRUE(waitFor([&] { return first.size() >= 10 && second.size() >= 10; }));
  std::map<std::uint32_t, const StripeProfile*> by_seq;
  for (const auto& stripe : first.all())
    by_seq[stripe->header.seq] = stripe.get();
  std::size_t compared = 0;
  for (const auto& stripe : second.all())
  {
    if (by_seq.count(stripe->header.seq) == 0)
      continue;
    EXPECT_EQ(by_seq[stripe->header.seq], stripe.get()) << "stripe " << stripe->header.seq << " was copied";
    ++compared;
  }
  EXPECT_GE(compared, 9U);
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "zero_copy_test");
  const ros::NodeHandle node;  // keeps the node up while managers come and go
  return RUN_ALL_TESTS();
}
