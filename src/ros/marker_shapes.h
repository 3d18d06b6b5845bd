#pragma once

#include <string>

#include <geometry_msgs/Point.h>
#include <visualization_msgs/MarkerArray.h>
#include <Eigen/Core>

namespace weld_profiler
{
/// Sizes that can be read from where rviz/weld_profiler.rviz looks at a scan of 60 x 50 mm [m].
namespace marker_size
{
constexpr double kLine = 3e-4;      ///< of a drawn line
constexpr double kText = 2.4e-3;    ///< height of a letter
constexpr double kAbove = 0.020;    ///< the section's drawing over its place
constexpr double kDrawing = 0.024;  ///< width of the bead in the drawing, if that takes no more than 4:1
}  // namespace marker_size

struct Colour
{
  float r, g, b;
};

inline void paint(visualization_msgs::Marker& one, const Colour& colour)
{
  one.color.r = colour.r;
  one.color.g = colour.g;
  one.color.b = colour.b;
  one.color.a = 1.0F;
}

inline visualization_msgs::Marker marker(const std_msgs::Header& header, const char* space, int id, int type)
{
  visualization_msgs::Marker one;
  one.header = header;
  one.ns = space;
  one.id = id;
  one.type = type;
  one.action = visualization_msgs::Marker::ADD;
  one.pose.orientation.w = 1.0;
  one.scale.x = marker_size::kLine;
  paint(one, { 1.0F, 1.0F, 1.0F });
  return one;
}

/// The first of every array: deletes what was drawn before on the topic.
inline visualization_msgs::Marker clearing(const std_msgs::Header& header)
{
  visualization_msgs::Marker clear = marker(header, "", 0, visualization_msgs::Marker::SPHERE);
  clear.action = visualization_msgs::Marker::DELETEALL;
  return clear;
}

inline geometry_msgs::Point pointOf(const Eigen::Vector3d& place)
{
  geometry_msgs::Point point;
  point.x = place.x(), point.y = place.y(), point.z = place.z();
  return point;
}

inline visualization_msgs::Marker text(const std_msgs::Header& header, int id, const Eigen::Vector3d& at,
                                       const std::string& words)
{
  visualization_msgs::Marker one = marker(header, "text", id, visualization_msgs::Marker::TEXT_VIEW_FACING);
  one.scale.z = marker_size::kText;
  one.pose.position = pointOf(at);
  one.text = words;
  return one;
}
}  // namespace weld_profiler
