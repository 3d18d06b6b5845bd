#pragma once

#include <vector>

#include "simulation/shader.h"
#include "simulation/speckle.h"

namespace weld_profiler
{
namespace simulation
{
/// How a line of light is painted.
struct Brush
{
  double gain = 1.0;        ///< of the amplitude
  double shift = 0.0;       ///< across [px]
  double lens_sigma = 1.0;  ///< spread in every direction [px]
  const Speckle* speckle = nullptr;
};

/// The rows (across) in which the stripe lies, as mean signal [DN]. Row-major: a row runs along the cells.
class StripeBand
{
public:
  /// @param first,last  rows across, last excluded.
  StripeBand(int cells, int first, int last);

  /// Adds a line: each column's Gaussian across, then the lens along the cells, then speckle by surface point.
  void paint(const LitLine& line, const Brush& brush);

  int first() const { return first_; }
  int last() const { return last_; }
  int cells() const { return cells_; }
  const float* row(int across) const { return &sum_[index(across) + kPad]; }

private:
  static constexpr int kPad = 12;  ///< columns either side of the image, from which the lens spreads light inward

  struct Column  ///< what surface a column shows
  {
    float low = 1e9F, high = -1e9F;  ///< rows painted
    double across = 0.0, x = 0.0, y = 0.0, x_rate = 0.0, y_rate = 0.0;
  };

  std::size_t index(int across) const { return static_cast<std::size_t>(across - first_) * columns_wide_; }
  void paintColumns(const LitLine& line, const Brush& brush);
  void paintColumn(int cell, const LitPoint& point, const Brush& brush);
  void spreadAlong(double sigma);
  void add(const Speckle* speckle);
  void fillGaps(int reach);

  int cells_, columns_wide_, first_, last_;
  int low_ = 0, high_ = 0;  ///< rows that the line in work touches, high_ excluded
  std::vector<float> sum_;
  std::vector<float> sheet_, lens_;  ///< scratch of one line
  std::vector<Column> columns_;
};
}  // namespace simulation
}  // namespace weld_profiler
