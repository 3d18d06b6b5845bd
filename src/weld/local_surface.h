#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "binned.h"

namespace weld_profiler
{
namespace weld
{
/// A height over a place along and across the weld.
struct HeightPoint
{
  double s = 0.0, q = 0.0, z = 0.0;  ///< [m]
};

/// A surface at one place.
struct HeightSample
{
  bool known = false;
  double z = 0.0;                    ///< [m]
  double along = 0.0, across = 0.0;  ///< slope: dz/ds, dz/dq
};

/// Of a height along z over the same along the surface's normal; 1 where it is not known.
inline double steepness(const HeightSample& surface)
{
  return surface.known ? std::sqrt(1.0 + surface.along * surface.along + surface.across * surface.across) : 1.0;
}

/// A surface told from scattered points: at a place, what fits the points around it best, near ones counting most
/// (local regression, weights (1 - (r / radius)^2)^2: W. S. Cleveland, S. J. Devlin, "Locally Weighted Regression",
/// 1988). Along the weld a straight line, across it a parabola, as faces are round; the parabola's bend is held back a
/// little, so that it stays sensible where points lie to one side only. Immutable, thread safe.
class LocalSurface
{
public:
  /// @param radius  points this near take part [m].
  /// @param reach   a place whose nearest point lies further away is not known [m].
  LocalSurface(const std::vector<HeightPoint>& points, double radius, double reach);

  HeightSample at(double s, double q) const;

private:
  struct Sums;
  void gather(const HeightPoint* from, const HeightPoint* to, Sums& sums) const;

  Binned<HeightPoint> points_;
  double radius_ = 0.0, reach_ = 0.0;
  double from_s_ = 0.0, from_q_ = 0.0;
  int bins_s_ = 0, bins_q_ = 0;
};
}  // namespace weld
}  // namespace weld_profiler
