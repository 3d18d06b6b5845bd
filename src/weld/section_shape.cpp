#include "section_shape.h"

#include <algorithm>
#include <cmath>

#include "section_heights.h"
#include "statistics.h"
#include "toe_angle.h"
#include "undercut.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kNodeWindow = 3.5e-4;  // of the face's local fits [m]
constexpr double kBlurredRim = 3e-4;    // of the face at a toe [m]
constexpr double kUnseenRim = 1.2e-3;   // of the face at a toe; with more unseen its top may be there [m]
constexpr double kFaceEnergy = 1.6;     // of the face's points over that of the parents': it is curved and rippled
constexpr double kFaceBias = 1e-6;      // what the face's points err alike [m]
constexpr double kRippled = 1.0 / 3.0;  // of the face: ripples trail and end at its toes, where others are at the crest
constexpr double kLongestBridge = 1.6e-3;  // break in the face (spatter) that its area is bridged over [m]

/// Error of a toe across a line: that of its parent's height, and what its shift along the parent makes.
double toeSigmaAcross(const ToeFit& toe, const ParentFit& parent, const Line& line)
{
  return std::hypot(parent.sigmaAt(toe.q), toe.sigma * std::sin(parent.line.angle() - line.angle()));
}

SectionPoint cloudPoint(const WeldPathPoint& place, const ToeFit& toe, const ParentFit& parent)
{
  SectionPoint point;
  const double across = toe.sigma * std::cos(parent.line.angle());
  point.x = Quantity{ place.x + std::cos(place.yaw) * toe.q, std::abs(std::cos(place.yaw)) * across };
  point.y = Quantity{ place.y + std::sin(place.yaw) * toe.q, std::abs(std::sin(place.yaw)) * across };
  point.z = Quantity{ toe.z, std::hypot(parent.sigmaAt(toe.q), parent.line.slope * across) };
  return point;
}

/// Nodes clear of both toes, where the kinks' blur lifts or lowers the face.
std::vector<HeightNode> clearOfToes(const std::vector<HeightNode>& nodes, const SectionShape& shape)
{
  std::vector<HeightNode> clear;
  for (const HeightNode& node : nodes)
  {
    if (node.q - shape.toe_left.q > kBlurredRim && shape.toe_right.q - node.q > kBlurredRim)
      clear.push_back(node);
  }
  return clear;
}

/// The face's nodes between those of the toes, which err along their parents.
std::vector<HeightNode> withToes(std::vector<HeightNode> nodes, const SectionShape& shape, const Line& line)
{
  for (const Side side : { Side::Left, Side::Right })
  {
    const ToeFit& toe = shape.toe(side);
    const HeightNode node{ toe.q, toe.z, toeSigmaAcross(toe, shape.parent(side), line), 0.0 };
    nodes.insert(side == Side::Left ? nodes.begin() : nodes.end(), node);
  }
  return nodes;
}

void fillHeights(const std::vector<HeightNode>& all, double step, const SectionShape& shape, WeldSection& section)
{
  const Line chord = shape.chord();
  const std::vector<HeightNode> nodes = clearOfToes(withoutGuessed(all, step), shape);
  const double middle = 0.5 * (shape.toe_left.q + shape.toe_right.q);
  if (!nodes.empty() && nodes.front().q - shape.toe_left.q < kUnseenRim &&
      shape.toe_right.q - nodes.back().q < kUnseenRim)
    section.reinforcement = largestAbove(nodes, chord, step);
  if (section.reinforcement.value < 0.0)
    section.reinforcement.value = 0.0;  // of a hollow face the toes are highest
  section.reinforcement.sigma = std::hypot(section.reinforcement.sigma, shape.chordSigma(middle));
  for (const Side side : { Side::Left, Side::Right })
  {
    const Line& parent = shape.parent(side).line;
    Quantity& height = side == Side::Left ? section.height_left : section.height_right;
    if (section.reinforcement.measured())
      height = largestAbove(withToes(nodes, shape, parent), parent, step, 1);
    height.sigma = std::hypot(height.sigma, shape.parent(side).sigmaAt(middle));
  }
  double deepest = 0.0, sigma = kNaN;
  for (const HeightNode& node : nodes)
  {
    const double depth = -chord.above(node.q, node.z);
    if (!(depth > deepest) && std::isfinite(sigma))
      continue;
    deepest = std::max(0.0, depth);
    sigma = std::hypot(node.sigma, shape.chordSigma(node.q));
  }
  if (std::isfinite(section.reinforcement.value))
    section.incomplete_fill = Quantity{ deepest, sigma };
}

/// What ripples between rows lift or lower a face by, mean over its width [m].
double rippleBetweenRows(const SectionProfile& profile, double from, double to)
{
  double between = 0.0, points = 0.0;
  for (std::size_t i = 0; i < profile.between.size(); ++i)
  {
    if (!(profile.q[i] > from && profile.q[i] < to))
      continue;
    between += std::abs(static_cast<double>(profile.between[i]));
    points += 1.0;
  }
  return kRippled * profile.row_bend * between / std::max(1.0, points);
}

