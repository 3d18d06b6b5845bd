#include "ground_metal.h"

#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kBelow = 2.0;        // sigmas, of a bin that counts no remains
constexpr double kSystematic = 6e-7;  // of a surface's height over the whole weld, against the parents [m]

/// Sums up a volume with its uncertainty.
class VolumeSum
{
public:
  explicit VolumeSum(const ComparedScans& scans) : scans_(scans) {}

  /// A point's part in the uncertainty of a height that is integrated.
  void addPoint(std::size_t i, double own_variance)
  {
    const auto area = static_cast<double>(scans_.common_area[i]);
    const SurfaceSample& after = scans_.after[i];
    variance_ += square(area) * (static_cast<double>(after.variance) + own_variance);
    const Eigen::Vector3d place(static_cast<double>(scans_.grid.x[i]), static_cast<double>(scans_.grid.y[i]),
                                static_cast<double>(after.z));
    moved_ +=
        area * scans_.heightJacobian(place, static_cast<double>(after.slope_x), static_cast<double>(after.slope_y));
    area_ += area;
  }

  double area() const { return area_; }

  double sigma() const
  {
    return std::sqrt(variance_ * square(scans_.noise.factor) * scans_.noise.alike +
                     moved_.dot(scans_.aligned.covariance * moved_) + square(kSystematic * area_));
  }

private:
  const ComparedScans& scans_;
  double variance_ = 0.0, area_ = 0.0;
  Vector6d moved_ = Vector6d::Zero();
};

}  // namespace

Quantity removedVolume(const ComparedScans& scans)
{
  VolumeSum sum(scans);
  double volume = 0.0;
  for (std::size_t i = 0; i < scans.grid.z.size(); ++i)
  {
    if (!scans.known(i) || !scans.inZone(i))
      continue;
    volume += static_cast<double>(scans.common_area[i]) * scans.taken(i);
    sum.addPoint(i, pointVariance(scans.grid, i));
  }
  return sum.area() > 0.0 ? Quantity{ volume, sum.sigma() } : Quantity();
}

Quantity remainingVolume(const ComparedScans& scans, const CompareBins& bins, const Quantity& target)
{
  double volume = 0.0, whole = 0.0;
  for (int row = 0; row < bins.rows(); ++row)
  {
    for (int column = 0; column < bins.columns(); ++column)
    {
      const CompareBins::Bin& bin = bins.at(row, column);
      if (bin.metal_area > 0.0 && bin.metal_above > -kBelow * std::sqrt(bins.variance(scans, row, column)))
        volume += bin.metal_area * bin.metal_above;
    }
  }
  VolumeSum sum(scans);
  for (std::size_t i = 0; i < scans.grid.z.size(); ++i)
  {
    if (!isMetal(scans.maps.labels[i]) || !std::isfinite(scans.maps.target[i]))
      continue;
    whole += static_cast<double>(scans.area[i]);
    if (scans.known(i))
      sum.addPoint(i, 0.0);
  }
  if (!(sum.area() > 0.0))
    return {};
  const double of_target = std::isfinite(target.sigma) ? target.sigma * sum.area() / whole : 0.0;
  return { volume, std::hypot(sum.sigma(), of_target) };
}

}  // namespace weld
}  // namespace weld_profiler
