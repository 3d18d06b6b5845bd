#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>

#include "support/collector.h"
#include "support/in_process_manager.h"
#include "support/temporary_folder.h"
#include "weld_profiler/StripeProfile.h"

namespace weld_profiler
{
namespace
{
constexpr double kPxEquivalent = 83.3e-6;  // what a pixel row of the default rig is worth in height [m]

/// Parameters of this run, set in the .test file.
struct RunSettings
{
  std::string bag, motion, fixed_frame, commands;

  RunSettings()
  {
    const ros::NodeHandle own("~");
    own.getParam("bag", bag);
    own.getParam("motion", motion);
    own.getParam("fixed_frame", fixed_frame);
    own.getParam("commands", commands);
  }
};

struct TrueCentre
{
  double u, v, normal, x, y, z;
  bool visible;
};

/// centres.csv: stamp in ns -> cell -> truth.
std::map<std::int64_t, std::map<int, TrueCentre>> readTruth(const std::string& path)
{
  std::map<std::int64_t, std::map<int, TrueCentre>> truth;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "frame,stamp,stage_m,cell,u_px,v_px,normal_rad,x_m,y_m,z_m,visible");
  while (std::getline(file, line))
  {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    std::string stamp;
    int frame = 0, cell = 0, visible = 0;
    double stage = 0.0;
    TrueCentre centre{};
    fields >> frame >> stamp >> stage >> cell >> centre.u >> centre.v >> centre.normal >> centre.x >> centre.y >>
        centre.z >> visible;
    centre.visible = visible != 0;
    truth[std::llround(std::stod(stamp) * 1e6)][cell] = centre;  // whole microseconds
  }
  return truth;
}

float floatAt(const std::vector<std::uint8_t>& data, std::size_t point, std::size_t offset)
{
  float value = 0.0F;
  std::memcpy(&value, &data[point * 32 + offset], 4);
  return value;
}

/// One replay through the launch file; the cases look at what came out of it.
class Replay : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    run_ = new RunSettings;
    stripes_ = new Collector<StripeProfile>("/profiler/stripe");
    profiles_ = new Collector<sensor_msgs::PointCloud2>("/profiler/profile_points");
    scans_ = new Collector<sensor_msgs::PointCloud2>("/profiler/scan_points");
    truth_ = new std::map<std::int64_t, std::map<int, TrueCentre>>(readTruth(run_->bag + ".truth/centres.csv"));
    const std::size_t frames = truth_->size();
    if (!waitFor([&] { return profiles_->size() >= frames; }, 90.0))
      return;
    std_srvs::Trigger stop;
    ros::service::call("/profiler/stop_scan", stop);
    waitFor([&] { return scans_->size() > 0 && scans_->all().back()->height == frames; }, 20.0);
  }

  static const RunSettings& run() { return *run_; }
  static std::size_t frames() { return truth_->size(); }

  static RunSettings* run_;
  static Collector<StripeProfile>* stripes_;
  static Collector<sensor_msgs::PointCloud2>* profiles_;
  static Collector<sensor_msgs::PointCloud2>* scans_;
  static std::map<std::int64_t, std::map<int, TrueCentre>>* truth_;
};
RunSettings* Replay::run_ = nullptr;
Collector<StripeProfile>* Replay::stripes_ = nullptr;
Collector<sensor_msgs::PointCloud2>* Replay::profiles_ = nullptr;
Collector<sensor_msgs::PointCloud2>* Replay::scans_ = nullptr;
std::map<std::int64_t, std::map<int, TrueCentre>>* Replay::truth_ = nullptr;

TEST_F(Replay, EveryFrameBecomesAStripeNearTheTrueCentreLine)
{
  ASSERT_EQ(stripes_->size(), frames());
  double squares = 0.0;
  std::size_t count = 0, beyond = 0, visible = 0;
  for (const auto& stripe : stripes_->all())
  {
    const auto frame = truth_->find(static_cast<std::int64_t>(stripe->header.stamp.toNSec() + 500) / 1000);
    ASSERT_NE(frame, truth_->end()) << "no frame of the truth at " << stripe->header.stamp;
    for (const auto& cell : frame->second)
      visible += cell.second.visible ? 1 : 0;
    for (std::size_t i = 0; i < stripe->cell.size(); ++i)
    {
      const auto centre = frame->second.find(stripe->cell[i]);
      if (centre == frame->second.end() || !centre->second.visible || (stripe->flags[i] & StripeProfile::INTERPOLATED))
        continue;
      const TrueCentre& c = centre->second;
      const double across = (stripe->u[i] - c.u) * std::cos(c.normal) + (stripe->v[i] - c.v) * std::sin(c.normal);
      squares += across * across;
      beyond += std::abs(across) > 1.0 ? 1 : 0;
      ++count;
    }
  }
  ASSERT_GT(count, 1000U * frames());
  EXPECT_LE(std::sqrt(squares / static_cast<double>(count)), 0.25) << "px across the stripe, as the acceptance in z";
  EXPECT_LE(static_cast<double>(beyond), 0.01 * static_cast<double>(count));
  EXPECT_GE(static_cast<double>(count), 0.98 * static_cast<double>(visible));
}

