#include "simulation/true_sections.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/section_truth.h"

namespace weld_profiler
{
namespace simulation
{
namespace
{
/// How far a point of the path lies ahead of a sheet [m].
double ahead(const World& world, const RigPose& pose, double s)
{
  const Bead& bead = world.surface.bead();
  const PathPoint middle{ 0.0, s };
  const Eigen::Vector2d place = bead.place(middle);
  const Eigen::Vector3d crest(place.x(), place.y() + world.surface.yOffset(), bead.height(middle));
  return pose.sheet_normal.dot(crest) - pose.sheet_distance;
}

/// Where along the path a frame's sheet crosses it; negative if it does not.
double crossing(const World& world, const RigPose& pose)
{
  double low = 0.0;
  double high = world.scene.weld.length;
  const bool rising = ahead(world, pose, high) > 0.0;
  if ((ahead(world, pose, low) > 0.0) == rising)
    return -1.0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    ((ahead(world, pose, middle) > 0.0) == rising ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

WeldTruth sectionOf(const World& world, double s, int frame)
{
  WeldTruth section = measureSection(world.surface.bead(), s, world.surface.yOffset());
  section.row = frame;
  section.stage = world.motion.position(world.frameTime(frame));
  return section;
}
}  // namespace

std::vector<WeldTruth> trueSections(const World& world)
{
  std::vector<WeldTruth> sections;
  for (int frame = 0; frame < world.motion.frameCount(); ++frame)
  {
    const double s = crossing(world, world.rig.pose(world.frameTime(frame)));
    if (s > 0.0 && world.surface.bead().halfWidth(s) > 0.0)
      sections.push_back(sectionOf(world, s, frame));
  }
  return sections;
}

std::optional<WeldTruth> trueSection(const World& world, double x, double y)
{
  const Bead& bead = world.surface.bead();
  const double s = bead.locate(x, y - world.surface.yOffset()).s;
  if (!(bead.halfWidth(s) > 0.0))
    return std::nullopt;
  int nearest = 0;
  double least = 1e9;
  for (int frame = 0; frame < world.motion.frameCount(); ++frame)
  {
    const double distance = std::abs(ahead(world, world.rig.pose(world.frameTime(frame)), s));
    if (distance < least)
      nearest = frame;
    least = std::min(least, distance);
  }
  return sectionOf(world, s, nearest);
}

double trueVolume(const World& world, double from_s, double to_s)
{
  const double from = std::max(0.0, from_s);
  const double to = std::min(world.scene.weld.length, to_s);
  return from < to ? beadVolume(world.surface.bead(), from, to) : 0.0;
}

double removalHeight(const World& world, double x, double y, double rest)
{
  if (world.surface.blocked(x, y))
    return std::numeric_limits<double>::quiet_NaN();
  return std::max(0.0, world.surface.height(x, y) - world.surface.target(x, y, rest));
}
}  // namespace simulation
}  // namespace weld_profiler
