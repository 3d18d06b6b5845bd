#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <Eigen/Geometry>

#include "support/circle_segment.h"
#include "weld/ideal_scan.h"

namespace weld_profiler
{
constexpr double kDegree = M_PI / 180.0;

/// A rigid motion about a place.
inline Eigen::Isometry3d motionAbout(const Eigen::Vector3d& place, const Eigen::Vector3d& shift,
                                     const Eigen::Vector3d& turn_deg)
{
  const Eigen::Vector3d turn = kDegree * turn_deg;
  const double angle = turn.norm();
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (angle > 0.0)
    motion.linear() = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  motion.translation() = place + shift - motion.linear() * place;
  return motion;
}

/// The scan as it is when the part lies elsewhere.
inline Scan moved(Scan scan, const Eigen::Isometry3d& motion)
{
  for (Profile& row : scan.rows)
  {
    for (CloudPoint& point : row.points)
    {
      const Eigen::Vector3d place = motion * Eigen::Vector3d(static_cast<double>(point.x), static_cast<double>(point.y),
                                                             static_cast<double>(point.z));
      point.x = static_cast<float>(place.x()), point.y = static_cast<float>(place.y());
      point.z = static_cast<float>(place.z());
    }
  }
  return scan;
}

/// The scan as a stage that runs the other way and a camera that is turned deliver it.
inline Scan turnedRound(Scan scan)
{
  std::reverse(scan.rows.begin(), scan.rows.end());
  for (Profile& row : scan.rows)
  {
    std::reverse(row.points.begin(), row.points.end());
    for (CloudPoint& point : row.points)
      point.cell = static_cast<std::uint16_t>(scan.cells - 1 - point.cell);
  }
  return scan;
}

/// A dip with a flat floor and slopes of 0.4 mm around it, to be taken off a height.
struct Dip
{
  double x = 0.0, y = 0.0, radius = 0.001, depth = 1e-4;
  double operator()(double px, double py) const
  {
    const double outside = (std::hypot(px - x, py - y) - radius) / 4e-4;
    return depth * std::clamp(1.0 - outside, 0.0, 1.0);
  }
};

/// Scans longer than the one before at either end, so that a shifted one still covers it.
inline IdealScanner longerScanner(unsigned seed)
{
  IdealScanner scanner;
  scanner.rows = 90;
  scanner.first_y = -0.003;
  scanner.seed = seed;
  return scanner;
}
}  // namespace weld_profiler