TEST_F(Replay, TheCloudLiesOnTheTrueSurface)
{
  ASSERT_GT(scans_->size(), 0U);
  const sensor_msgs::PointCloud2& cloud = *scans_->all().back();
  ASSERT_EQ(cloud.height, frames());
  ASSERT_EQ(cloud.width, 1440U);
  EXPECT_FALSE(cloud.is_dense);
  double squares_x = 0.0, squares_y = 0.0, squares_z = 0.0;
  double sum_z = 0.0;
  std::size_t count = 0, beyond = 0, visible = 0;
  auto frame = truth_->begin();
  for (std::size_t row = 0; row < cloud.height; ++row, ++frame)
  {
    for (const auto& cell : frame->second)
    {
      const std::size_t point = row * cloud.width + static_cast<std::size_t>(cell.first);
      const float z = floatAt(cloud.data, point, 8);
      visible += cell.second.visible ? 1 : 0;
      if (!cell.second.visible || !std::isfinite(z) || (cloud.data[point * 32 + 28] & StripeProfile::INTERPOLATED))
        continue;
      squares_x += std::pow(floatAt(cloud.data, point, 0) - cell.second.x, 2);
      squares_y += std::pow(floatAt(cloud.data, point, 4) - cell.second.y, 2);
      squares_z += std::pow(z - cell.second.z, 2);
      sum_z += z - cell.second.z;
      beyond += std::abs(z - cell.second.z) > kPxEquivalent ? 1 : 0;
      ++count;
    }
  }
  ASSERT_GT(count, 1000U * frames());
  const auto rms = [&](double squares) { return std::sqrt(squares / static_cast<double>(count)); };
  EXPECT_LE(rms(squares_z), 0.25 * kPxEquivalent);
  EXPECT_LE(std::abs(sum_z) / static_cast<double>(count), 0.1 * kPxEquivalent);
  EXPECT_LE(static_cast<double>(beyond), 0.01 * static_cast<double>(count));
  EXPECT_GE(static_cast<double>(count), 0.98 * static_cast<double>(visible));
  EXPECT_LE(rms(squares_y), 5e-6);
  EXPECT_LE(rms(squares_x), 5e-6);
}

TEST_F(Replay, TheLiveChainGivesThePointsOfTheOfflineCommand)
{
  ASSERT_GT(scans_->size(), 0U);
  const sensor_msgs::PointCloud2& live = *scans_->all().back();
  const TemporaryFolder folder;
  const std::string motion = run().motion == "tf" ? " --motion tf --fixed-frame " + run().fixed_frame : "";
  const std::string command = run().commands + "/scan_bag --calibration " + run().bag + ".truth/calibration.yaml" +
                              motion + " --out " + folder.path().string() + " " + run().bag + " 2>/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  pcl::PCLPointCloud2 offline;
  ASSERT_EQ(pcl::io::loadPCDFile(folder.file("scan.pcd"), offline), 0);
  ASSERT_EQ(offline.height, live.height);
  ASSERT_EQ(offline.width, live.width);
  ASSERT_EQ(offline.data.size(), live.data.size());
  std::size_t points = 0;
  for (std::size_t point = 0; point < std::size_t{ live.width } * live.height; ++point)
  {
    ASSERT_EQ(offline.data[point * 32 + 28], live.data[point * 32 + 28]) << "flags of point " << point;
    for (std::size_t offset = 0; offset < 28; offset += 4)
    {
      const float a = floatAt(offline.data, point, offset);
      const float b = floatAt(live.data, point, offset);
      ASSERT_EQ(std::isnan(a), std::isnan(b)) << "point " << point << ", offset " << offset;
      if (std::isnan(a))
        continue;
      ASSERT_NEAR(a, b, 1e-6 * std::abs(a)) << "point " << point << ", offset " << offset;
    }
    points += std::isnan(floatAt(live.data, point, 8)) ? 0 : 1;
  }
  EXPECT_GT(points, 1000U * frames());
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "replay_test");
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
