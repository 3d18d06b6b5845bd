// The drawing of one section that rviz shows.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "marker_shapes.h"
#include "weld_profiler/ros/weld_markers.h"

namespace weld_profiler
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;
using namespace marker_size;

constexpr double kMillimetres = 1e3;
constexpr double kDegrees = 57.29577951308232;
constexpr double kMostEnlarged = 4.0;
constexpr double kBeside = 0.45;       // of the width: what is drawn of the parents beside each toe
constexpr double kLongestLink = 1e-3;  // points further apart are not connected [m]
const Colour kDimension = { 1.0F, 0.9F, 0.2F };

std::string millimetres(const char* symbol, const Quantity& quantity, int digits)
{
  if (!quantity.measured())
    return "";
  char words[96];
  std::snprintf(words, sizeof(words), "%s%.*f +- %.*f mm", symbol, digits, kMillimetres * quantity.value, digits,
                kMillimetres * quantity.sigma);
  return words;
}

/// Without sigma: beside each other on a tilted sheet there is no room for it.
std::string angle(const Quantity& quantity)
{
  char words[32];
  std::snprintf(words, sizeof(words), "%.1f deg", kDegrees * quantity.value);
  return quantity.measured() ? words : "";
}

/// Maps the section's plane onto an upright sheet above its place, enlarged about the middle of the chord.
class Sheet
{
public:
  explicit Sheet(const WeldSection& section)
    : left_(section.toe_left.x.value, section.toe_left.y.value, section.toe_left.z.value),
      right_(section.toe_right.x.value, section.toe_right.y.value, section.toe_right.z.value),
      middle_(0.5 * (left_ + right_))
  {
    const Eigen::Vector2d chord = (right_ - left_).head<2>();
    width_ = chord.norm();
    across_ = width_ > 0.0 ? Eigen::Vector2d(chord / width_) : Eigen::Vector2d(1.0, 0.0);
    scale_ = width_ > 0.0 ? std::min(kMostEnlarged, std::max(1.0, kDrawing / width_)) : 1.0;
  }

  bool known() const { return left_.allFinite() && right_.allFinite() && width_ > 0.0; }

  /// u across from the middle, v above it [m, as measured].
  Eigen::Vector3d at(double u, double v) const { return drawn(scale_ * u, scale_ * v); }

  /// The same, as drawn.
  Eigen::Vector3d drawn(double u, double v) const
  {
    const Eigen::Vector2d spot = middle_.head<2>() + u * across_;
    return { spot.x(), spot.y(), middle_.z() + kAbove + v };
  }

  Eigen::Vector2d onSheet(const Eigen::Vector3d& place) const
  {
    return { (place - middle_).head<2>().dot(across_), place.z() - middle_.z() };
  }

  Eigen::Vector2d left() const { return onSheet(left_); }
  Eigen::Vector2d right() const { return onSheet(right_); }
  double width() const { return width_; }
  double scale() const { return scale_; }

private:
  Eigen::Vector3d left_, right_, middle_;
  Eigen::Vector2d across_;
  double width_ = 0.0, scale_ = 1.0;
};

void addLine(const Sheet& sheet, const Eigen::Vector2d& from, const Eigen::Vector2d& to, Marker& lines)
{
  lines.points.push_back(pointOf(sheet.at(from.x(), from.y())));
  lines.points.push_back(pointOf(sheet.at(to.x(), to.y())));
}

/// The surface between the parents, broken where points are missing.
Marker profileLine(const Sheet& sheet, const Profile& row, const std_msgs::Header& header)
{
  Marker lines = marker(header, "section", 0, Marker::LINE_LIST);
  const double reach = (0.5 + kBeside) * sheet.width();
  Eigen::Vector2d last(NAN, NAN);
  for (const CloudPoint& point : row.points)
  {
    const Eigen::Vector2d here = sheet.onSheet(Eigen::Vector3f(point.x, point.y, point.z).cast<double>());
    if (!(std::abs(here.x()) <= reach) || !std::isfinite(here.y()))
      continue;
    if ((here - last).norm() < kLongestLink)
      addLine(sheet, last, here, lines);
    last = here;
  }
  return lines;
}

/// Chord, height over its middle, and the width's dimension line below.
Marker dimensionLines(const Sheet& sheet, const WeldSection& section, const std_msgs::Header& header)
{
  Marker lines = marker(header, "section", 1, Marker::LINE_LIST);
  paint(lines, kDimension);
  const Eigen::Vector2d left = sheet.left(), right = sheet.right(), along = (right - left).normalized();
  const Eigen::Vector2d up(-along.y(), along.x()), below = -kText / sheet.scale() * up;
  addLine(sheet, left, right, lines);
  addLine(sheet, left + below, right + below, lines);
  addLine(sheet, left, left + 1.3 * below, lines);
  addLine(sheet, right, right + 1.3 * below, lines);
  if (section.reinforcement.measured())
    addLine(sheet, 0.5 * (left + right), 0.5 * (left + right) + section.reinforcement.value * up, lines);
  return lines;
}

Marker toes(const Sheet& sheet, const std_msgs::Header& header)
{
  Marker balls = marker(header, "section", 2, Marker::SPHERE_LIST);
  balls.scale.x = balls.scale.y = balls.scale.z = 3.0 * kLine;
  paint(balls, { 1.0F, 0.3F, 0.1F });
  for (const Eigen::Vector2d& toe : { sheet.left(), sheet.right() })
    balls.points.push_back(pointOf(sheet.at(toe.x(), toe.y())));
  return balls;
}

/// Each value where its dimension is, as in a drawing.
void addTexts(const Sheet& sheet, const WeldSection& section, const std_msgs::Header& header, MarkerArray& all)
{
  const double half = 0.5 * sheet.scale() * sheet.width();
  const double height = section.reinforcement.measured() ? sheet.scale() * section.reinforcement.value : 0.0;
  const auto add = [&](double u, double v, const std::string& words)
  {
    if (!words.empty())
      all.markers.push_back(text(header, 1 + static_cast<int>(all.markers.size()), sheet.drawn(u, v), words));
  };
  add(2.0 * kText, -2.4 * kText, millimetres("b ", section.width, 2));
  add(0.0, std::max(height, 0.0) + kText, millimetres("h ", section.reinforcement, 3));
  add(2.0 * kText, -3.6 * kText, millimetres("a ", section.throat, 2));
  const double left = sheet.scale() * sheet.left().y(), right = sheet.scale() * sheet.right().y();
  add(-half - 4.0 * kText, left + 1.2 * kText, angle(section.toe_angle_left));
  add(half + 4.0 * kText, right + 1.2 * kText, angle(section.toe_angle_right));
  const auto undercut = [](const Quantity& depth)
  { return depth.measured() && depth.value > 2.0 * depth.sigma ? millimetres("5011 ", depth, 3) : ""; };
  add(-half - 4.0 * kText, left - 1.2 * kText, undercut(section.undercut_left));
  add(half + 4.0 * kText, right - 1.2 * kText, undercut(section.undercut_right));
}
}  // namespace

MarkerArray sectionMarkers(const WeldSection& section, const Profile& row, const std_msgs::Header& header)
{
  MarkerArray all;
  all.markers.push_back(clearing(header));
  const Sheet sheet(section);
  if (!section.hasBead() || !sheet.known())
    return all;
  const Marker profile = profileLine(sheet, row, header);
  if (!profile.points.empty())
    all.markers.push_back(profile);
  all.markers.push_back(dimensionLines(sheet, section, header));
  all.markers.push_back(toes(sheet, header));
  addTexts(sheet, section, header, all);
  return all;
}
}  // namespace weld_profiler
