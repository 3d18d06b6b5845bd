#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "moved_surface.h"
#include "path_frame.h"
#include "scan_aligner.h"
#include "weld_zone.h"

namespace weld_profiler
{
namespace weld
{
/// Two scans that lie on each other, point by point of the scan before (in the order of its grid).
struct ComparedScans
{
  const ScanGrid& grid;
  const GridMaps& maps;
  const std::vector<float>& distance;  ///< from the weld [m]
  double reach = 0.0;                  ///< so far from the weld grinding may go [m]
  double rest = 0.0;                   ///< that the target leaves above flush, normal to it [m]
  std::vector<SurfaceSample> after;
  std::vector<float> area;         ///< of the surface before, seen from above, that a point stands for [m^2]
  std::vector<float> common_area;  ///< of it, what the scan after shows too
  ScanAlignment aligned;
  PointNoise noise;

  bool known(std::size_t i) const { return common_area[i] > 0.0F; }
  bool inZone(std::size_t i) const { return static_cast<double>(distance[i]) <= reach; }
  double taken(std::size_t i) const { return static_cast<double>(grid.z[i]) - static_cast<double>(after[i].z); }
  double above(std::size_t i) const { return static_cast<double>(after[i].z) - static_cast<double>(maps.target[i]); }

  /// How z changes at a place on a surface of this slope when the scan after moves.
  Vector6d heightJacobian(const Eigen::Vector3d& place, double slope_x, double slope_y) const;
};

/// Fills `area` and `common_area`: a third of each facet for each of its corners.
void shareAreas(const std::vector<Facet>& facets, ComparedScans& scans);

/// Small squares over the scan before, over which heights are averaged.
class CompareBins
{
public:
  explicit CompareBins(const ComparedScans& scans);

  struct Bin
  {
    int points = 0, rows = 0;
    int last_row = -1;                                           ///< of the grid
    bool spatter = false;                                        ///< before
    double area = 0.0;                                           ///< common [m^2]
    double x = 0.0, y = 0.0, z = 0.0, above = 0.0, taken = 0.0;  ///< means over the area
    double target = 0.0;                                         ///< mean [m]
    double not_there = 0.0;                      ///< of the target's rest, what was not there before [m]
    double noise = 0.0;                          ///< variance of a mean of z after less before
    double metal_area = 0.0, metal_above = 0.0;  ///< of it, where bead or spatter was: area, mean above the target
  };

  /// How far a bin lies below what grinding can leave: the target, or the surface before where that was lower, as in a
  /// bead's tapering ends; never below flush [m].
  static double depth(const Bin& bin) { return -bin.above - bin.not_there; }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double size() const { return size_; }
  const Bin& at(int row, int column) const { return bins_[index(row, column)]; }

  /// Row and column of the bin that a place lies in, inside of all known points.
  int rowOf(double y) const { return std::clamp(static_cast<int>((y - near_) / size_), 0, rows_ - 1); }
  int columnOf(double x) const { return std::clamp(static_cast<int>((x - left_) / size_), 0, columns_ - 1); }

  /// Variance of a bin's height above the target [m^2]: noise, and how the scans lie on each other.
  double variance(const ComparedScans& scans, int row, int column) const;

private:
  std::size_t index(int row, int column) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  void average(const ComparedScans& scans);
  void lowerTheRest(double rest);
  static void add(const ComparedScans& scans, std::size_t i, Bin& bin);
  double slope(int row, int column, bool along_x) const;

  int columns_ = 0, rows_ = 0;
  double left_ = 0.0, near_ = 0.0, size_ = 2.5e-4;
  std::vector<Bin> bins_;
};
}  // namespace weld
}  // namespace weld_profiler
