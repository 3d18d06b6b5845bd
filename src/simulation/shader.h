#pragma once

#include <vector>

#include "simulation/sheet_cut.h"

namespace weld_profiler
{
namespace simulation
{
/// A point of the cut, lit: how bright, how thick, and which surface lies around it in the image.
struct LitPoint
{
  StripePixel pixel;
  double amplitude = 0.0;             ///< of the sheet's own profile, before the lens spreads it [DN]
  double sheet_sigma = 0.0;           ///< 1-sigma across, in pixels along the column, of the sheet alone
  double x = 0.0, y = 0.0;            ///< surface point, fixed frame [m]
  double x_rate = 0.0, y_rate = 0.0;  ///< how it moves a pixel across at the same cell [m/px]
  bool joined = false;                ///< the stripe runs on to the next point
};

/// A connected or broken line of light, in rising cells.
using LitLine = std::vector<LitPoint>;

/// How laser light meets the surface: brightness, thickness.
class Shader
{
public:
  Shader(const SceneParams& scene, const Surface& surface, const Rig& rig, const RigPose& reference);

  LitLine shade(const SheetCut& cut, const std::vector<CutPoint>& points) const;

  /// The light that the surface mirrors onto itself once, where the camera sees it arrive.
  LitLine mirror(const SheetCut& cut, const std::vector<CutPoint>& points) const;

  /// Metres of surface a pixel, along the stripe and across it, on the flat plate.
  double alongScale() const { return along_scale_; }
  double acrossScale() const { return across_scale_; }

private:
  struct Footprint
  {
    double x_rate, y_rate;  ///< surface movement for a pixel across at the same cell [m/px]
    double sheet_rate;      ///< movement across the sheet with it [m/px]
  };

  LitPoint light(const SheetCut& cut, const CutPoint& point, const Eigen::Vector2d& slope) const;
  bool bounce(const SheetCut& cut, const CutPoint& from, LitPoint& arrived) const;
  Footprint footprint(const SheetCut& cut, const CutPoint& point, const Eigen::Vector2d& slope) const;
  double brightness(const RigPose& pose, const Eigen::Vector3d& position, const Eigen::Vector3d& normal) const;

  const Surface& surface_;
  SceneLaser laser_;
  double sheet_sigma_ = 0.0;  ///< of the sheet's thickness [m]
  double gain_ = 1.0;         ///< gives the flat plate its peak after the lens
  double along_scale_ = 0.0, across_scale_ = 0.0;
};
}  // namespace simulation
}  // namespace weld_profiler
