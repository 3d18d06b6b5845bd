#include "gauss_model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace
{
constexpr int kUnknowns = 4;
constexpr int kCentre = 1, kBackground = 3;  ///< among them: amplitude, centre, sigma, background
constexpr int kSteps = 30;                   ///< 3 to 6 are enough where the top is not clipped
constexpr double kSettled = 1e-4;            ///< [px]
constexpr double kFirstDamping = 1e-3;       ///< share of the information's diagonal
constexpr double kLargestDamping = 1e8;
constexpr double kNarrowest = 0.2;  ///< 1-sigma that samples a pixel apart still tell [px]

using Vector = Eigen::Matrix<double, kUnknowns, 1>;
using Matrix = Eigen::Matrix<double, kUnknowns, kUnknowns>;

/// What one pixel says about its own expected gray and about its own variance.
struct Term
{
  double cost = 0.0;   ///< minus the logarithm of the likelihood, without its constant
  double score = 0.0;  ///< minus the cost's derivative by the expected gray
  double weight = 0.0;
  double variance_score = 0.0;  ///< minus the cost's derivative by the variance
  double variance_weight = 0.0;
};

/// phi(z) / Phi(z) and -ln Phi(z) of the normal distribution, without overflow far below.
void normalTail(double z, double& ratio, double& cost)
{
  constexpr double kFar = -8.0;
  constexpr double kRootTwo = 1.41421356237309504880;
  constexpr double kLogRootTwoPi = 0.91893853320467274178;
  if (z < kFar)
  {
    const double correction = 1.0 - 1.0 / (z * z);  // asymptotic series of Mills' ratio
    ratio = -z / correction;
    cost = 0.5 * z * z + kLogRootTwoPi + std::log(-z / correction);
    return;
  }
  const double probability = 0.5 * std::erfc(-z / kRootTwo);
  ratio = std::exp(-0.5 * z * z - kLogRootTwoPi) / probability;
  cost = -std::log(probability);
}

Term termOf(double gray, bool clipped, double expected, double variance)
{
  const double residual = gray - expected;
  Term term;
  if (clipped)
  {
    const double sigma = std::sqrt(variance);
    const double z = -residual / sigma;
    double ratio = 0.0;
    normalTail(z, ratio, term.cost);
    term.score = ratio / sigma;
    term.weight = ratio * (ratio + z) / variance;
    term.variance_score = -0.5 * ratio * z / variance;
    return term;
  }
  term.cost = 0.5 * (residual * residual / variance + std::log(variance));
  term.score = residual / variance;
  term.weight = 1.0 / variance;
  term.variance_score = 0.5 * (residual * residual / variance - 1.0) / variance;
  term.variance_weight = 0.5 / (variance * variance);
  return term;
}

/// The signal of one row and its derivatives by amplitude, centre and sigma; that by the background is 1.
struct Signal
{
  double gray = 0.0;
  double slope[kBackground] = {};

  Signal(const GaussModel& model, double v)
  {
    const double x = (v - model.centre) / model.sigma;
    const double bell = std::exp(-0.5 * x * x);
    gray = model.amplitude * bell;
    slope[0] = bell;
    slope[kCentre] = gray * x / model.sigma;
    slope[2] = slope[kCentre] * x;
  }
};

struct Likelihood
{
  double cost = 0.0;
  Vector score = Vector::Zero();
  Matrix information = Matrix::Zero();  ///< its lower triangle
};

Term termOf(const GrayColumn& column, int i, const PixelNoise& noise, const GaussModel& model, const Signal& signal)
{
  const auto at = static_cast<std::size_t>(i);
  const double variance = noise.read * noise.read + noise.gain * signal.gray;
  return termOf(column.gray[at], column.clipped[at] != 0, signal.gray + model.background, variance);
}

/// Plain sums: an outer product of Eigen's a pixel takes twice the time.
Likelihood likelihoodOf(const GrayColumn& column, const PixelNoise& noise, const GaussModel& model)
{
  double cost = 0.0;
  double score[kUnknowns] = {};
  double information[kUnknowns][kUnknowns] = {};
  for (int i = 0; i < column.size(); ++i)
  {
    const Signal signal(model, column.first_row + i);
    const Term term = termOf(column, i, noise, model, signal);
    const double by_signal = term.score + noise.gain * term.variance_score;
    const double weight = term.weight + noise.gain * noise.gain * term.variance_weight;
    cost += term.cost;
    for (int row = 0; row < kBackground; ++row)
    {
      score[row] += by_signal * signal.slope[row];
      for (int column_of = 0; column_of <= row; ++column_of)
        information[row][column_of] += weight * signal.slope[row] * signal.slope[column_of];
      information[kBackground][row] += term.weight * signal.slope[row];
    }
    score[kBackground] += term.score;
    information[kBackground][kBackground] += term.weight;
  }
  Likelihood sum;
  sum.cost = cost;
  for (int row = 0; row < kUnknowns; ++row)
  {
    sum.score[row] = score[row];
    for (int column_of = 0; column_of <= row; ++column_of)
      sum.information(row, column_of) = information[row][column_of];
  }
  return sum;
}

GaussModel moved(const GaussModel& model, const Vector& step)
{
  return GaussModel{ model.amplitude + step[0], model.centre + step[1], model.sigma + step[2],
                     model.background + step[3] };
}

/// What a noise of noise.read in each pixel makes of the centre that the fit weighs out.
double readSigma(const GrayColumn& column, const PixelNoise& noise, const GaussFit& fit, const Matrix& information)
{
  const Vector centre = information.ldlt().solve(Vector::Unit(kCentre));
  double squares = 0.0;
  for (int i = 0; i < column.size(); ++i)
  {
    const Signal signal(fit.model, column.first_row + i);
    const double weight = termOf(column, i, noise, fit.model, signal).weight;
    double change = centre[kBackground];
    for (int row = 0; row < kBackground; ++row)
      change += signal.slope[row] * centre[row];
    squares += std::pow(weight * change, 2.0);
  }
  return noise.read * std::sqrt(squares);
}
}  // namespace

