#include "ground_metal.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kSure = 3.0;         // sigmas, of a spot
constexpr double kBelow = 2.0;        // sigmas, of a bin that counts no remains
constexpr double kSystematic = 1e-6;  // of a surface's height over the whole weld, against the parents [m]

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

bool metal(std::uint8_t label)
{
  return label == static_cast<std::uint8_t>(WeldLabel::Bead) || label == static_cast<std::uint8_t>(WeldLabel::Spatter);
}

double depthTaken(const CompareBins::Bin& bin)
{
  return std::min(-bin.above, bin.taken);
}

OverGroundSpot& deepen(const CompareBins::Bin& bin, double variance, OverGroundSpot& spot)
{
  if (!(spot.depth.value > -bin.above))
  {
    spot.x = bin.x, spot.y = bin.y;
    spot.depth = { -bin.above, std::sqrt(variance) };
  }
  spot.area += bin.area;
  return spot;
}
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
    if (!metal(scans.maps.labels[i]) || !std::isfinite(scans.maps.target[i]))
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

std::vector<OverGroundSpot> overGround(const ComparedScans& scans, const CompareBins& bins, const PathFrame& path,
                                       const CompareParams& params)
{
  std::vector<OverGroundSpot> spots;
  if (bins.rows() == 0)
    return spots;
  cv::Mat1b deep(bins.rows(), bins.columns(), std::uint8_t{ 0 });
  for (int row = 0; row < bins.rows(); ++row)
  {
    for (int column = 0; column < bins.columns(); ++column)
    {
      const CompareBins::Bin& bin = bins.at(row, column);
      if (bin.points > 0 && depthTaken(bin) > params.over_ground_limit &&
          depthTaken(bin) > kSure * std::sqrt(bins.variance(scans, row, column)))
        deep(row, column) = 1;
    }
  }
  cv::Mat1i pieces;
  spots.resize(static_cast<std::size_t>(cv::connectedComponents(deep, pieces, 8, CV_32S)) - 1);
  for (int row = 0; row < bins.rows(); ++row)
    for (int column = 0; column < bins.columns(); ++column)
      if (pieces(row, column) > 0)
        deepen(bins.at(row, column), bins.variance(scans, row, column),
               spots[static_cast<std::size_t>(pieces(row, column)) - 1]);
  spots.erase(std::remove_if(spots.begin(), spots.end(),
                             [&](const OverGroundSpot& spot) { return spot.area < params.min_spot_area; }),
              spots.end());
  for (OverGroundSpot& spot : spots)
    spot.s = path.locate(spot.x, spot.y, 0.0).s;
  std::stable_sort(spots.begin(), spots.end(),
                   [](const OverGroundSpot& a, const OverGroundSpot& b) { return a.depth.value > b.depth.value; });
  return spots;
}

ComparedAreas comparedAreas(const ComparedScans& scans, const CompareBins& bins, double limit)
{
  ComparedAreas areas;
  double before = 0.0, both = 0.0;
  for (std::size_t i = 0; i < scans.grid.z.size(); ++i)
  {
    if (!std::isfinite(scans.grid.z[i]) || !scans.inZone(i))
      continue;
    before += static_cast<double>(scans.area[i]);
    both += static_cast<double>(scans.common_area[i]);
  }
  areas.share = before > 0.0 ? both / before : 0.0;
  for (int row = 0; row < bins.rows(); ++row)
  {
    for (int column = 0; column < bins.columns(); ++column)
    {
      const CompareBins::Bin& bin = bins.at(row, column);
      if (bin.points == 0)
        continue;
      const double sure = kSure * std::sqrt(bins.variance(scans, row, column));
      areas.low += -bin.above > std::max(limit, sure) && depthTaken(bin) <= limit ? bin.area : 0.0;
      areas.higher += -bin.taken > std::max(limit, sure) ? bin.area : 0.0;
    }
  }
  return areas;
}
}  // namespace weld
}  // namespace weld_profiler
