#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "weld_profiler/scan/encoder_pose_source.h"
#include "weld_profiler/scan/scan_builder.h"

namespace weld_profiler
{
constexpr Stamp kMs = 1000000;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A builder on the default rig, and all it told.
struct Bench
{
  explicit Bench(const ScanParams& params = ScanParams{})
  {
    auto source = std::make_unique<EncoderPoseSource>(Calibration{}, EncoderParams{});
    encoder = source.get();
    ScanBuilder::Sinks sinks;
    sinks.on_profile = [this](const Profile& profile) { profiles.push_back(profile); };
    sinks.on_scan = [this](Scan&& scan) { scans.push_back(std::move(scan)); };
    builder = std::make_unique<ScanBuilder>(params, std::move(source), "part", sinks);
  }

  void sample(Stamp stamp, double position)
  {
    if (!encoder->addSample(stamp, position))
      builder->timeBackwards();
    builder->poll();
  }

  /// A frame with points at the scan's origin (seen at stage 0), one a cell.
  void frame(Stamp stamp, int points = 2, std::uint32_t cells = 4)
  {
    SensorProfile profile;
    profile.stamp = stamp;
    profile.frame = ++frames;
    profile.cells = cells;
    for (int i = 0; i < points; ++i)
    {
      SensorPoint point;
      point.position = { 0.001 * i, 0.0, 0.25 };
      point.spread = { 0.0F, 0.0F, 2e-5F };
      point.cell = static_cast<std::uint16_t>(i);
      profile.points.push_back(point);
    }
    builder->addProfile(profile);
  }

  const FrameBalance& balance() const { return builder->balance(); }
  bool closes() const { return balance().frames_in == balance().accounted() + builder->waiting(); }
  std::uint64_t unplaced(const std::string& reason) const
  {
    const auto found = balance().unplaced.find(reason);
    return found == balance().unplaced.end() ? 0 : found->second;
  }

  EncoderPoseSource* encoder = nullptr;
  std::unique_ptr<ScanBuilder> builder;
  std::vector<Profile> profiles;
  std::vector<Scan> scans;
  std::uint64_t frames = 0;
};

inline ScanParams timeTrigger()
{
  ScanParams params;
  params.trigger = "time";
  return params;
}
}  // namespace weld_profiler
