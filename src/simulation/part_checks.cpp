#include "simulation/part_checks.h"

#include <algorithm>
#include <cmath>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace simulation
{
namespace
{
const std::vector<std::string> kKinds{ "butt", "fillet", "bead_on_plate" };
constexpr double kRadPerDeg = 0.017453292519943295;
constexpr double kSteepestPlate = 65.0;  // beyond, the cut takes it for a wall [deg]
constexpr double kBetweenBeads = 0.001;  // of plain plate [m]

void checkPlates(const ScenePlates& plates)
{
  requireRange("plates.x", plates.x, -0.1, 0.1, "m");
  requireRange("plates.height", plates.height, -0.05, 0.05, "m");
  requireRange("plates.misalignment", plates.misalignment, -0.01, 0.01, "m");
  requireRange("plates.angle_deg", plates.angle_deg, -120.0, 120.0, "deg");
  requireRange("plates.tilt_deg", plates.tilt_deg, -40.0, 40.0, "deg");
  const double steepest = 0.5 * std::abs(plates.angle_deg) + std::abs(plates.tilt_deg);
  if (!(steepest <= kSteepestPlate))
    throw ConfigError("plates.angle_deg is " + std::to_string(plates.angle_deg) + " and plates.tilt_deg " +
                      std::to_string(plates.tilt_deg) + ": a plate stands at " + std::to_string(steepest) +
                      " deg, must be at most " + std::to_string(kSteepestPlate));
}

void checkKind(const ScenePlates& plates, const SceneWeld& weld)
{
  requireOneOf("weld.kind", weld.kind, kKinds);
  if (weld.kind == "butt")
    return;
  const std::string of = "(weld.kind is " + weld.kind + ")";
  requireRange("plates.misalignment", plates.misalignment, 0.0, 0.0, "m " + of);
  if (weld.kind == "fillet")
    requireRange("plates.angle_deg", plates.angle_deg, 30.0, 120.0, "deg " + of);
  else
    requireRange("plates.angle_deg", plates.angle_deg, 0.0, 0.0, "deg " + of);
  if (weld.kind == "bead_on_plate" && weld.width > 0.0)
    requireRange("weld.reinforcement", weld.reinforcement, 0.0, 0.5 * weld.width, "m " + of);
}

/// A fillet's face must stay above the plates that it joins: at the toes it may not be steeper than they are.
void checkFillet(const ScenePlates& plates, const SceneWeld& weld)
{
  const double left = std::tan((0.5 * plates.angle_deg - plates.tilt_deg) * kRadPerDeg);
  const double right = std::tan((0.5 * plates.angle_deg + plates.tilt_deg) * kRadPerDeg);
  const double dip = std::max(weld.crater_start, weld.crater_end) + std::max(0.0, -weld.reinforcement);
  const double edge = std::tan(2.0 * std::atan(2.0 * dip / weld.width));  // of an arc as deep as that
  const double lean = 2.0 * std::abs(weld.crest_offset) / (1.0 - weld.crest_offset * weld.crest_offset);
  const double room = 0.5 * (left + right);  // the chord's slope taken off
  if (!(edge >= 0.0 && edge * (1.0 + lean) < room))
    throw ConfigError("weld.reinforcement is " + std::to_string(weld.reinforcement) + " and weld.crater_* at most " +
                      std::to_string(std::max(weld.crater_start, weld.crater_end)) +
                      ": the face would cut into the plates of this fillet, make it less hollow");
}

void checkShape(const SceneWeld& weld)
{
  requireRange("weld.width", weld.width, 0.0, 0.05, "m");
  if (weld.width > 0.0)
    requireRange("weld.reinforcement", weld.reinforcement, -0.5 * weld.width, 0.5 * weld.width,
                 "m (half of weld.width)");
  requireRange("weld.crest_offset", weld.crest_offset, -0.3, 0.3);
  requireRange("weld.ripple_height", weld.ripple_height, 0.0, 0.002, "m");
  requireRange("weld.ripple_pitch", weld.ripple_pitch, 0.0001, 0.1, "m");
  requireRange("weld.undercut_left", weld.undercut_left, 0.0, 0.005, "m");
  requireRange("weld.undercut_right", weld.undercut_right, 0.0, 0.005, "m");
  requireRange("weld.undercut_width", weld.undercut_width, 0.0001, 0.01, "m");
}

void checkCourse(const SceneWeld& weld)
{
  requireRange("weld.start", weld.start, -2.0, 2.0, "m");
  requireRange("weld.length", weld.length, 1e-4, 4.0, "m");
  requireRange("weld.tack_length", weld.tack_length, 0.0, 1.0, "m");
  requireRange("weld.tack_gap", weld.tack_gap, 1e-4, 1.0, "m");
  const bool tacked = weld.tack_length > 0.0;
  const double bead = tacked ? std::min(weld.tack_length, weld.length) : weld.length;
  const std::string half = tacked ? "m (half of a tack)" : "m (half of weld.length)";
  requireRange("weld.end_length", weld.end_length, 0.0, 0.5 * bead, half);
  requireRange("weld.crater_start", weld.crater_start, 0.0, 0.005, "m");
  requireRange("weld.crater_end", weld.crater_end, 0.0, 0.005, "m");
  requireRange("weld.crater_length", weld.crater_length, 1e-4, 0.1, "m");
  requireRange("weld.yaw_deg", weld.yaw_deg, -30.0, 30.0, "deg");
  requireRange("weld.curvature", weld.curvature, -10.0, 10.0, "1/m");
}

void checkSecondBead(const SceneSecondBead& second, const SceneWeld& weld)
{
  requireRange("second_bead.offset", second.offset, -0.05, 0.05, "m");
  requireRange("second_bead.width", second.width, 0.0, 0.05, "m");
  if (!(second.width > 0.0))
    return;
  requireRange("second_bead.reinforcement", second.reinforcement, 0.0, 0.5 * second.width,
               "m (half of second_bead.width)");
  const double apart = 0.5 * (weld.width + second.width) + weld.undercut_width + kBetweenBeads;
  if (!(std::abs(second.offset) >= apart))
    throw ConfigError("second_bead.offset is " + std::to_string(second.offset) + ", must be at least " +
                      std::to_string(apart) + " m either way, a millimetre clear of the first bead");
}

void checkBlock(const std::string& name, const SceneBlock& block)
{
  requireRange(name + ".height", block.height, 0.0, 0.05, "m");
  requireRange(name + ".x", block.x, -0.2, 0.2, "m");
  requireRange(name + ".y", block.y, -2.0, 2.0, "m");
  requireRange(name + ".width", block.width, 1e-4, 0.5, "m");
  requireRange(name + ".length", block.length, 1e-4, 4.0, "m");
}

void checkSpots(const SceneSpatter& spatter, const ScenePores& pores)
{
  requireRange("spatter.count", spatter.count, 0, 2000);
  requireRange("spatter.radius_min", spatter.radius_min, 1e-5, 0.01, "m");
  requireRange("spatter.radius_max", spatter.radius_max, spatter.radius_min, 0.01, "m (at least spatter.radius_min)");
  requireRange("pores.count", pores.count, 0, 500);
  requireRange("pores.diameter_min", pores.diameter_min, 2e-5, 0.01, "m");
  requireRange("pores.diameter_max", pores.diameter_max, pores.diameter_min, 0.01, "m (at least pores.diameter_min)");
  requireRange("pores.depth", pores.depth, 0.05, 0.5);
}
}  // namespace

void checkPart(const SceneParams& scene)
{
  checkPlates(scene.plates);
  checkShape(scene.weld);
  checkCourse(scene.weld);
  checkKind(scene.plates, scene.weld);
  if (scene.weld.kind == "fillet" && scene.weld.width > 0.0)
    checkFillet(scene.plates, scene.weld);
  checkSecondBead(scene.second_bead, scene.weld);
  checkBlock("gauge", scene.gauge);
  checkBlock("marker", scene.marker);
  checkSpots(scene.spatter, scene.pores);
}
}  // namespace simulation
}  // namespace weld_profiler
