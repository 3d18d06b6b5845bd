#include "tools/simulated_cloud.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/geometry/triangulator.h"
#include "weld_profiler/scan/encoder_pose_source.h"
#include "weld_profiler/scan/scan_builder.h"
#include "weld_profiler/stripe/stripe_stage.h"

namespace weld_profiler
{
namespace
{
const char* const kFrame = "weld_profiler_scan";

std::unique_ptr<EncoderPoseSource> encoderOf(const SimulatedScan& simulated)
{
  auto encoder = std::make_unique<EncoderPoseSource>(simulated.calibration(), EncoderParams());
  for (const SimulatedEncoderSample& sample : simulated.encoder())
    encoder->addSample(sample.stamp, sample.position);
  return encoder;
}

/// Frame by frame from the image to points in the camera's frame.
class Camera
{
public:
  explicit Camera(const SimulatedScan& simulated)
    : simulated_(simulated), stage_(StripeParams()), triangulator_(simulated.calibration())
  {
  }

  SensorProfile profile(int frame)
  {
    simulated_.render(frame, pixels_);
    const RawImage image{ pixels_.data(),    simulated_.width(),    simulated_.height(),
                          simulated_.step(), simulated_.encoding(), false };
    stage_.process(image, workspace_, stripe_);
    SensorProfile profile;
    profile.stamp = simulated_.stamp(frame);
    profile.frame = static_cast<std::uint64_t>(frame);
    triangulator_.triangulate(stripe_, profile);
    return profile;
  }

private:
  const SimulatedScan& simulated_;
  StripeStage stage_;
  Triangulator triangulator_;
  Workspace workspace_;
  Stripe stripe_;
  std::vector<std::uint8_t> pixels_;
};
}  // namespace

Scan simulatedCloud(const SimulatedScan& simulated)
{
  std::vector<Scan> scans;
  ScanBuilder::Sinks sinks;
  sinks.on_scan = [&scans](Scan&& scan) { scans.push_back(std::move(scan)); };
  ScanBuilder builder(ScanParams(), encoderOf(simulated), kFrame, sinks);
  Camera camera(simulated);
  for (int frame = 0; frame < simulated.frameCount(); ++frame)
    builder.addProfile(camera.profile(frame));
  builder.finish();
  const auto frames = static_cast<std::size_t>(simulated.frameCount());
  if (scans.size() != 1 || scans.front().rows.size() != frames)
    throw InputError("the scene's " + std::to_string(frames) + " frames became " + std::to_string(scans.size()) +
                     " scans with " + std::to_string(scans.empty() ? 0 : scans.front().rows.size()) +
                     " rows in the first, must be one scan with a row each: let the stage move on in every frame");
  return std::move(scans.front());
}
}  // namespace weld_profiler
