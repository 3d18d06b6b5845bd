#include "spline_repair.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace weld_profiler
{
namespace
{
constexpr int kSideCells = 15;  ///< centres either side that hold the curve
constexpr int kLeastSideCells = 4;
constexpr double kTear = 3.0;       ///< rows a column from which neighbours are not one line
constexpr double kRoughest = 0.35;  ///< residual of the fit from which the break is an edge [px]
constexpr double kRoughestSigmas = 3.0;
constexpr double kSpread =
    6.5e-4;  ///< error of a filled cell from the curvature it can't see, per px^2 (docs/paper.md)

/// The centre line as a function of its cell, whichever way it runs.
struct Line
{
  explicit Line(const Stripe& stripe)
    : along(stripe.direction == Direction::AlongU ? stripe.u : stripe.v),
      across(stripe.direction == Direction::AlongU ? stripe.v : stripe.u)
  {
  }
  const std::vector<float>& along;
  const std::vector<float>& across;
};

/// The centres either side of a break, [first, left] and [right, last].
struct Break
{
  std::size_t first, left, right, last;
};

bool torn(const Line& line, std::size_t i)
{
  const double columns = std::abs(static_cast<double>(line.along[i + 1]) - line.along[i]);
  return std::abs(static_cast<double>(line.across[i + 1]) - line.across[i]) > kTear * columns + 1.0;
}

Break sidesOf(const Stripe& stripe, const Line& line, std::size_t left, int max_step)
{
  Break sides{ left, left, left + 1, left + 1 };
  while (sides.first > 0 && left - sides.first + 1 < kSideCells && !torn(line, sides.first - 1) &&
         stripe.cell[sides.first] - stripe.cell[sides.first - 1] <= max_step)
    --sides.first;
  while (sides.last + 1 < stripe.size() && sides.last - sides.right + 1 < kSideCells && !torn(line, sides.last) &&
         stripe.cell[sides.last + 1] - stripe.cell[sides.last] <= max_step)
    ++sides.last;
  return sides;
}

/// A cubic through both sides by least squares.
class Cubic
{
public:
  /// @return false where the sides are not one smooth line.
  bool fit(const Stripe& stripe, const Line& line, const Break& sides)
  {
    middle_ = 0.5 * (stripe.cell[sides.left] + stripe.cell[sides.right]);
    scale_ = std::max(middle_ - stripe.cell[sides.first], stripe.cell[sides.last] - middle_);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    double sigma = 0.0;
    const auto count = static_cast<double>(sides.left - sides.first + sides.last - sides.right + 2);
    const auto each = [&](auto&& use)
    {
      for (std::size_t i = sides.first; i <= sides.last; i = i == sides.left ? sides.right : i + 1)
        use(i, basis(line.along[i]));
    };
    each(
        [&](std::size_t i, const Eigen::Vector4d& row)
        {
          normal += row * row.transpose();
          right += row * static_cast<double>(line.across[i]);
          sigma += stripe.sigma[i] / count;
        });
    const Eigen::LDLT<Eigen::Matrix4d> solver(normal);
    coefficients_ = solver.solve(right);
    covariance_ = solver.solve(Eigen::Matrix4d::Identity());
    double squares = 0.0;
    each(
        [&](std::size_t i, const Eigen::Vector4d& row)
        {
          const double residual = row.dot(coefficients_) - line.across[i];
          squares += residual * residual;
        });
    const double roughness = std::sqrt(squares / std::max(1.0, count - 4.0));
    sigma_ = std::max(sigma, roughness);
    return std::isfinite(roughness) && roughness <= std::max(kRoughest, kRoughestSigmas * sigma);
  }

  double at(double along) const { return basis(along).dot(coefficients_); }

  double slope(double along) const
  {
    const double x = (along - middle_) / scale_;
    return (coefficients_[1] + 2.0 * coefficients_[2] * x + 3.0 * coefficients_[3] * x * x) / scale_;
  }

  double sigma(double along) const
  {
    const Eigen::Vector4d row = basis(along);
    return sigma_ * std::sqrt(std::max(0.0, row.dot(covariance_ * row)));
  }

private:
  Eigen::Vector4d basis(double along) const
  {
    const double x = (along - middle_) / scale_;
    return { 1.0, x, x * x, x * x * x };
  }

  double middle_ = 0.0;
  double scale_ = 1.0;
  double sigma_ = 0.0;
  Eigen::Vector4d coefficients_ = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance_ = Eigen::Matrix4d::Zero();
};

StripePoint pointBetween(const Stripe& stripe, const Break& sides, int cell, const Cubic& curve)
{
  const StripePoint left = stripe[sides.left];
  const StripePoint right = stripe[sides.right];
  const double share = static_cast<double>(cell - left.cell) / (right.cell - left.cell);
  const bool along_u = stripe.direction == Direction::AlongU;
  const double across = curve.at(cell);
  const double slope = curve.slope(cell);
  const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
  const double unseen = kSpread * (cell - left.cell) * (right.cell - cell);
  StripePoint point;
  point.cell = static_cast<std::uint16_t>(cell);
  point.u = static_cast<float>(along_u ? cell : across);
  point.v = static_cast<float>(along_u ? across : cell);
  double angle = along_u ? std::atan2(1.0, -slope) : std::atan2(-slope, 1.0);
  if (angle > 0.5 * std::acos(-1.0))
    angle -= std::acos(-1.0);
  point.normal_angle = static_cast<float>(angle);
  point.intensity = static_cast<float>((1.0 - share) * left.intensity + share * right.intensity);
  point.width = static_cast<float>((1.0 - share) * left.width + share * right.width);
  point.sigma = static_cast<float>(
      cosine * std::hypot(std::max<double>({ left.sigma, right.sigma }) + curve.sigma(cell), unseen));
  point.flags = stripe_flag::kInterpolated;
  return point;
}
}  // namespace

void repairGaps(const RepairSettings& settings, Stripe& stripe, Stripe& memory)
{
  if (settings.max_gap_px == 0 || stripe.size() < 2 * kLeastSideCells)
    return;
  const Line line(stripe);
  memory.clear();
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    memory.push_back(stripe[i]);
    if (i + 1 == stripe.size())
      break;
    const int gap = stripe.cell[i + 1] - stripe.cell[i] - settings.pitch;
    if (gap < settings.pitch || gap > settings.max_gap_px)
      continue;
    const Break sides = sidesOf(stripe, line, i, settings.pitch * 2);
    Cubic curve;
    if (sides.left - sides.first + 1 < kLeastSideCells || sides.last - sides.right + 1 < kLeastSideCells ||
        !curve.fit(stripe, line, sides))
      continue;
    for (int cell = stripe.cell[i] + settings.pitch; cell < stripe.cell[i + 1]; cell += settings.pitch)
      if (cell >= settings.first_cell + settings.edge_trim_px && cell <= settings.last_cell - settings.edge_trim_px)
        memory.push_back(pointBetween(stripe, sides, cell, curve));
  }
  memory.direction = stripe.direction;
  memory.status = stripe.status;
  std::swap(stripe, memory);
}
}  // namespace weld_profiler
