#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
/// A weld of known shape: its face a segment of a circle over the chord of the toes, its path an arc through the middle
/// of the scan. All in metres.
struct MadeWeld
{
  int rows = 200, cells = 600;
  double pitch = 1e-4, spacing = 42e-6;
  double width = 8e-3, height = 1.5e-3;
  double yaw = 0.0;           ///< at the middle of the scan, from +y toward -x [rad]
  double bend = 0.0;          ///< curvature of the path, > 0 = to the right [1/m]
  double misalignment = 0.0;  ///< right plate lower by
  double rest = 0.0;          ///< target above flush
  double sigma = 0.0;         ///< of z
  double narrowing = 0.0;     ///< of the width, per metre along the weld
  double slope_left = 0.0;    ///< of the plate, rising outward; a fillet's
  double slope_right = 0.0;
  bool flipped = false;  ///< the stage runs toward -y and the camera is turned: rows and cells the other way
  struct Hole
  {
    double s_from, s_to, q_from, q_to;
  };
  std::vector<Hole> holes;  ///< along and across the weld

  Scan scan;
  WeldResult result;

  double middleY() const { return 0.5 * (rows - 1) * pitch; }
  double widthAt(double s) const { return width - narrowing * s; }
  double chord(double s, double q) const { return -misalignment * std::min(1.0, std::max(0.0, q / widthAt(s) + 0.5)); }
  bool fillet() const { return slope_left > 0.0 || slope_right > 0.0; }
  double plates(double s, double q) const
  {
    return std::max(0.0, std::abs(q) - 0.5 * widthAt(s)) * (q < 0.0 ? slope_left : slope_right);
  }
  double flush(double s, double q) const { return chord(s, q) + plates(s, q); }
  double target(double s, double q) const { return flush(s, q) + (inside(s, q) ? rest : 0.0); }
  bool inside(double s, double q) const { return std::abs(q) <= 0.5 * widthAt(s); }
  double radius(double s) const
  {
    const double half = 0.5 * widthAt(s);
    return (half * half + height * height) / (2.0 * height);
  }
  /// Of the face above the chord.
  double rise(double s, double q) const
  {
    const double r = radius(s);
    return inside(s, q) ? std::sqrt(r * r - q * q) - (r - height) : 0.0;
  }
  double surface(double s, double q) const { return flush(s, q) + rise(s, q); }

  double halfAngle(double s = 0.0) const { return std::asin(0.5 * widthAt(s) / radius(s)); }
  double segmentArea() const { return radius(0.0) * radius(0.0) * (halfAngle() - 0.5 * std::sin(2.0 * halfAngle())); }
  double arc() const { return 2.0 * radius(0.0) * halfAngle(); }
  double length() const { return result.path.back().s - result.path.front().s; }

  Eigen::Vector2d along() const { return { -std::sin(yaw), std::cos(yaw) }; }
  Eigen::Vector2d across() const { return { std::cos(yaw), std::sin(yaw) }; }

  /// x, y of a place; s = 0 in the middle of the scan.
  Eigen::Vector2d at(double s, double q) const
  {
    const Eigen::Vector2d middle(0.0, middleY());
    if (bend == 0.0)
      return middle + s * along() + q * across();
    const double r = 1.0 / bend, angle = s * bend;
    return middle + r * across() + (r - q) * (std::sin(angle) * along() - std::cos(angle) * across());
  }

  /// s (first) and q of a point.
  Eigen::Vector2d locate(double x, double y) const
  {
    const Eigen::Vector2d from = Eigen::Vector2d(x, y) - Eigen::Vector2d(0.0, middleY());
    if (bend == 0.0)
      return { from.dot(along()), from.dot(across()) };
    const double r = 1.0 / bend, a = from.dot(along()) * bend, c = 1.0 - from.dot(across()) * bend;
    return { std::atan2(a, c) * r, r - std::hypot(a, c) * r };
  }

  double yawAt(double s) const { return yaw - s * bend; }

  MadeWeld& make();

private:
  void makeRow(int row, std::mt19937& generator);
  void makeSections();
};

inline MadeWeld& MadeWeld::make()
{
  std::mt19937 generator(7);
  scan.frame_id = "weld_profiler_scan";
  scan.cells = static_cast<std::uint32_t>(cells);
  scan.rows.resize(static_cast<std::size_t>(rows));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto count = static_cast<std::size_t>(rows * cells);
  result.rows = static_cast<std::uint32_t>(rows), result.cells = scan.cells;
  result.labels.assign(count, 0);
  result.removal.assign(count, nan);
  result.target.assign(count, nan);
  result.kind = fillet() ? WeldKind::Fillet : WeldKind::Butt;
  for (int row = 0; row < rows; ++row)
    makeRow(row, generator);
  makeSections();
  return *this;
}

inline void MadeWeld::makeRow(int row, std::mt19937& generator)
{
  std::normal_distribution<double> noise(0.0, 1.0);
  Profile& profile = scan.rows[static_cast<std::size_t>(row)];
  profile.cells = scan.cells;
  for (int cell = 0; cell < cells; ++cell)
  {
    const double x = (flipped ? -1.0 : 1.0) * (cell - 0.5 * (cells - 1)) * spacing;
    const double y = (flipped ? rows - 1 - row : row) * pitch;
    const Eigen::Vector2d place = locate(x, y);
    const double s = place.x(), q = place.y();
    bool hidden = false;
    for (const Hole& hole : holes)
      hidden = hidden || (s > hole.s_from && s < hole.s_to && q > hole.q_from && q < hole.q_to);
    if (hidden)
      continue;
    const double z = surface(s, q) + sigma * noise(generator);
    profile.points.push_back({ static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), 100.0F, 1e-5F,
                               static_cast<std::uint16_t>(cell), 0 });
    const std::size_t at = static_cast<std::size_t>(row * cells + cell);
    result.labels[at] = static_cast<std::uint8_t>(inside(s, q) ? WeldLabel::Bead : WeldLabel::Base);
    result.target[at] = static_cast<float>(target(s, q));
    result.removal[at] = static_cast<float>(inside(s, q) ? std::max(0.0, z - target(s, q)) : 0.0);
  }
}

inline void MadeWeld::makeSections()
{
  // bead and 3 mm beside it within the scan
  const double half =
      middleY() / std::cos(yaw) - (0.5 * width + 3e-3) * (std::abs(std::tan(yaw)) + std::abs(bend) * middleY());
  const int count = static_cast<int>(2.0 * half / pitch);
  for (int k = 0; k <= count; ++k)
  {
    const double s = -half + 2.0 * half * k / count, edge = 0.5 * widthAt(s);
    const Eigen::Vector2d middle = at(s, 0.0), left = at(s, -edge), right = at(s, edge);
    result.path.push_back({ s + half, middle.x(), middle.y(), yawAt(s) });
    WeldSection section;
    section.section = k;
    section.s = s + half;
    section.width = { widthAt(s), 1e-5 };
    section.toe_left = { { left.x(), 1e-5 }, { left.y(), 1e-5 }, { flush(s, -edge), 1e-6 } };
    section.toe_right = { { right.x(), 1e-5 }, { right.y(), 1e-5 }, { flush(s, edge), 1e-6 } };
    result.sections.push_back(section);
  }
}
}  // namespace weld_profiler