Quantity faceArea(const SectionProfile& profile, const SectionShape& shape, double blur)
{
  const Line chord = shape.chord();
  const double from = shape.toe_left.q, to = shape.toe_right.q, width = to - from;
  const double gap = longestGap(profile, from, to);
  if (gap > std::min(kLongestBridge, 0.3 * width))
    return Quantity();
  double area = 0.0, last_q = from, last_above = 0.0, bridged = 0.0;
  int points = 0;
  const auto add = [&](double q, double above)
  {
    area += 0.5 * (above + last_above) * (q - last_q);
    bridged += q - last_q > 2e-4 ? std::pow(q - last_q, 3.0) : 0.0;
    last_q = q, last_above = above;
    ++points;
  };
  const auto addArc = [&](const ToeFit& toe, double inward, double distance)
  {
    const double q = toe.q + inward * distance;
    const double z = toe.bridged ? kNaN : toe.face.heightAt(inward * q);
    if (std::isfinite(z))
      add(q, z - chord.at(q));
  };
  for (const double share : { 0.25, 0.5, 0.75 })
    addArc(shape.toe_left, 1.0, share * blur);
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    const double q = profile.q[i];
    if (q > last_q && q > from + blur && q < to - blur)
      add(q, profile.z[i] - chord.at(q));
  }
  for (const double share : { 0.75, 0.5, 0.25 })
    addArc(shape.toe_right, -1.0, share * blur);
  add(to, 0.0);
  const double bend = 8.0 * std::abs(area) / (width * width * width);  // of an arc of this area, roughly twice over
  const double noise = shape.energy() * width * width / std::max(1, points);
  const double rippled = width * rippleBetweenRows(profile, from + blur, to - blur);
  return Quantity{ area,
                   std::sqrt(noise + square(kFaceBias * width) + square(width * shape.chordSigma(0.5 * (from + to))) +
                             square(bend * bridged / 12.0) + square(rippled)) };
}

void fillParents(const SectionShape& shape, double seam, WeldSection& section)
{
  const Line& left = shape.left.line;
  const Line& right = shape.right.line;
  const double angle = right.angle() - left.angle();
  const double sigma = std::hypot(shape.left.sigmaAt(seam), shape.right.sigmaAt(seam));
  const double tilt = 0.5 * (left.angle() + right.angle());
  const double offset = std::abs(left.at(seam) - right.at(seam)) * std::abs(std::cos(angle)) * std::cos(tilt);
  // where the plates are at an angle the offset depends on where the seam is
  const double place =
      0.5 * std::hypot(shape.toe_left.sigma, shape.toe_right.sigma) * std::abs(right.slope - left.slope);
  section.misalignment = Quantity{ offset, shape.whole() ? std::hypot(sigma, place) : sigma };
  section.angle = Quantity{ angle, std::sqrt(shape.left.covariance(1, 1) + shape.right.covariance(1, 1)) };
}
}  // namespace

Line SectionShape::chord() const
{
  const double slope = (toe_right.z - toe_left.z) / (toe_right.q - toe_left.q);
  return Line{ toe_left.z - slope * toe_left.q, slope };
}

double SectionShape::chordSigma(double q) const
{
  const Line line = chord();
  const double share = (q - toe_left.q) / (toe_right.q - toe_left.q);
  // blur moves both toes inward or both outward
  const double blur_left = toe_left.bias * std::sin(left.line.angle() - line.angle());
  const double blur_right = -toe_right.bias * std::sin(right.line.angle() - line.angle());
  const double common = 2.0 * (1.0 - share) * share * blur_left * blur_right;
  return std::sqrt(std::max(0.0, square((1.0 - share) * toeSigmaAcross(toe_left, left, line)) +
                                     square(share * toeSigmaAcross(toe_right, right, line)) + common));
}

double SectionShape::energy() const
{
  const double of_left = left.valid() ? square(left.scatter) * left.correlated_cells : 0.0;
  const double of_right = right.valid() ? square(right.scatter) * right.correlated_cells : 0.0;
  return std::max(of_left, of_right);
}

SectionValues sectionValues(const SectionProfile& profile, const SectionShape& shape, const WeldParams& params)
{
  SectionValues values;
  WeldSection& section = values.section;
  section.row = profile.scan_row;
  section.s = profile.place.s;
  section.yaw = profile.place.yaw;
  if (shape.left.valid() && shape.right.valid())
  {
    const double seam = shape.whole() ? 0.5 * (shape.toe_left.q + shape.toe_right.q) : 0.0;
    fillParents(shape, seam, section);
  }
  const Undercut left = measureUndercut(profile, shape, Side::Left, params);
  const Undercut right = measureUndercut(profile, shape, Side::Right, params);
  section.undercut_left = left.depth, values.undercut_width_left = left.width;
  section.undercut_right = right.depth, values.undercut_width_right = right.width;
  if (shape.toe_left.found)
    section.toe_left = cloudPoint(profile.place, shape.toe_left, shape.left);
  if (shape.toe_right.found)
    section.toe_right = cloudPoint(profile.place, shape.toe_right, shape.right);
  if (!shape.whole())
  {
    section.reference = SectionReference::ParentLines;
    return values;
  }
  section.width = Quantity{ std::hypot(shape.toe_right.q - shape.toe_left.q, shape.toe_right.z - shape.toe_left.z),
                            // blur moves both toes inward or both outward
                            std::sqrt(square(shape.toe_left.sigma) + square(shape.toe_right.sigma) +
                                      2.0 * shape.toe_left.bias * shape.toe_right.bias) };
  HeightSpan span;
  span.from = shape.toe_left.q + params.edge_blur, span.to = shape.toe_right.q - params.edge_blur;
  span.half_window = kNodeWindow;
  span.max_gap = params.max_gap;
  span.energy = kFaceEnergy * shape.energy();
  span.row_bend = profile.row_bend;
  fillHeights(localHeights(profile, span), span.step, shape, section);
  section.area = faceArea(profile, shape, params.edge_blur);
  section.toe_angle_left =
      toeAngle({ profile, shape.toe_left, Side::Left, shape.left.line, section.height_left.value, params.edge_blur });
  section.toe_angle_right = toeAngle(
      { profile, shape.toe_right, Side::Right, shape.right.line, section.height_right.value, params.edge_blur });
  return values;
}
}  // namespace weld
}  // namespace weld_profiler
