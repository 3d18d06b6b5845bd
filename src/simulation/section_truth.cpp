#include "simulation/section_truth.h"

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

constexpr double kFlush = 1e-9;         // a face no higher than this is not above its parent line [m]
constexpr double kVolumeStep = 2.5e-5;  // between the sections that make a volume [m]
constexpr int kVolumePieces = 400;      // of such a section: the area of a segment is then right to 1e-5

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
/// @param height  that the face reaches above the line; of a face that is nowhere above it, its depth, < 0.
double toeAngle(const Bead& bead, double s, double toe, const Line& line, double height)
{
  const double inward = toe < 0.0 ? 1.0 : -1.0;
  const double sign = height < 0.0 ? -1.0 : 1.0;
  double n = 0.0, sum_q = 0.0, sum_z = 0.0, sum_qq = 0.0, sum_qz = 0.0;
  double length = 0.0, last_z = line.height + line.slope * toe;
  for (double d = 0.0; d <= std::abs(toe); d += kStep)
  {
    const double q = toe + inward * d;
    const double z = bead.height(PathPoint{ q, s });
    length += d > 0.0 ? std::hypot(kStep, z - last_z) : 0.0;
    last_z = z;
    if (length > kToeFace || sign * line.above(q, z) > kToeShare * sign * height)
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

/// A section's straight lines and half its width, in (q, z).
struct Frame
{
  Line left, right, chord;
  double half;
  double toes_apart;  ///< in z
};

Frame frameOf(const Bead& bead, double s)
{
  Frame frame{};
  frame.half = bead.halfWidth(s);
  frame.left = parent(bead, s, -1.0);
  frame.right = parent(bead, s, 1.0);
  const double z_left = frame.left.height - frame.left.slope * frame.half;
  const double z_right = frame.right.height + frame.right.slope * frame.half;
  frame.toes_apart = z_right - z_left;
  frame.chord = Line{ 0.5 * (z_left + z_right), frame.toes_apart / (2.0 * frame.half) };
  return frame;
}

/// Legs, throat and convexity.
void addFillet(const Frame& frame, WeldTruth& section)
{
  const double root = (frame.left.height - frame.right.height) / (frame.right.slope - frame.left.slope);
  section.leg_left = std::abs(root + frame.half) * std::hypot(1.0, frame.left.slope);
  section.leg_right = std::abs(frame.half - root) * std::hypot(1.0, frame.right.slope);
  section.throat = -frame.chord.above(root, frame.left.height + frame.left.slope * root);
  section.misalignment = WeldTruth::kNone;  // of edges that lie side by side, not in a corner
  const bool hollow = section.incomplete_fill > section.reinforcement;
  section.convexity = hollow ? -section.incomplete_fill : section.reinforcement;
}

/// Heights, area and toe angles.
void followFace(const Bead& bead, const Frame& frame, WeldTruth& section)
{
  double left_low = 0.0, right_low = 0.0;
  const int count = std::max(100, static_cast<int>(2.0 * frame.half / kStep));
  for (int i = 0; i < count; ++i)
  {
    const double q = frame.half * (2.0 * (i + 0.5) / count - 1.0);
    const double z = bead.height(PathPoint{ q, section.s });
    const double above = frame.chord.above(q, z);
    section.reinforcement = std::max(section.reinforcement, above);
    section.incomplete_fill = std::max(section.incomplete_fill, -above);
    section.height_left = std::max(section.height_left, frame.left.above(q, z));
    section.height_right = std::max(section.height_right, frame.right.above(q, z));
    left_low = std::min(left_low, frame.left.above(q, z));
    right_low = std::min(right_low, frame.right.above(q, z));
    section.area += (z - frame.chord.height - frame.chord.slope * q) * 2.0 * frame.half / count;
  }
  const auto reached = [](double height, double low) { return height > kFlush ? height : low; };
  section.toe_angle_left = toeAngle(bead, section.s, -frame.half, frame.left, reached(section.height_left, left_low));
  section.toe_angle_right =
      toeAngle(bead, section.s, frame.half, frame.right, reached(section.height_right, right_low));
}
}  // namespace

WeldTruth measureSection(const Bead& bead, double s, double y_offset)
{
  const Frame frame = frameOf(bead, s);
  WeldTruth section;
  section.kind = bead.weld().kind;
  section.s = s;
  section.yaw = bead.heading(s);
  followFace(bead, frame, section);
  section.toe_left = inCloud(bead, PathPoint{ -frame.half, s }, y_offset);
  section.toe_right = inCloud(bead, PathPoint{ frame.half, s }, y_offset);
  section.width = std::hypot(2.0 * frame.half, frame.toes_apart);
  section.undercut_left = undercutDepth(bead, s, -frame.half, frame.left);
  section.undercut_right = undercutDepth(bead, s, frame.half, frame.right);
  const double incline_left = std::atan(frame.left.slope), incline_right = std::atan(frame.right.slope);
  section.angle = incline_right - incline_left;
  section.misalignment = std::abs(frame.left.height - frame.right.height) * std::cos(section.angle) *
                         std::cos(0.5 * (incline_left + incline_right));
  if (section.kind == "fillet")
    addFillet(frame, section);
  return section;
}

double beadVolume(const Bead& bead, double from, double to)
{
  const int sections = std::max(1, static_cast<int>(std::ceil((to - from) / kVolumeStep)));
  const double step = (to - from) / sections;
  double volume = 0.0;
  for (int i = 0; i < sections; ++i)
  {
    const double s = from + (i + 0.5) * step;
    if (!(bead.halfWidth(s) > 0.0))
      continue;
    const Frame frame = frameOf(bead, s);
    const double width = 2.0 * frame.half / kVolumePieces;
    for (int k = 0; k < kVolumePieces; ++k)
    {
      const double q = (k + 0.5) * width - frame.half;
      const double above = bead.height(PathPoint{ q, s }) - frame.chord.height - frame.chord.slope * q;
      volume += above * (1.0 - bead.weld().curvature * q) * width * step;  // a bent path is shorter inside the bend
    }
  }
  return volume;
}
}  // namespace simulation
}  // namespace weld_profiler
