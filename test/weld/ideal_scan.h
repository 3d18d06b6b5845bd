#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "weld_profiler/core/scan.h"

namespace weld_profiler
{
/// A weld as a height field, written for the tests alone: a circular arc between two plates.
struct IdealWeld
{
  double width = 0.008, height = 0.0015;  ///< chord and crest [m]
  double misalignment = 0.0;              ///< right plate above the left [m]
  double angle = 0.0;                     ///< between the plates, > 0 = both rise outward [rad]
  double undercut = 0.0;                  ///< of the right toe, 1 mm wide [m]
  double yaw = 0.0;                       ///< of the path, from +y toward -x [rad]
  double x = 0.0;                         ///< of the path at y = 0 [m]
  double begin = -1.0, end = 1.0;         ///< along the path [m]
  double ripple = 0.0;                    ///< crest to trough, 1.2 mm apart [m]

  double plate(double q) const { return (q < 0.0 ? -0.5 : 0.5) * misalignment + std::tan(0.5 * angle) * std::abs(q); }

  double operator()(double px, double py) const
  {
    const double q = std::cos(yaw) * (px - x) + std::sin(yaw) * py;
    const double s = -std::sin(yaw) * (px - x) + std::cos(yaw) * py;
    const double half = 0.5 * width;
    if (s < begin || s > end || width <= 0.0)
      return plate(q);
    if (std::abs(q) >= half)
    {
      const double outside = std::abs(q) - half;
      const bool cut = q > 0.0 && outside < 0.001;
      return plate(q) - (cut ? undercut * std::pow(std::sin(M_PI * outside / 0.001), 2.0) : 0.0);
    }
    const double left = plate(-half), right = plate(half);
    const double radius = 0.5 * (half * half + height * height) / height;
    const double wave = 0.5 * ripple * (1.0 - q * q / (half * half)) * std::sin(2.0 * M_PI * s / 0.0012);
    return left + (right - left) * (q + half) / width + std::sqrt(radius * radius - q * q) - (radius - height) + wave;
  }
};

/// How a test scans a height field.
struct IdealScanner
{
  int rows = 60, cells = 1000;
  double pitch = 2e-4, spacing = 4.2e-5;  ///< [m]
  double noise = 2e-6;                    ///< 1-sigma of z, alike over a few neighbours [m]
  double holes = 0.0;                     ///< share of points that are missing
  double first_y = 0.0;                   ///< [m]
  unsigned seed = 1;

  Scan operator()(const std::function<double(double, double)>& surface) const
  {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    Scan scan;
    scan.frame_id = "scan";
    scan.cells = static_cast<std::uint32_t>(cells);
    constexpr int kAlike = 5;
    for (int row = 0; row < rows; ++row)
    {
      Profile profile;
      profile.cells = scan.cells;
      profile.stage = row * pitch;
      std::vector<double> white(static_cast<std::size_t>(cells) + kAlike);
      for (double& value : white)
        value = normal(generator);
      for (int cell = 0; cell < cells; ++cell)
      {
        double error = 0.0;
        for (int i = 0; i < kAlike; ++i)
          error += white[static_cast<std::size_t>(cell + i)] / std::sqrt(static_cast<double>(kAlike));
        const double x = (cell - 0.5 * cells) * spacing, y = first_y + row * pitch;
        const double z = surface(x, y);
        if (!(uniform(generator) >= holes) || !std::isfinite(z))
          continue;
        CloudPoint point;
        point.x = static_cast<float>(x), point.y = static_cast<float>(y);
        point.z = static_cast<float>(z + noise * error);
        point.sigma = static_cast<float>(noise);
        point.cell = static_cast<std::uint16_t>(cell);
        profile.points.push_back(point);
      }
      scan.rows.push_back(profile);
    }
    return scan;
  }
};
}  // namespace weld_profiler
