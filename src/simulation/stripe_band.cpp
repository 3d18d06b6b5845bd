#include "simulation/stripe_band.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kReachSigmas = 4.5;  // a Gaussian is painted this far: 4e-5 of the peak
constexpr double kLensSigmas = 4.0;

/// Pixels that the lens spreads light over along the cells.
int reachOf(double lens_sigma)
{
  constexpr int kFarthest = 12;
  return std::min(kFarthest, static_cast<int>(std::ceil(kLensSigmas * lens_sigma)));
}

LitPoint between(const LitPoint& a, const LitPoint& b, double share)
{
  const auto mixed = [share](double from, double to) { return from + share * (to - from); };
  LitPoint point;
  point.pixel.across = mixed(a.pixel.across, b.pixel.across);
  point.amplitude = mixed(a.amplitude, b.amplitude);
  point.sheet_sigma = mixed(a.sheet_sigma, b.sheet_sigma);
  point.x = mixed(a.x, b.x);
  point.y = mixed(a.y, b.y);
  point.x_rate = mixed(a.x_rate, b.x_rate);
  point.y_rate = mixed(a.y_rate, b.y_rate);
  return point;
}
}  // namespace

StripeBand::StripeBand(int cells, int first, int last)
  : cells_(cells),
    columns_wide_(cells + 2 * kPad),
    first_(first),
    last_(last),
    sum_(static_cast<std::size_t>(columns_wide_) * static_cast<std::size_t>(std::max(0, last - first)), 0.0F)
{
}

void StripeBand::paint(const LitLine& line, const Brush& brush)
{
  sheet_.assign(sum_.size(), 0.0F);
  low_ = last_;
  high_ = first_;
  columns_.assign(static_cast<std::size_t>(columns_wide_), Column());
  paintColumns(line, brush);
  spreadAlong(brush.lens_sigma);
  fillGaps(reachOf(brush.lens_sigma));
  add(brush.speckle);
}

void StripeBand::paintColumns(const LitLine& line, const Brush& brush)
{
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const LitPoint& a = line[i];
    const LitPoint& b = line[i + 1];
    if (!a.joined || a.pixel.cell == b.pixel.cell)
      continue;
    const double low = std::min(a.pixel.cell, b.pixel.cell);
    const double high = std::max(a.pixel.cell, b.pixel.cell);
    const int last = std::min(cells_ + kPad - 1, static_cast<int>(std::ceil(high)) - 1);
    for (int cell = std::max(-kPad, static_cast<int>(std::ceil(low))); cell <= last; ++cell)
      paintColumn(cell + kPad, between(a, b, (cell - a.pixel.cell) / (b.pixel.cell - a.pixel.cell)), brush);
  }
}

void StripeBand::paintColumn(int index_in_row, const LitPoint& point, const Brush& brush)
{
  const double across = point.pixel.across + brush.shift;
  const double sigma = std::hypot(point.sheet_sigma, brush.lens_sigma);
  const double reach = kReachSigmas * sigma;
  if (!(across + reach >= first_ && across - reach <= last_ - 1))
    return;
  const int low = std::max(first_, static_cast<int>(std::ceil(across - reach)));
  const int high = std::min(last_ - 1, static_cast<int>(std::floor(across + reach)));
  low_ = std::min(low_, low);
  high_ = std::max(high_, high + 1);
  // exp(-d^2 / 2 s^2) over equal steps is a product of two running factors
  const double rate = 1.0 / (sigma * sigma);
  const double start = low - across;
  double value = brush.gain * point.amplitude * point.sheet_sigma / sigma * std::exp(-0.5 * start * start * rate);
  double factor = std::exp(-(start + 0.5) * rate);
  const double fall = std::exp(-rate);
  for (int row = low; row <= high; ++row, value *= factor, factor *= fall)
    sheet_[index(row) + static_cast<std::size_t>(index_in_row)] += static_cast<float>(value);
  Column& column = columns_[static_cast<std::size_t>(index_in_row)];
  column.low = std::min(column.low, static_cast<float>(low));
  column.high = std::max(column.high, static_cast<float>(high));
  column.across = across;
  column.x = point.x;
  column.y = point.y;
  column.x_rate = point.x_rate;
  column.y_rate = point.y_rate;
}

void StripeBand::spreadAlong(double sigma)
{
  const int reach = reachOf(sigma);
  std::vector<float> kernel;
  float total = 0.0F;
  for (int i = -reach; i <= reach; ++i)
    kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
  for (const float weight : kernel)
    total += weight;
  lens_.resize(sheet_.size());
  if (low_ < high_)
    std::fill(lens_.begin() + static_cast<std::ptrdiff_t>(index(low_)),
              lens_.begin() + static_cast<std::ptrdiff_t>(index(high_)), 0.0F);
  const int wide = columns_wide_;
  const float* middle = kernel.data() + reach;
  for (int row = low_; row < high_; ++row)
    for (int k = -reach; k <= reach; ++k)
    {
      const float weight = middle[k] / total;
      const float* from = sheet_.data() + index(row) + k;
      float* to = lens_.data() + index(row);
      for (int cell = std::max(0, -k); cell < wide - std::max(0, k); ++cell)
        to[cell] += weight * from[cell];
    }
}

void StripeBand::fillGaps(int reach)
{
  // Light that the lens throws into dark columns, or beyond its neighbours' rows, belongs to the surface it came from.
  const std::vector<Column> own = columns_;
  for (int cell = 0; cell < columns_wide_; ++cell)
  {
    Column& column = columns_[static_cast<std::size_t>(cell)];
    for (int away = 1; away <= reach; ++away)
      for (const int neighbour : { cell - away, cell + away })
      {
        if (neighbour < 0 || neighbour >= columns_wide_)
          continue;
        const Column& other = own[static_cast<std::size_t>(neighbour)];
        if (other.low > other.high)
          continue;
        if (column.low > column.high)
          column = other;
        column.low = std::min(column.low, other.low);
        column.high = std::max(column.high, other.high);
      }
  }
}

void StripeBand::add(const Speckle* speckle)
{
  if (speckle == nullptr || !speckle->on())
  {
    for (std::size_t i = low_ < high_ ? index(low_) : 0; low_ < high_ && i < index(high_); ++i)
      sum_[i] += lens_[i];
    return;
  }
  for (int row = low_; row < high_; ++row)
  {
    float* sum = &sum_[index(row)];
    const float* light = &lens_[index(row)];
    for (int cell = 0; cell < columns_wide_; ++cell)
    {
      const Column& column = columns_[static_cast<std::size_t>(cell)];
      if (row < column.low || row > column.high)
        continue;
      const double off = row - column.across;
      sum[cell] += light[cell] * (*speckle)(column.x + off * column.x_rate, column.y + off * column.y_rate);
    }
  }
}
}  // namespace simulation
}  // namespace weld_profiler
