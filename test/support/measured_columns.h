#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "stripe/along_stripe.h"
#include "stripe/column_track.h"

namespace weld_profiler
{
namespace test_support
{
constexpr int kColumns = 1500;

inline std::size_t slotOf(int u)
{
  return static_cast<std::size_t>(u) + ColumnTrack::kGuard;
}

/// One piece without light over so many columns.
inline ColumnTrack emptyTrack(int columns)
{
  ColumnTrack track;
  track.resize(static_cast<std::size_t>(columns) + 2 * ColumnTrack::kGuard);
  track.pieces.push_back(ColumnTrack::Piece{ ColumnTrack::kGuard, 0, columns });
  return track;
}

/// What ColumnMoments measures of a stripe of sigma 2 px at SNR 50, without an image.
struct Columns
{
  std::function<double(double)> row;        ///< the outline
  std::function<double(double)> reference;  ///< the track's line; empty = the outline
  double noise = 0.026;                     ///< of one column's centre [px]
  double light_noise = 0.0075;              ///< relative
  double speckle = 0.0;                     ///< error of a column that the flanks have the other way round [px]
  double lean = 0.0;                        ///< flanks minus core of a lopsided profile [px]
  unsigned seed = 1;
};

inline ColumnTrack trackOf(const Columns& columns)
{
  std::mt19937 random(columns.seed);
  std::normal_distribution<double> normal;
  ColumnTrack track = emptyTrack(kColumns);
  for (int u = 0; u < kColumns; ++u)
  {
    const std::size_t slot = slotOf(u);
    const double reference = columns.reference ? columns.reference(u) : columns.row(u);
    const double shared = columns.speckle * normal(random);
    const double core = columns.row(u) + columns.noise * normal(random) + shared - reference;
    track.v[slot] = static_cast<float>(reference);
    track.sigma[slot] = 2.0F;
    track.core[slot] = static_cast<float>(core);
    // The best weights' error and the difference to any others are not correlated.
    track.flanks[slot] = static_cast<float>(core + columns.lean - 2.0 * shared + 2.0 * columns.noise * normal(random));
    track.light[slot] = static_cast<float>(200.0 * (1.0 + columns.light_noise * normal(random)));
    track.spread[slot] = 1.0F;
    track.weight[slot] = 1.0F;
  }
  track.layOn(track.pieces.front());
  return track;
}

/// RMS of the rows' errors, and of error over the sigma told.
struct Judged
{
  double squares = 0.0, relative = 0.0;
  int count = 0;

  double error() const { return std::sqrt(squares / count); }
  double ratio() const { return std::sqrt(relative / count); }

  /// Columns [begin, end).
  void add(const AlongStripe& along, const std::function<double(double)>& row, int begin, int end)
  {
    for (int u = begin; u < end; ++u)
    {
      const std::size_t slot = slotOf(u);
      if (!(along.aperture()[slot] > 0.0F))
        continue;
      const double error = along.row()[slot] - row(u);
      squares += error * error;
      relative += std::pow(error / along.sigma()[slot], 2.0);
      ++count;
    }
  }
};

/// A straight outline.
inline Columns lineOf(double degrees)
{
  Columns columns;
  const double slope = std::tan(degrees * M_PI / 180.0);
  columns.row = [slope](double u) { return 300.0 + slope * u; };
  return columns;
}
}  // namespace test_support
}  // namespace weld_profiler
