#include "parent_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr int kRounds = 6;
constexpr double kConverged = 1e-8;     // [m]
constexpr int kLongestLag = 60;         // of the residuals' correlation [cells]
constexpr double kLeastScatter = 5e-7;  // [m]
constexpr double kNearGuess = 4.0;      // flatnesses that a parent may lie off what the rows tell of it
constexpr double kNeighbour = 1.5e-3;   // what is off a parent for longer is not spatter on it [m]
constexpr double kHidden = 4.5e-3;      // no ball of spatter, at most 4 mm wide, hides it for longer [m]
constexpr double kShrunkReach = 6e-4;   // where little of a parent is in view, it begins this far from the toe [m]

struct Piece
{
  std::vector<double> q, z, weight;
  std::vector<double> residual;
};

using Numbers = Eigen::Map<Eigen::ArrayXd>;

/// Sum over the lags of the residuals' correlation: that many neighbours tell as much as one independent point.
double correlationLength(const Piece& piece)
{
  const std::size_t count = piece.residual.size();
  double variance = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    variance += piece.weight[i] * square(piece.residual[i]);
    weights += piece.weight[i];
  }
  if (!(variance > 0.0))
    return 1.0;
  double length = 1.0;
  for (std::size_t lag = 1; lag <= kLongestLag && lag < count / 2; ++lag)
  {
    double product = 0.0, pairs = 0.0;
    for (std::size_t i = lag; i < count; ++i)
    {
      const double weight = std::min(piece.weight[i], piece.weight[i - lag]);
      product += weight * piece.residual[i] * piece.residual[i - lag];
      pairs += weight;
    }
    const double correlation = pairs > 0.0 ? (product / pairs) / (variance / weights) : 0.0;
    if (correlation < 0.05)
      break;
    length += 2.0 * correlation;
  }
  return length;
}

Piece cut(const SectionProfile& profile, Side side, double from, double to)
{
  Piece piece;
  piece.q.reserve(profile.size());
  piece.z.reserve(profile.size());
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    const double outward = sign(side) * profile.q[i];
    if (outward < from || outward > to)
      continue;
    piece.q.push_back(profile.q[i]);
    piece.z.push_back(profile.z[i]);
  }
  piece.weight.assign(piece.q.size(), 1.0);
  piece.residual.resize(piece.q.size());
  return piece;
}

/// Robust scatter of the residuals, told from some hundred of them.
double scatterOf(const Piece& piece)
{
  constexpr std::size_t kEnough = 100;
  const std::size_t stride = piece.residual.size() / kEnough + 1;
  std::vector<double> some;
  some.reserve(piece.residual.size() / stride + 1);
  for (std::size_t i = 0; i < piece.residual.size(); i += stride)
    some.push_back(piece.residual[i]);
  return robustSigma(std::move(some));
}

/// One weighted regression about the piece's middle.
void regress(const Numbers& q, const Numbers& z, const Numbers& weight, ParentFit& fit)
{
  const double n = weight.sum(), middle = (weight * q).sum() / n, height = (weight * z).sum() / n;
  const double qq = (weight * (q - middle).square()).sum();
  const double qz = (weight * (q - middle) * (z - height)).sum();
  fit.middle = middle;
  fit.line.slope = qz / qq;
  fit.line.height = height - fit.line.slope * middle;
  fit.covariance = Eigen::Vector2d(1.0 / n, 1.0 / qq).asDiagonal();
}

void fitRobustly(const Line& guess, double scale, Piece& piece, ParentFit& fit)
{
  const auto count = static_cast<Eigen::Index>(piece.q.size());
  const Numbers q(piece.q.data(), count), z(piece.z.data(), count);
  Numbers weight(piece.weight.data(), count), residual(piece.residual.data(), count);
  fit.line = guess;
  for (int round = 0; round < kRounds; ++round)
  {
    const double upright = std::cos(fit.line.angle());
    residual = (z - fit.line.height - fit.line.slope * q) * upright;
    if (round > 0)
      scale = std::min(scale, std::max(scatterOf(piece), kLeastScatter));  // a clamp widens nothing
    // Tukey's biweight
    weight = (1.0 - (residual / (kTukeyReach * scale)).square()).max(0.0).square();
    if (!(weight.sum() > 8.0))
    {
      fit.line = Line();
      return;
    }
    const double last = fit.line.at(fit.middle);
    regress(q, z, weight, fit);
    if (round > 1 && std::abs(fit.line.at(fit.middle) - last) < kConverged)
      break;
  }
  fit.scatter = scale;
}
}  // namespace

double ParentFit::sigmaAt(double q) const
{
  const double d = q - middle;
  return std::sqrt(covariance(0, 0) + 2.0 * d * covariance(0, 1) + d * d * covariance(1, 1));
}

double roomBeside(const SectionProfile& profile, const ParentPiece& from, const Line& guess, const WeldParams& params)
{
  const double tolerance = kNearGuess * params.flatness;
  double room = 0.0, off_from = from.begin;
  const auto look = [&](std::size_t i)
  {
    const double outward = sign(from.side) * (profile.q[i] - from.toe);
    if (outward < from.begin)
      return true;
    if (!(std::abs(guess.above(profile.q[i], profile.z[i])) > tolerance))
    {
      // behind a clamp whose points were left out the plate is seen again
      if (room > 0.0 && outward - off_from > kHidden)
        return false;
      room = off_from = outward;
      return true;
    }
    // an undercut ends within its reach, spatter soon; another bead or a clamp does not
    return outward - off_from < kNeighbour || outward < params.undercut_reach;
  };
  if (from.side == Side::Right)
  {
    for (std::size_t i = 0; i < profile.size() && look(i); ++i)
    {
    }
  }
  else
  {
    for (std::size_t i = profile.size(); i > 0 && look(i - 1); --i)
    {
    }
  }
  return room;
}

double parentBegin(double room, const WeldParams& params)
{
  return std::max(kShrunkReach, std::min(params.undercut_reach, room - 2.0 * params.min_parent_length));
}

ParentFit fitParent(const SectionProfile& profile, const ParentPiece& where, const Line& guess,
                    const WeldParams& params)
{
  ParentFit fit;
  if (!guess.valid())
    return fit;
  const Side side = where.side;
  const double from = sign(side) * where.toe + where.begin;
  Piece piece = cut(profile, side, from, from + std::min(where.length, params.parent_length));
  if (piece.q.size() < 10)
    return fit;
  fitRobustly(guess, 3.0 * params.flatness, piece, fit);
  if (!fit.valid())
    return fit;
  double used_from = INFINITY, used_to = -INFINITY;
  for (std::size_t i = 0; i < piece.q.size(); ++i)
  {
    if (!(piece.weight[i] > 0.0))
      continue;
    ++fit.points;
    used_from = std::min(used_from, sign(side) * piece.q[i]);
    used_to = std::max(used_to, sign(side) * piece.q[i]);
  }
  if (!(used_to - used_from >= params.min_parent_length) || 3 * fit.points < static_cast<int>(piece.q.size()))
  {
    fit.line = Line();
    return fit;
  }
  fit.inner = sign(side) * used_from;
  fit.outer = sign(side) * used_to;
  fit.correlated_cells = where.correlation ? correlationLength(piece) : 1.0;
  fit.covariance *= square(fit.scatter) * fit.correlated_cells;
  return fit;
}
}  // namespace weld
}  // namespace weld_profiler
