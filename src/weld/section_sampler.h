#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scan_grid.h"
#include "weld_path.h"

namespace weld_profiler
{
namespace weld
{
/// The outline in one plane across the weld's path: points with rising column, q rising with them but for noise.
struct SectionProfile
{
  WeldPathPoint place;
  int row = 0, scan_row = 0;  ///< nearest row of the grid, and of the scan
  double row_pitch = 0.0;     ///< distance of rows along the path here [m]
  std::vector<double> q, z;   ///< [m]
  /// Of each point, distances to the rows it is interpolated between, multiplied; < 0 where it is of one row alone that
  /// lies off the plane; empty = a row's own points [m^2].
  std::vector<float> between;
  double row_bend = 0.0;  ///< of the face: heights err by this times `between` (see rowBends) [1/m]

  std::size_t size() const { return q.size(); }
};

/// Cuts the organised surface with planes across the path. In each column the point is interpolated between the rows on
/// either side of the plane, so that rows add no slope and no ripple; one row alone serves where it is within 0.6
/// rows.
class SectionSampler
{
public:
  /// @param grid  must outlive the sampler.
  SectionSampler(const ScanGrid& grid, const WeldPath& path);

  const ScanGrid& grid() const { return grid_; }

  PathPlace place(std::size_t point) const
  {
    return PathPlace{ static_cast<double>(places_[point].q), static_cast<double>(places_[point].s) };
  }

  /// Rows between one of the grid and the grid's nearer end.
  int rowsToEnd(int row) const { return std::min(row, grid_.rows - 1 - row); }

  /// @param masked   points to leave out, one a point of the grid; empty = none.
  /// @param profile  filled.
  void sample(double s, const std::vector<std::uint8_t>& masked, SectionProfile& profile) const;

private:
  void placeRow(int row);
  int nearestRow(double y) const;
  double along(std::size_t point) const { return static_cast<double>(places_[point].s); }

  /// Where a column crosses the plane at s: behind a row.
  struct Crossing
  {
    double s, pitch;
    int row, column;
  };
  /// A point that is made of two of the grid.
  struct Mixture
  {
    std::size_t below = 0, above = 0;
    double share = 0.0;    ///< of the one above
    double between = 0.0;  ///< as in a profile
  };
  bool lookAround(const Crossing& at, const std::vector<std::uint8_t>& masked, Mixture& of) const;

  /// A profile's points while they become more.
  class Points
  {
  public:
    Points(std::size_t most, SectionProfile& profile);
    void add(double q, double z, double between)
    {
      q_[count_] = q, z_[count_] = z, between_[count_] = static_cast<float>(between);
      ++count_;
    }
    void end(SectionProfile& profile) const;

  private:
    double *q_, *z_;
    float* between_;
    std::size_t count_ = 0;
  };
  void put(const Mixture& of, Points& points) const
  {
    const double rest = 1.0 - of.share;
    points.add(rest * place(of.below).q + of.share * place(of.above).q,
               rest * static_cast<double>(grid_.z[of.below]) + of.share * static_cast<double>(grid_.z[of.above]),
               of.between);
  }

  const ScanGrid& grid_;
  const WeldPath& path_;
  /// Of a point, in half the memory: 0.06 um at a metre.
  struct SmallPlace
  {
    float q, s;
  };
  std::vector<SmallPlace> places_;
};
}  // namespace weld
}  // namespace weld_profiler
