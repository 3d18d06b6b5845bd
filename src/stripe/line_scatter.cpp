#include "line_scatter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace weld_profiler
{
/// One kind of difference along the line: sum of weight[k] * row(cell + k * lag).
struct LineScatter::Differences
{
  int order;
  int lag;            ///< [cells]
  std::size_t least;  ///< that must be found
  std::array<double, 4> weight;
  std::vector<double> LineScatter::*rows;

  int span() const { return order * lag; }
};

namespace
{
constexpr int kNone = -1;
constexpr double kUnknown = -1.0;
constexpr int kBlock = 64;                  ///< cells
constexpr std::size_t kFew = 8;             ///< below, a median says less than a mean square
constexpr double kMedianPerSigma = 0.6745;  ///< median of |x| of a normal value
constexpr double kShareOfWidth = 0.02;      ///< between a clean stripe (0.008) and a speckle contrast of 0.1 (0.06)

double meanSquare(const std::vector<Centre>& centres, double Centre::*field)
{
  double sum = 0.0;
  for (const Centre& centre : centres)
    sum += centre.*field * (centre.*field);
  return sum / static_cast<double>(centres.size());
}

double beyond(double sigma, double variance)
{
  return std::sqrt(std::max(0.0, sigma * sigma - variance));
}
}  // namespace

void LineScatter::measure(const std::vector<Centre>& centres)
{
  excess_.assign(centres.size(), 0.0);
  if (centres.empty())
    return;
  place(centres);
  if (!measureBlocks(centres))
    std::fill(excess_.begin(), excess_.end(), ofAShortStripe(centres));
}

void LineScatter::place(const std::vector<Centre>& centres)
{
  const int first = centres.front().cell;
  const auto cells = static_cast<std::size_t>(centres.back().cell - first) + 1;
  piece_.assign(cells, kNone);
  variance_.assign(cells, 0.0);
  row_.resize(cells);
  initial_row_.resize(cells);
  int piece = -1;
  for (const Centre& centre : centres)
  {
    const auto cell = static_cast<std::size_t>(centre.cell - first);
    piece += piece < 0 || centre.starts_piece ? 1 : 0;
    piece_[cell] = piece;
    row_[cell] = centre.v - centre.slope * (centre.u - centre.cell);
    initial_row_[cell] = centre.initial_v;
    variance_[cell] = centre.read_sigma * centre.read_sigma;
  }
}

/// @return false if no block holds enough differences.
bool LineScatter::measureBlocks(const std::vector<Centre>& centres)
{
  // 6 cells lie beyond the kernels' and the speckle's grain: the rows are independent.
  static const Differences kRule{ 3, 6, 8, { 1.0, -3.0, 3.0, -1.0 }, &LineScatter::row_ };
  const int cells = static_cast<int>(piece_.size());
  const int count = (cells + kBlock - 1) / kBlock;
  blocks_.assign(static_cast<std::size_t>(count), kUnknown);
  bool any = false;
  for (int block = 0; block < count; ++block)
  {
    const int begin = block * kBlock;
    const int end = std::min(cells, begin + kBlock);
    collect(kRule, begin - kRule.lag, end - kRule.lag);
    if (differences_.size() < kRule.least)
      continue;
    double variance = 0.0;
    double held = 0.0;
    for (int cell = begin; cell < end; ++cell)
    {
      variance += variance_[static_cast<std::size_t>(cell)];
      held += piece_[static_cast<std::size_t>(cell)] != kNone ? 1.0 : 0.0;
    }
    blocks_[static_cast<std::size_t>(block)] = beyond(scatter(kRule), variance / std::max(1.0, held));
    any = true;
  }
  const auto known = [&](int block)
  { return block >= 0 && block < count && blocks_[static_cast<std::size_t>(block)] != kUnknown; };
  for (std::size_t i = 0; any && i < centres.size(); ++i)
  {
    const int block = (centres[i].cell - centres.front().cell) / kBlock;
    int away = 0;
    while (!known(block - away) && !known(block + away))
      ++away;
    excess_[i] = blocks_[static_cast<std::size_t>(known(block - away) ? block - away : block + away)];
  }
  return any;
}

double LineScatter::ofAShortStripe(const std::vector<Centre>& centres)
{
  // 3 cells: beyond the speckle's grain. Second differences see curvature as scatter, and so serve the shortest only.
  static const std::array<Differences, 3> kRules = {
    { { 3, 3, 4, { 1.0, -3.0, 3.0, -1.0 }, &LineScatter::initial_row_ },
      { 2, 3, 1, { 1.0, -2.0, 1.0, 0.0 }, &LineScatter::initial_row_ },
      { 2, 2, 1, { 1.0, -2.0, 1.0, 0.0 }, &LineScatter::initial_row_ } }
  };
  const double initial = meanSquare(centres, &Centre::initial_sigma);
  const double gain = initial > 0.0 ? std::sqrt(meanSquare(centres, &Centre::read_sigma) / initial) : 1.0;
  for (const Differences& rule : kRules)
  {
    collect(rule, 0, static_cast<int>(piece_.size()));
    if (differences_.size() >= rule.least)
      return gain * beyond(scatter(rule), initial);
  }
  return kShareOfWidth * std::sqrt(meanSquare(centres, &Centre::sigma_column));
}

/// Gathers the differences that start in cells [first, last) and lie within one piece.
void LineScatter::collect(const Differences& rule, int first, int last)
{
  differences_.clear();
  const double* rows = (this->*rule.rows).data();
  const int end = std::min(last, static_cast<int>(piece_.size()) - rule.span());
  for (int cell = std::max(0, first); cell < end; ++cell)
  {
    const int* piece = piece_.data() + cell;
    double sum = 0.0;
    bool whole = *piece != kNone;
    for (int k = 0; k <= rule.order; ++k)
    {
      whole = whole && piece[k * rule.lag] == *piece;
      sum += rule.weight[static_cast<std::size_t>(k)] * rows[cell + k * rule.lag];
    }
    if (whole)
      differences_.push_back(std::abs(sum));
  }
}

/// 1-sigma of a row, from the differences gathered.
double LineScatter::scatter(const Differences& rule)
{
  double gain = 0.0;
  for (const double weight : rule.weight)
    gain += weight * weight;
  if (differences_.size() < kFew)
  {
    double squares = 0.0;
    for (const double difference : differences_)
      squares += difference * difference;
    return std::sqrt(squares / static_cast<double>(differences_.size()) / gain);
  }
  const auto middle = differences_.begin() + static_cast<std::ptrdiff_t>(differences_.size() / 2);
  std::nth_element(differences_.begin(), middle, differences_.end());
  return *middle / kMedianPerSigma / std::sqrt(gain);
}
}  // namespace weld_profiler
