// How old a profile is when it arrives: the live chain in one process at a camera's full rate. Needs a ROS master.
//   live_chain [--seconds 60] [--rate 75] [--method squared_centroid] [--encoder-hz 500,100]
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <thread>
#include <vector>

#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <boost/make_shared.hpp>

#include "weld_profiler/geometry/calibration_file.h"
#include "weld_profiler/ros/messages.h"
#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
namespace
{
constexpr int kPrepared = 48;     // images the feed cycles over
constexpr double kSpeed = 0.005;  // of the pretended stage [m/s]

struct Options
{
  double seconds = 60.0;
  double rate = 75.0;
  std::string method = "squared_centroid";
  std::vector<double> encoder_rates = { 500.0, 100.0 };
};

Options readOptions(int argc, char** argv)
{
  Options options;
  for (int i = 1; i + 1 < argc; i += 2)
  {
    const std::string name = argv[i];
    if (name == "--seconds")
      options.seconds = std::atof(argv[i + 1]);
    else if (name == "--rate")
      options.rate = std::atof(argv[i + 1]);
    else if (name == "--method")
      options.method = argv[i + 1];
    else if (name == "--encoder-hz")
    {
      options.encoder_rates.clear();
      std::istringstream list(argv[i + 1]);
      for (std::string word; std::getline(list, word, ',');)
        options.encoder_rates.push_back(std::atof(word.c_str()));
    }
  }
  return options;
}

/// Images of a simulated scan at full size, rendered once.
std::vector<sensor_msgs::ImagePtr> prepareImages(const SimulatedScan& scan)
{
  std::vector<sensor_msgs::ImagePtr> images;
  for (int i = 0; i < kPrepared; ++i)
  {
    Frame frame;
    scan.render(i, frame.pixels);
    frame.width = scan.width();
    frame.height = scan.height();
    frame.step = scan.step();
    frame.encoding = scan.encoding();
    images.push_back(imageMessage(std::move(frame), "camera_optical_frame"));
  }
  return images;
}

/// Calls work at a steady rate until stop, on a thread of its own.
template <class Work>
std::thread steadily(double rate, const std::atomic<bool>& stop, Work work)
{
  return std::thread(
      [=, &stop]
      {
        ros::WallTime due = ros::WallTime::now();
        while (!stop)
        {
          due += ros::WallDuration(1.0 / rate);
          ros::WallTime::sleepUntil(due);
          work();
        }
      });
}

struct Result
{
  std::size_t published = 0, received = 0, copied = 0;
  std::vector<double> ages;  // [s]
};

class Run
{
public:
  Run(const Options& options, const std::string& name_space, const std::string& calibration)
    : options_(options), name_space_(name_space)
  {
    ros::param::set(name_space + "/stripe_centre/method", options.method);
    ros::param::set(name_space + "/triangulation/calibration", calibration);
    const bool loaded = loader_.load(name_space + "/stripe_centre", "weld_profiler/stripe_centre", {}, {}) &&
                        loader_.load(name_space + "/triangulation", "weld_profiler/triangulation", {}, {});
    if (!loaded)
      std::exit(1);
    images_ = node_.advertise<sensor_msgs::Image>(name_space + "/image_raw", 8);
    joints_ = node_.advertise<sensor_msgs::JointState>(name_space + "/joint_states", 1000);
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> take =
        [this](const sensor_msgs::PointCloud2ConstPtr& cloud)
    { result_.ages.push_back((ros::Time::now() - cloud->header.stamp).toSec()); };
    profiles_ = node_.subscribe<sensor_msgs::PointCloud2>(name_space + "/profile_points", 1000, take);
    while (images_.getNumSubscribers() == 0 || joints_.getNumSubscribers() == 0 || profiles_.getNumPublishers() == 0)
      ros::WallDuration(0.01).sleep();
  }

