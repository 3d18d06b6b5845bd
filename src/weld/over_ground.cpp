#include "over_ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kSure = 3.0;       // sigmas, of a depth
constexpr double kElsewhere = 2.0;  // sigmas of where a place was before
constexpr double kSpatter = 1e-3;   // balls of spatter are seldom larger [m]

/// What became of a bin.
class ChangedBins
{
public:
  ChangedBins(const ComparedScans& scans, const CompareBins& bins) : scans_(scans), bins_(bins) {}

  /// How far the bin lies below both the target and the surface before: what grinding took off below the target [m].
  /// How the scans lie along the plates is uncertain: the lowest place before that may have been here counts, so that
  /// an undercut that seems to have moved is none.
  double taken(int row, int column) const
  {
    return std::min(0.0, before(row, column).first) - bins_.at(row, column).above;
  }

  /// How far the bin lies above the highest place before that may have been here [m].
  double raised(int row, int column) const { return bins_.at(row, column).above - before(row, column).second; }

private:
  /// Lowest and highest above the target in the scan before, of all that may have been here.
  std::pair<double, double> before(int row, int column) const
  {
    const CompareBins::Bin& bin = bins_.at(row, column);
    // what lay under spatter was not seen: the metal around it tells
    const double unseen = atSpatter(row, column) ? square(kSpatter / kElsewhere) : 0.0;
    // bins are squares: a narrow ellipse that runs obliquely through them would miss their middles
    const double wide = square(bins_.size()) / 12.0;
    const Eigen::Matrix2d covariance =
        displacement({ bin.x, bin.y, bin.z }) + (unseen + wide) * Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d inverse = covariance.inverse();
    const int steps = static_cast<int>(kElsewhere * std::sqrt(covariance.trace()) / bins_.size()) + 1;
    std::pair<double, double> range(bin.above + bin.taken, bin.above + bin.taken);
    for (int r = std::max(0, row - steps); r <= std::min(bins_.rows() - 1, row + steps); ++r)
    {
      for (int c = std::max(0, column - steps); c <= std::min(bins_.columns() - 1, column + steps); ++c)
      {
        const CompareBins::Bin& other = bins_.at(r, c);
        const Eigen::Vector2d off(other.x - bin.x, other.y - bin.y);
        if (other.points == 0 || !(off.dot(inverse * off) < square(kElsewhere)))
          continue;
        range.first = std::min(range.first, other.above + other.taken);
        range.second = std::max(range.second, other.above + other.taken);
      }
    }
    return range;
  }

  /// The foot of a ball blends into what it lies on, so the bins around count too.
  bool atSpatter(int row, int column) const
  {
    for (int r = std::max(0, row - 1); r <= std::min(bins_.rows() - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(bins_.columns() - 1, column + 1); ++c)
        if (bins_.at(r, c).spatter)
          return true;
    return false;
  }

  /// Covariance of where a place of the scan after lies in the scan before, seen from above.
  Eigen::Matrix2d displacement(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d from = place - scans_.aligned.about;
    Eigen::Matrix<double, 2, 6> jacobian;
    jacobian << 1.0, 0.0, 0.0, 0.0, from.z(), -from.y(), 0.0, 1.0, 0.0, -from.z(), 0.0, from.x();
    return jacobian * scans_.aligned.covariance * jacobian.transpose();
  }

  const ComparedScans& scans_;
  const CompareBins& bins_;
};

struct BinPlace
{
  int row = 0, column = 0;
};

/// Less is no depth: the limit, or what noise and alignment leave uncertain. Infinite without points.
double leastDepth(const ComparedScans& scans, const CompareBins& bins, const BinPlace& place, double limit)
{
  if (bins.at(place.row, place.column).points == 0)
    return INFINITY;
  return std::max(limit, kSure * std::sqrt(bins.variance(scans, place.row, place.column)));
}

/// Bins that were ground too deep: 1.
cv::Mat1b deepBins(const ComparedScans& scans, const CompareBins& bins, double limit)
{
  const ChangedBins changed(scans, bins);
  cv::Mat1b deep(bins.rows(), bins.columns(), std::uint8_t{ 0 });
  for (int row = 0; row < bins.rows(); ++row)
  {
    for (int column = 0; column < bins.columns(); ++column)
    {
      const double least = leastDepth(scans, bins, { row, column }, limit);
      if (CompareBins::depth(bins.at(row, column)) > least && changed.taken(row, column) > least)
        deep(row, column) = 1;
    }
  }
  return deep;
}

/// Bins that hang together.
struct Piece
{
  OverGroundSpot spot;
  int number = 0;
};

void deepen(const CompareBins::Bin& bin, double variance, Piece& piece)
{
  OverGroundSpot& spot = piece.spot;
  if (!(spot.depth.value > CompareBins::depth(bin)))
  {
    spot.x = bin.x, spot.y = bin.y;
    spot.depth = { CompareBins::depth(bin), std::sqrt(variance) };
  }
  spot.area += bin.area;
}
}  // namespace

OverGround overGround(const ComparedScans& scans, const CompareBins& bins, const PathFrame& path,
                      const CompareParams& params)
{
  OverGround ground;
  ground.of.assign(scans.grid.z.size(), 0);
  if (bins.rows() == 0)
    return ground;
  cv::Mat1i pieces;
  const int count = cv::connectedComponents(deepBins(scans, bins, params.over_ground_limit), pieces, 8, CV_32S);
  std::vector<Piece> found(static_cast<std::size_t>(count));  // the first is what is no piece
  for (int row = 0; row < bins.rows(); ++row)
    for (int column = 0; column < bins.columns(); ++column)
      if (pieces(row, column) > 0)
        deepen(bins.at(row, column), bins.variance(scans, row, column),
               found[static_cast<std::size_t>(pieces(row, column))]);
  for (int i = 0; i < count; ++i)
    found[static_cast<std::size_t>(i)].number = i;
  found.erase(found.begin());
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const Piece& piece) { return piece.spot.area < params.min_spot_area; }),
              found.end());
  std::stable_sort(found.begin(), found.end(),
                   [](const Piece& a, const Piece& b) { return a.spot.depth.value > b.spot.depth.value; });
  std::vector<std::uint16_t> rank(static_cast<std::size_t>(count), 0);
  for (Piece& piece : found)
  {
    piece.spot.s = path.locate(piece.spot.x, piece.spot.y, 0.0).s;
    ground.spots.push_back(piece.spot);
    rank[static_cast<std::size_t>(piece.number)] =
        static_cast<std::uint16_t>(std::min<std::size_t>(ground.spots.size(), UINT16_MAX));
  }
  for (std::size_t i = 0; i < ground.of.size(); ++i)
    if (scans.known(i) && std::isfinite(scans.maps.target[i]))
      ground.of[i] = rank[static_cast<std::size_t>(pieces(bins.rowOf(static_cast<double>(scans.grid.y[i])),
                                                          bins.columnOf(static_cast<double>(scans.grid.x[i]))))];
  return ground;
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
  const ChangedBins changed(scans, bins);
  for (int row = 0; row < bins.rows(); ++row)
  {
    for (int column = 0; column < bins.columns(); ++column)
    {
      const CompareBins::Bin& bin = bins.at(row, column);
      const double least = leastDepth(scans, bins, { row, column }, limit);
      areas.low += CompareBins::depth(bin) > least && changed.taken(row, column) <= least ? bin.area : 0.0;
      areas.higher += -bin.taken > least && changed.raised(row, column) > least ? bin.area : 0.0;
    }
  }
  return areas;
}
}  // namespace weld
}  // namespace weld_profiler
