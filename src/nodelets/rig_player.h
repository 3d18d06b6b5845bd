#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <diagnostic_updater/diagnostic_updater.h>
#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <tf2_ros/transform_broadcaster.h>

#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
/// Settings of the simulated rig.
struct RigPlayerParams
{
  std::string scene = "realistic";  ///< a preset's name or the path of a scene file
  std::string frame_id = "camera_optical_frame";
  std::string fixed_frame = "world";  ///< parent of the camera with motion tf
  std::string truth_dir;              ///< where the truth is written before the scan starts; empty = nowhere
  bool loop = false;                  ///< scan again and again
  bool wait_for_subscriber = true;    ///< the scan begins when somebody listens to image_raw
  int prerender_frames = 400;         ///< rendered before the scan starts (1.6 MB each); the rest on the way, 0..100000

  void validate() const;  ///< @throws ConfigError naming field, value and range

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("scene", scene);
    v("frame_id", frame_id);
    v("fixed_frame", fixed_frame);
    v("truth_dir", truth_dir);
    v("loop", loop);
    v("wait_for_subscriber", wait_for_subscriber);
    v("prerender_frames", prerender_frames);
  }
};

/// Plays a simulated scan in real time on a thread of its own: an image when its exposure ends, stamped with its
/// middle; an encoder sample when it is taken.
class RigPlayer
{
public:
  /// @throws ConfigError, InputError naming scene, value and remedy.
  RigPlayer(ros::NodeHandle& node, ros::NodeHandle& own, const RigPlayerParams& params, const std::string& name);
  ~RigPlayer();

private:
  struct Event;

  void run();
  void prerender();
  void waitForSubscriber() const;
  void playOnce();
  std::vector<Event> timeline(const SimulatedScan& scan) const;
  void publishFrame(const SimulatedScan& scan, int frame);
  void publishPose(const SimulatedPose& pose);
  bool sleepUntil(Stamp stamp) const;
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  const RigPlayerParams params_;
  const std::string name_;
  SceneParams scene_;
  std::vector<std::vector<std::uint8_t>> rendered_;
  image_transport::CameraPublisher images_;
  ros::Publisher joints_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> broadcaster_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
  std::atomic<std::uint64_t> published_{ 0 };
  std::atomic<std::uint64_t> late_{ 0 };
  std::atomic<const char*> state_{ "rendering" };
  std::atomic<bool> stop_{ false };
  std::thread thread_;
};
}  // namespace weld_profiler
