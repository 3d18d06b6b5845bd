#include "simulation/true_sections.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kPi = 3.141592653589793;
constexpr double kStep = 2e-6;           // of the sampled section [m]
constexpr double kBeside = 0.012;        // undercuts are looked for this far outside a toe [m]
constexpr double kToeFace = 0.001;       // the toe angle is taken over this much of the face, or ...
constexpr double kToeShare = 1.0 / 3.0;  // ... over this share of the height, if that is shorter

/// A straight line z = height + slope q.
struct Line
{
  double height, slope;
  double above(double q, double z) const { return (z - height - slope * q) / std::sqrt(1.0 + slope * slope); }
};

/// Parent line of a side (-1 left, +1 right), extended across the weld.
Line parent(const Bead& bead, double s, double side)
{
  const double near = bead.plateHeight(PathPoint{ side * 1e-9, s });
  const double far = bead.plateHeight(PathPoint{ side * 0.01, s });
  const double slope = (far - near) / (side * (0.01 - 1e-9));
  return Line{ near - slope * side * 1e-9, slope };
}

/// Angle of the face at a toe: 180 degrees less that between a regression over its first piece and the parent line.
double toeAngle(const Bead& bead, double s, double toe, const Line& line, double height)
{
  const double inward = toe < 0.0 ? 1.0 : -1.0;
  double n = 0.0, sum_q = 0.0, sum_z = 0.0, sum_qq = 0.0, sum_qz = 0.0;
  double length = 0.0, last_z = line.height + line.slope * toe;
  for (double d = 0.0; d <= std::abs(toe); d += kStep)
  {
    const double q = toe + inward * d;
    const double z = bead.height(PathPoint{ q, s });
    length += d > 0.0 ? std::hypot(kStep, z - last_z) : 0.0;
    last_z = z;
    if (length > kToeFace || line.above(q, z) > kToeShare * height)
      break;
    n += 1.0, sum_q += q, sum_z += z, sum_qq += q * q, sum_qz += q * z;
  }
  const double spread = n * sum_qq - sum_q * sum_q;
  if (!(n > 2.0) || !(spread > 0.0))
    return kPi;
  const double slope = (n * sum_qz - sum_q * sum_z) / spread;
  return kPi - inward * (std::atan(slope) - std::atan(line.slope));
}

double undercutDepth(const Bead& bead, double s, double toe, const Line& line)
{
  const double outward = toe < 0.0 ? -1.0 : 1.0;
  double depth = 0.0;
  for (double d = 0.0; d <= kBeside; d += kStep)
  {
    const double q = toe + outward * d;
    depth = std::max(depth, -line.above(q, bead.height(PathPoint{ q, s })));
  }
  return depth;
}

std::array<double, 3> inCloud(const Bead& bead, const PathPoint& point, double y_offset)
{
  const Eigen::Vector2d place = bead.place(point);
  return { { place.x(), place.y() + y_offset, bead.height(point) } };
}

/// Where along the path a frame's sheet crosses it; negative if it does not.
double crossing(const World& world, const RigPose& pose)
{
  const Bead& bead = world.surface.bead();
  const auto ahead = [&](double s)
  {
    const Eigen::Vector2d place = bead.place(PathPoint{ 0.0, s });
    const Eigen::Vector3d crest(place.x(), place.y() + world.surface.yOffset(), bead.height(PathPoint{ 0.0, s }));
    return pose.sheet_normal.dot(crest) - pose.sheet_distance;
  };
  double low = 0.0;
  double high = world.scene.weld.length;
  const bool rising = ahead(high) > 0.0;
  if ((ahead(low) > 0.0) == rising)
    return -1.0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    ((ahead(middle) > 0.0) == rising ? high : low) = middle;
  }
  return 0.5 * (low + high);
}
}  // namespace

WeldTruth measureSection(const Bead& bead, double s, double y_offset)
{
  const double half = bead.halfWidth(s);
  const Line left = parent(bead, s, -1.0);
  const Line right = parent(bead, s, 1.0);
  const double z_left = left.height - left.slope * half;
  const double z_right = right.height + right.slope * half;
  const Line chord{ 0.5 * (z_left + z_right), (z_right - z_left) / (2.0 * half) };
  WeldTruth section;
  section.s = s;
  section.yaw = bead.heading(s);
  section.width = std::hypot(2.0 * half, z_right - z_left);
  const int count = std::max(100, static_cast<int>(2.0 * half / kStep));
  for (int i = 0; i < count; ++i)
  {
    const double q = half * (2.0 * (i + 0.5) / count - 1.0);
    const double z = bead.height(PathPoint{ q, s });
    section.reinforcement = std::max(section.reinforcement, chord.above(q, z));
    section.height_left = std::max(section.height_left, left.above(q, z));
    section.height_right = std::max(section.height_right, right.above(q, z));
    section.area += (z - chord.height - chord.slope * q) * 2.0 * half / count;
  }
  section.toe_left = inCloud(bead, PathPoint{ -half, s }, y_offset);
  section.toe_right = inCloud(bead, PathPoint{ half, s }, y_offset);
  section.toe_angle_left = toeAngle(bead, s, -half, left, section.height_left);
  section.toe_angle_right = toeAngle(bead, s, half, right, section.height_right);
  section.undercut_left = undercutDepth(bead, s, -half, left);
  section.undercut_right = undercutDepth(bead, s, half, right);
  section.misalignment =
      std::abs(left.height - right.height) * std::cos(std::atan(right.slope) - std::atan(left.slope));
  return section;
}

std::vector<WeldTruth> trueSections(const World& world)
{
  std::vector<WeldTruth> sections;
  for (int frame = 0; frame < world.motion.frameCount(); ++frame)
  {
    const double seconds = world.frameTime(frame);
    const double s = crossing(world, world.rig.pose(seconds));
    if (!(s > 0.0) || !(world.surface.bead().halfWidth(s) > 0.0))
      continue;
    WeldTruth section = measureSection(world.surface.bead(), s, world.surface.yOffset());
    section.row = frame;
    section.stage = world.motion.position(seconds);
    sections.push_back(section);
  }
  return sections;
}
}  // namespace simulation
}  // namespace weld_profiler
