#pragma once

#include <string>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "support/diagnostics_reader.h"
#include "support/in_process_manager.h"
#include "support/rig_feed.h"
#include "support/small_scene.h"
#include "support/temporary_folder.h"
#include "weld_profiler/geometry/calibration_file.h"

namespace weld_profiler
{
/// Both nodelets of the chain, fed by the test.
class Chain
{
public:
  Chain(const std::string& name, int frames) : Chain(name, smallScene(frames)) {}

  Chain(const std::string& name, const SceneParams& scene)
    : manager(name), feed(name, scene), triangulation(name + "/triangulation"), stripe(name + "/stripe_centre")
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
}  // namespace weld_profiler
