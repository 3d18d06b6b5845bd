#include "grinding_lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kRounding = 1e-9;

/// The chord seen from above is shorter than it is.
double foreshortening(const ToePair& toes)
{
  return toes.width() / std::hypot(toes.width(), toes.z_right - toes.z_left);
}
}  // namespace

Lanes::Lanes(const WeldLattice& lattice, const Layer& layer, const GrindingParams& params)
  : left_(std::numeric_limits<double>::infinity()),
    right_(-std::numeric_limits<double>::infinity()),
    margin_(layer.corner ? 0.0 : params.margin),
    half_tool_(0.5 * params.tool_width),
    corner_(layer.corner)
{
  double widest = 0.0;
  for (int i = 0; i < lattice.rowCount(); ++i)
  {
    const LatticeRow& row = lattice.rows[static_cast<std::size_t>(i)];
    for (int j = row.left; row.valid && j <= row.right; ++j)
    {
      const std::size_t at = lattice.at(i, j);
      if (!(layer.of(lattice.to_remove[at]) > params.min_removal))
        continue;
      const double share = (lattice.q[at] - row.toes.left) / row.toes.width();
      left_ = std::min(left_, share), right_ = std::max(right_, share);
      widest = std::max(widest, row.toes.width() / foreshortening(row.toes));
    }
  }
  if (left_ > right_)
    return;
  if (layer.level <= 0.0)
    left_ = 0.0, right_ = 1.0;
  const double needed = (right_ - left_) * widest + 2.0 * margin_ - params.tool_width;
  const double spacing = (1.0 - params.overlap) * params.tool_width;
  count_ = 1 + std::max(0, static_cast<int>(std::ceil(needed / spacing - kRounding)));
}

Lanes::Span Lanes::span(const ToePair& toes) const
{
  const double inset = (half_tool_ - margin_) * foreshortening(toes);
  const double from = toes.left + left_ * toes.width() + inset, to = toes.left + right_ * toes.width() - inset;
  if (count_ < 2 || !(to > from))
    return { 0.5 * (from + to), 0.0 };
  return { from, (to - from) / (count_ - 1) };
}

bool Lanes::fits(const ToePair& toes) const
{
  return !corner_ || toes.width() >= 2.0 * half_tool_ * foreshortening(toes);
}

double Lanes::middle(const ToePair& toes, int lane) const
{
  const Span lanes = span(toes);
  const double middle = lanes.from + lane * lanes.step, inset = half_tool_ * foreshortening(toes);
  if (!corner_ || !fits(toes))
    return middle;
  return std::min(std::max(middle, toes.left + inset), toes.right - inset);
}

int Lanes::laneOf(const ToePair& toes, double q) const
{
  const Span lanes = span(toes);
  if (!(lanes.step > 0.0))
    return 0;
  return std::min(std::max(static_cast<int>(std::lround((q - lanes.from) / lanes.step)), 0), count_ - 1);
}
}  // namespace weld
}  // namespace weld_profiler
