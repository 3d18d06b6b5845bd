#include "weld_profiler/simulation/random_welds.h"

#include <algorithm>
#include <cmath>

#include "simulation/bead.h"
#include "simulation/random.h"
#include "simulation/rig.h"

namespace weld_profiler
{
namespace
{
using simulation::Bead;
using simulation::Motion;
using simulation::Random;
using simulation::Rig;
using simulation::RigPose;

constexpr double kPi = 3.141592653589793;
constexpr double kRadPerDeg = kPi / 180.0;
constexpr double kMm = 0.001;
constexpr double kScan = 20.0 * kMm;
constexpr double kSteepestFace = 60.0 * kRadPerDeg;
constexpr double kSteepestUndercut = 3.0;    // tangent of its wall
constexpr double kPlainOffset = 0.15 * kMm;  // what tells two plates from one, or
constexpr double kPlainAngle = 1.0;          // this [deg]
constexpr int kRegionRows = 400;
constexpr int kRowMargin = 10;  // of the stripe's middle from the region's edge

/// Rows of the sensor between which the stripe lies during the scan.
struct Rows
{
  double low = 1e9, high = -1e9;
};

Rows stripeRows(const SceneParams& scene)
{
  constexpr double kHalfField = 0.036;
  constexpr int kPlaces = 145;
  constexpr int kMoments = 9;
  const Motion motion(scene);
  const Rig rig(scene, motion);
  const Bead bead(scene.plates, scene.weld, scene.second_bead);
  Rows rows;
  for (int i = 0; i < kMoments; ++i)
  {
    const double seconds = motion.duration() * i / (kMoments - 1);
    const RigPose pose = rig.pose(seconds);
    const double y = motion.position(seconds);  // the default rig's sheet is upright
    for (int k = 0; k < kPlaces; ++k)
    {
      const double x = kHalfField * (2.0 * k / (kPlaces - 1) - 1.0);
      const Eigen::Vector3d point(x, y, bead.height(bead.locate(x, y)));
      const Eigen::Vector2d pixel = rig.camera().project(pose.toCamera(point));
      if (pixel.x() < 0.0 || pixel.x() > rig.camera().width() - 1.0)
        continue;
      rows.low = std::min(rows.low, pixel.y());
      rows.high = std::max(rows.high, pixel.y());
    }
  }
  return rows;
}

double either(Random& random, double value)
{
  return random.uniform() < 0.5 ? -value : value;
}

void choosePath(Random& random, SceneParams& scene)
{
  SceneWeld& weld = scene.weld;
  weld.length = 3.0 * kScan;
  weld.start = 0.5 * (kScan - weld.length);
  const double yaw = random.uniform(0.0, 20.0);
  const bool bent = random.uniform() < 0.5;
  const double bend = bent ? random.uniform(0.5, 5.0) : 0.0;
  weld.curvature = either(random, bend);
  const double turned = bend * 0.5 * kScan / kRadPerDeg;  // at either end of the scan
  weld.yaw_deg = either(random, std::min(yaw, 20.0 - 1.1 * turned));
}

void choosePlates(Random& random, SceneParams& scene)
{
  ScenePlates& plates = scene.plates;
  plates.x = random.uniform(-1.5, 1.5) * kMm;
  plates.tilt_deg = random.uniform(-3.0, 3.0);
  if (scene.weld.kind == "fillet")
  {
    plates.angle_deg = random.uniform(82.0, 92.0);
    plates.height = random.uniform(-15.0, -12.0) * kMm;
    return;
  }
  plates.height = random.uniform(-4.0, 4.0) * kMm;
  if (scene.weld.kind != "butt")
    return;
  // two plates without offset and angle would be one plate
  const double most = std::min(1.0 * kMm, 0.15 * scene.weld.width);
  const bool offset = random.uniform() < 0.75;
  plates.misalignment = either(random, offset ? random.uniform(kPlainOffset, most) : random.uniform(0.0, kPlainOffset));
  const bool angled = random.uniform() < 0.4;
  if (angled || !offset)
    plates.angle_deg = either(random, random.uniform(kPlainAngle, 2.0));
}

void chooseFace(Random& random, SceneWeld& weld)
{
  weld.width = random.uniform(4.0, 20.0) * kMm;
  weld.crest_offset = random.uniform() < 0.35 ? random.uniform(-0.15, 0.15) : 0.0;
  const double lean = 2.0 * std::abs(weld.crest_offset) / (1.0 - weld.crest_offset * weld.crest_offset);
  const double edge = std::atan(std::tan(kSteepestFace) / (1.0 + lean));  // of the arc before its crest is moved
  const double most = std::min(4.0 * kMm, 0.5 * weld.width * std::tan(0.5 * edge));
  weld.reinforcement = weld.kind == "fillet" ? weld.width * random.uniform(-0.08, 0.18) : random.uniform(0.0, most);
  weld.ripple_pitch = random.uniform(0.8, 2.5) * kMm;
  const double ripple = std::min(0.085 * weld.ripple_pitch, 0.02 * kMm + 0.15 * std::abs(weld.reinforcement));
  weld.ripple_height = random.uniform() < 0.8 ? random.uniform(0.2, 1.0) * ripple : 0.0;
}

/// Depth and width are meant perpendicular to the plate and along it; the scene's are along z and level.
void chooseUndercut(Random& random, const ScenePlates& plates, SceneWeld& weld)
{
  const double lean = std::tan(0.5 * plates.angle_deg * kRadPerDeg);
  const double stretch = std::hypot(1.0, lean);
  const double width = random.uniform(0.8, 2.0) * kMm;
  weld.undercut_width = width / stretch;
  // at the toe the wall's slope is pi^2 depth / width
  const double steepest = (kSteepestUndercut + std::max(0.0, lean)) / (kPi * kPi) * weld.undercut_width / stretch;
  const double most = std::min({ 0.6 * kMm, 0.1 * weld.width, steepest });
  for (double* depth : { &weld.undercut_left, &weld.undercut_right })
    *depth = random.uniform() < 0.5 ? random.uniform(0.05, 1.0) * most * stretch : 0.0;
}

/// Lets the region have the whole stripe; plates that rise too far for that are laid flatter.
void placeRegion(SceneParams& scene)
{
  CameraCalibration& camera = scene.calibration.camera;
  Rows rows = stripeRows(scene);
  while (rows.high - rows.low > kRegionRows - 2 * kRowMargin)
  {
    scene.plates.angle_deg -= 1.0;
    scene.plates.tilt_deg *= 0.8;
    rows = stripeRows(scene);
  }
  const int top = static_cast<int>(std::lround(0.5 * (rows.low + rows.high) - 0.5 * kRegionRows));
  camera.roi_x = 0;
  camera.roi_y = std::clamp(top, 0, camera.image_height - kRegionRows);
  camera.roi_width = camera.image_width;
  camera.roi_height = kRegionRows;
}
}  // namespace

SceneParams randomWeldScene(std::uint64_t seed)
{
  static const char* const kKinds[] = { "butt", "fillet", "bead_on_plate" };
  Random random(simulation::mix(seed, 0x3E1D5));
  SceneParams scene = scenePreset("realistic");
  scene.seed = seed;
  scene.scan_length = kScan;
  scene.speed = random.uniform(0.1, 0.2) * kMm * scene.frame_rate;
  scene.weld.kind = kKinds[seed % 3];
  chooseFace(random, scene.weld);
  choosePath(random, scene);
  choosePlates(random, scene);
  chooseUndercut(random, scene.plates, scene.weld);
  scene.spatter.count = static_cast<int>(random.uniform(0.0, 26.0));
  scene.spatter.radius_min = 0.1 * kMm;
  scene.spatter.radius_max = 0.4 * kMm;
  placeRegion(scene);
  return scene;
}
}  // namespace weld_profiler
