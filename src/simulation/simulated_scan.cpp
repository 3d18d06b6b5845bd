#include "weld_profiler/simulation/simulated_scan.h"

#include <algorithm>

#include "simulation/renderer.h"
#include "simulation/true_sections.h"
#include "simulation/truth.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
struct SimulatedScan::Impl
{
  explicit Impl(const SceneParams& scene) : world(scene) {}
  simulation::World world;
};

namespace
{
const SceneParams& checked(const SceneParams& scene)
{
  scene.validate();
  return scene;
}

void requireFrame(int frame, int count)
{
  if (frame < 0 || frame >= count)
    throw PreconditionError("frame is " + std::to_string(frame) + ", the scan has 0 to " + std::to_string(count - 1));
}
}  // namespace

SimulatedScan::SimulatedScan(const SceneParams& scene) : impl_(new Impl(checked(scene))) {}

SimulatedScan::~SimulatedScan() = default;

int SimulatedScan::frameCount() const
{
  return impl_->world.motion.frameCount();
}

Stamp SimulatedScan::stamp(int frame) const
{
  return impl_->world.motion.stamp(frame);
}

double SimulatedScan::stagePosition(Stamp stamp) const
{
  return impl_->world.motion.position(impl_->world.motion.seconds(stamp));
}

int SimulatedScan::width() const
{
  return impl_->world.rig.camera().width();
}

int SimulatedScan::height() const
{
  return impl_->world.rig.camera().height();
}

std::string SimulatedScan::encoding() const
{
  return impl_->world.scene.sensor.encoding;
}

std::size_t SimulatedScan::step() const
{
  return impl_->world.sensor.step();
}

void SimulatedScan::render(int frame, std::vector<std::uint8_t>& pixels) const
{
  requireFrame(frame, frameCount());
  simulation::renderFrame(impl_->world, frame, pixels);
}

std::vector<TruthCentre> SimulatedScan::truth(int frame) const
{
  requireFrame(frame, frameCount());
  return simulation::trueCentres(impl_->world, frame);
}

std::vector<SimulatedEncoderSample> SimulatedScan::encoder() const
{
  return impl_->world.motion.encoder();
}

std::vector<SimulatedPose> SimulatedScan::poses() const
{
  std::vector<SimulatedPose> result;
  const simulation::World& world = impl_->world;
  if (world.scene.motion != "tf")
    return result;
  for (const Stamp stamp : world.motion.samples(world.scene.pose_rate))
  {
    const simulation::RigPose pose = world.rig.pose(world.motion.seconds(stamp));
    SimulatedPose sample;
    sample.stamp = stamp;
    for (int i = 0; i < 9; ++i)
      sample.rotation[static_cast<std::size_t>(i)] = pose.rotation(i / 3, i % 3);
    for (int i = 0; i < 3; ++i)
      sample.translation[static_cast<std::size_t>(i)] = pose.camera[i];
    result.push_back(sample);
  }
  return result;
}

const Calibration& SimulatedScan::calibration() const
{
  return impl_->world.rig.calibration();
}

Direction SimulatedScan::direction() const
{
  return impl_->world.rig.direction();
}

const SceneParams& SimulatedScan::scene() const
{
  return impl_->world.scene;
}

double SimulatedScan::surfaceHeight(double x, double y) const
{
  return impl_->world.surface.height(x, y);
}

std::array<double, 4> SimulatedScan::extent() const
{
  const simulation::World& world = impl_->world;
  const double duration = world.motion.duration();
  const double low = world.motion.lowest();
  const double high = std::max(world.motion.position(0.0), world.motion.position(duration));
  const std::vector<simulation::CutPoint> points = world.cut(0.5 * duration).trace();
  if (points.empty())
    return { { 0.0, 0.0, low, high } };
  const double first = points.front().position.x();
  const double last = points.back().position.x();
  return { { std::min(first, last), std::max(first, last), low, high } };
}

std::vector<WeldTruth> SimulatedScan::weldSections() const
{
  return simulation::trueSections(impl_->world);
}

std::optional<WeldTruth> SimulatedScan::weldSection(double x, double y) const
{
  return simulation::trueSection(impl_->world, x, y);
}

double SimulatedScan::weldVolume(double from_s, double to_s) const
{
  return simulation::trueVolume(impl_->world, from_s, to_s);
}

TrueLabel SimulatedScan::surfaceLabel(double x, double y) const
{
  return impl_->world.surface.label(x, y);
}

double SimulatedScan::targetHeight(double x, double y, double rest) const
{
  return impl_->world.surface.target(x, y, rest);
}

double SimulatedScan::removalHeight(double x, double y, double rest) const
{
  return simulation::removalHeight(impl_->world, x, y, rest);
}

TrueRipples SimulatedScan::ripples() const
{
  const SceneWeld& weld = impl_->world.scene.weld;
  const bool rippled = weld.ripple_height > 0.0 && weld.width > 0.0;
  return rippled ? TrueRipples{ weld.ripple_pitch, weld.ripple_height } : TrueRipples();
}

std::vector<TrueSpot> SimulatedScan::spots() const
{
  return impl_->world.surface.spots();
}
}  // namespace weld_profiler
