#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <yaml-cpp/yaml.h>

#include "bag_rewrite.h"
#include "run_command_line.h"
#include "small_rig.h"

namespace weld_profiler
{
inline const std::string kCalibration = "--calibration weld.bag.truth/calibration.yaml ";

/// Folder with weld.bag, a simulated scan, to run scan_bag in.
class ScanBag : public CommandTest
{
protected:
  void SetUp() override
  {
    CommandTest::SetUp();
    write("scene.yaml", kSmallRig + "frame_count: 20\nlaser: {sigma_px: 1.4, lens_sigma_px: 0.9}\n");
    ASSERT_EQ(run("simulate_scan", "--scene scene.yaml --out weld.bag").status, 0);
  }

  CommandResult scan(const std::string& arguments) const { return run("scan_bag", arguments); }

  YAML::Node summary(const std::string& directory) const { return YAML::LoadFile(path(directory + "/summary.json")); }

  /// weld.bag with every message through change, which may leave it out by returning false.
  template <class Message>
  void rewrite(const std::string& target, const std::function<bool(std::size_t, Message&)>& change) const
  {
    rewriteBag<Message>(path("weld.bag"), path(target), change);
  }

  /// frames_in = rows + no_stripe + skipped + unplaced + dropped.
  static void expectClosed(const YAML::Node& summary)
  {
    std::uint64_t sum = summary["rows"].as<std::uint64_t>() + summary["no_stripe"].as<std::uint64_t>() +
                        summary["skipped"].as<std::uint64_t>();
    for (const char* key : { "unplaced", "dropped" })
    {
      for (const auto& reason : summary[key])
        sum += reason.second.as<std::uint64_t>();
    }
    EXPECT_EQ(sum, summary["frames_in"].as<std::uint64_t>());
  }
};
}  // namespace weld_profiler