  Result operator()(double encoder_rate, const std::vector<sensor_msgs::ImagePtr>& prepared)
  {
    std::atomic<bool> stop{ false };
    const ros::Time begin = ros::Time::now();
    std::thread encoder = steadily(encoder_rate, stop,
                                   [this, begin]
                                   {
                                     const ros::Time now = ros::Time::now();
                                     joints_.publish(boost::make_shared<sensor_msgs::JointState>(jointStateMessage(
                                         fromRosTime(now), "stage_joint", kSpeed * (now - begin).toSec())));
                                   });
    ros::WallDuration(0.2).sleep();
    std::thread camera = steadily(options_.rate, stop, [this, &prepared] { publishNext(prepared); });
    ros::WallDuration(options_.seconds).sleep();
    stop = true;
    camera.join();
    encoder.join();
    joints_.publish(boost::make_shared<sensor_msgs::JointState>(
        jointStateMessage(fromRosTime(ros::Time::now()), "stage_joint", kSpeed * options_.seconds)));
    ros::WallDuration(0.5).sleep();
    profiles_.shutdown();
    result_.received = result_.ages.size();
    return result_;
  }

private:
  void publishNext(const std::vector<sensor_msgs::ImagePtr>& prepared)
  {
    sensor_msgs::ImagePtr image = prepared[result_.published % prepared.size()];
    if (image.use_count() > 2)  // a reader still holds it: never write to what was published
    {
      image = boost::make_shared<sensor_msgs::Image>(*image);
      ++result_.copied;
    }
    image->header.seq = static_cast<std::uint32_t>(++result_.published);
    image->header.stamp = ros::Time::now();
    images_.publish(sensor_msgs::ImageConstPtr(image));
  }

  Options options_;
  std::string name_space_;
  nodelet::Loader loader_{ false };
  ros::NodeHandle node_;
  ros::Publisher images_;
  ros::Publisher joints_;
  ros::Subscriber profiles_;
  Result result_;
};

void print(double encoder_rate, Result result)
{
  std::sort(result.ages.begin(), result.ages.end());
  const auto at = [&](double share)
  { return 1e3 * result.ages[std::min(result.ages.size() - 1, static_cast<std::size_t>(share * result.ages.size()))]; };
  if (result.ages.empty())
  {
    std::printf("%10.0f %10zu %9zu   nothing arrived\n", encoder_rate, result.published, result.received);
    return;
  }
  std::printf("%10.0f %10zu %9zu %8zu %9.2f %9.2f %9.2f %7zu\n", encoder_rate, result.published, result.received,
              result.published - result.received, at(0.50), at(0.99), 1e3 * result.ages.back(), result.copied);
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  using namespace weld_profiler;
  ros::init(argc, argv, "live_chain", ros::init_options::AnonymousName);
  if (!ros::master::check())
  {
    std::fprintf(stderr, "live_chain: no ROS master at %s, start roscore first\n", ros::master::getURI().c_str());
    return 1;
  }
  const Options options = readOptions(argc, argv);
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(4);
  spinner.start();
  const SimulatedScan scan(scenePreset("realistic"));
  const std::vector<sensor_msgs::ImagePtr> images = prepareImages(scan);
  const std::string calibration =
      (std::filesystem::temp_directory_path() / ("weld_profiler_live_chain_" + std::to_string(::getpid()) + ".yaml"))
          .string();
  saveCalibration(scan.calibration(), calibration);
  std::printf("%s, %d x %d, %.0f frames/s for %.0f s, cycling over %d images\n", options.method.c_str(), scan.width(),
              scan.height(), options.rate, options.seconds, kPrepared);
  std::printf("encoder Hz  published  received  dropped  p50 [ms]  p99 [ms]  max [ms]  copied\n");
  int index = 0;
  for (const double rate : options.encoder_rates)
    print(rate, Run(options, "/live_chain_" + std::to_string(index++), calibration)(rate, images));
  std::remove(calibration.c_str());
  return 0;
}