GaussFit fitGauss(const GrayColumn& column, const PixelNoise& noise, const GaussModel& start)
{
  GaussFit fit;
  fit.model = start;
  const auto told = column.size() - std::count(column.clipped.begin(), column.clipped.end(), 1);
  if (told <= kUnknowns)
    return fit;
  Likelihood here = likelihoodOf(column, noise, fit.model);
  double damping = kFirstDamping;
  for (int i = 0; i < kSteps && damping < kLargestDamping; ++i)
  {
    Matrix damped = here.information;
    damped.diagonal() *= 1.0 + damping;
    const Vector step = damped.ldlt().solve(here.score);
    const GaussModel next = moved(fit.model, step);
    Likelihood there;
    const bool possible = step.allFinite() && next.sigma > kNarrowest && next.amplitude > 0.0;
    if (possible)
      there = likelihoodOf(column, noise, next);
    if (!possible || !(there.cost <= here.cost))
    {
      damping *= 10.0;
      continue;
    }
    damping *= 0.1;
    fit.model = next;
    here = there;
    if (std::abs(step[1]) < kSettled && std::abs(step[2]) < 10.0 * kSettled)
    {
      fit.read_sigma = readSigma(column, noise, fit, here.information);
      // A centre that is known no better than the stripe is wide is not known.
      fit.settled = fit.read_sigma > 0.0 && fit.read_sigma < fit.model.sigma;
      break;
    }
  }
  return fit;
}

double gainOf(const GrayColumn& column, const GaussModel& model, double read)
{
  double excess = 0.0;
  double squares = 0.0;
  int told = 0;
  for (const std::uint8_t clipped : column.clipped)
    told += clipped == 0 ? 1 : 0;
  if (told <= kUnknowns)
    return 0.0;
  const double spent = static_cast<double>(told) / (told - kUnknowns);  // degrees of freedom that the fit took
  for (int i = 0; i < column.size(); ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const double signal = Signal(model, column.first_row + i).gray;
    const double residual = column.gray[at] - signal - model.background;
    if (column.clipped[at] != 0)
      continue;
    excess += (spent * residual * residual - read * read) * signal;
    squares += signal * signal;
  }
  return squares > 0.0 ? std::max(0.0, excess / squares) : 0.0;
}
}  // namespace weld_profiler
