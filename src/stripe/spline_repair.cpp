#include "spline_repair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "least_squares_cubic.h"
#include "natural_spline.h"
#include "normal_angle.h"
#include "robust_line.h"

namespace weld_profiler
{
namespace
{
constexpr int kSideCells = 15;  ///< cells either side that hold the curve; also of a coarser grid, or it is too stiff
constexpr std::size_t kLeastSideCells = 4;
constexpr double kTear = 3.0;           ///< rows a column from which neighbours are not one line
constexpr double kRoughest = 0.12;      ///< residual of the fit from which the break is an edge [px]
constexpr double kLeastOutlier = 0.05;  ///< residual that is never an outlier [px]
constexpr double kOutlierSigmas = 3.0;
constexpr double kRoughestSigmas = 3.0;
constexpr std::size_t kEndCells = 3;  ///< centres next to a break that may follow its edge
constexpr double kLeastStep = 1.0;    ///< by which both sides must miss each other in the middle to be a step [px]
constexpr double kStepPerGap = 0.1;   ///< ... and more for a longer break, in which a smooth line may bend [px / px]
constexpr double kUnseen = 9.5e-4;    ///< error of a filled cell by curvature nobody saw, per px^2 (docs/paper.md)
constexpr double kShared = 0.67;      ///< of an error is the same in neighbours that were measured over common pixels
static_assert(2 * kSideCells <= NaturalSpline::kMostKnots, "the literal reading passes through all of them");

/// The centres either side of a break, [first, left] and [right, last].
struct Break
{
  std::size_t first, left, right, last;

  bool held() const { return left - first + 1 >= kLeastSideCells && last - right + 1 >= kLeastSideCells; }
  std::size_t count() const { return left - first + last - right + 2; }

  template <class Use>
  void each(Use&& use) const
  {
    for (std::size_t i = first; i <= last; i = i == left ? right : i + 1)
      use(i);
  }
};

/// The centre line as a function of where it is along the stripe, and the curve that bridges one break in it.
class Bridge
{
public:
  explicit Bridge(const Stripe& stripe)
    : stripe_(stripe),
      along_u_(stripe.direction == Direction::AlongU),
      along_(along_u_ ? stripe.u : stripe.v),
      across_(along_u_ ? stripe.v : stripe.u)
  {
  }

  /// @return false where the break is an edge or has nothing to hold a curve.
  bool span(std::size_t left, const RepairSettings& settings)
  {
    sides_ = sidesOf(left, 2 * settings.pitch);
    if (!sides_.held())
      return false;
    const double middle = 0.5 * (stripe_.cell[sides_.left] + stripe_.cell[sides_.right]);
    const double gap = stripe_.cell[sides_.right] - stripe_.cell[sides_.left];
    const double miss = std::min(missInTheMiddle(middle, 0), missInTheMiddle(middle, kEndCells));
    if (miss > std::max(kLeastStep, kStepPerGap * gap))
      return false;
    fitCurve(middle, std::numeric_limits<double>::infinity());
    // The last centres before a break often follow its edge: once more without what stands out.
    const double roughness = fitCurve(middle, std::max(kLeastOutlier, kOutlierSigmas * typicalResidual()));
    double sigma = 0.0;
    sides_.each([&](std::size_t i) { sigma += stripe_.sigma[i] / static_cast<double>(sides_.count()); });
    sigma *= std::hypot(1.0, curve_.slope(middle));  // across the stripe -> down a column
    sigma_ = std::max(sigma, roughness);
    interpolating_ = settings.interpolating && fitInterpolation();
    return roughness <= std::max(kRoughest, kRoughestSigmas * sigma);
  }

  StripePoint at(int cell) const
  {
    const StripePoint left = stripe_[sides_.left];
    const StripePoint right = stripe_[sides_.right];
    const auto share = static_cast<float>(cell - left.cell) / static_cast<float>(right.cell - left.cell);
    const double across = interpolating_ ? interpolation_.at(cell) : curve_.at(cell);
    const double slope = curve_.slope(cell);
    const double unseen = kUnseen * (cell - left.cell) * (right.cell - cell);
    StripePoint point;
    point.cell = static_cast<std::uint16_t>(cell);
    point.u = static_cast<float>(along_u_ ? cell : across);
    point.v = static_cast<float>(along_u_ ? across : cell);
    point.normal_angle = normalAngle(along_u_ ? std::atan2(1.0, -slope) : std::atan2(-slope, 1.0));
    point.intensity = (1.0F - share) * left.intensity + share * right.intensity;
    point.width = (1.0F - share) * left.width + share * right.width;
    const double seen = sigma_ * std::hypot(kShared, curve_.sigmaGain(cell));
    point.sigma = static_cast<float>(std::hypot(seen, unseen) / std::sqrt(1.0 + slope * slope));
    point.flags = stripe_flag::kInterpolated;
    return point;
  }

private:
  double residual(std::size_t i) const { return std::abs(curve_.at(along_[i]) - across_[i]); }

  /// 1-sigma of the residuals by their median.
  double typicalResidual() const
  {
    std::array<double, NaturalSpline::kMostKnots> residuals{};
    std::size_t count = 0;
    sides_.each([&](std::size_t i) { residuals[count++] = residual(i); });
    std::nth_element(residuals.begin(), residuals.begin() + count / 2, residuals.begin() + count);
    return 1.4826 * residuals[count / 2];
  }

  /// Fits the cubic to the centres that lie within `limit` of the one before.
  /// @return the RMS residual of those.
  double fitCurve(double middle, double limit)
  {
    const LeastSquaresCubic before = curve_;
    const auto used = [&](std::size_t i) { return !(std::abs(before.at(along_[i]) - across_[i]) > limit); };
    curve_.begin(middle, std::max(middle - stripe_.cell[sides_.first], stripe_.cell[sides_.last] - middle) + 1.0);
    sides_.each(
        [&](std::size_t i)
        {
          if (used(i))
            curve_.add(along_[i], across_[i]);
        });
    curve_.solve();
    double squares = 0.0;
    double count = 0.0;
    sides_.each(
        [&](std::size_t i)
        {
          squares += used(i) ? residual(i) * residual(i) : 0.0;
          count += used(i) ? 1.0 : 0.0;
        });
    return std::sqrt(squares / std::max(1.0, count - 4.0));
  }

  bool torn(std::size_t i) const
  {
    const double columns = std::abs(static_cast<double>(along_[i + 1]) - along_[i]);
    return std::abs(static_cast<double>(across_[i + 1]) - across_[i]) > kTear * columns + 1.0;
  }

  Break sidesOf(std::size_t left, int max_step) const
  {
    const auto& cell = stripe_.cell;
    Break sides{ left, left, left + 1, left + 1 };
    while (sides.first > 0 && cell[left] - cell[sides.first - 1] < kSideCells && !torn(sides.first - 1) &&
           cell[sides.first] - cell[sides.first - 1] <= max_step)
      --sides.first;
    while (sides.last + 1 < cell.size() && cell[sides.last + 1] - cell[sides.right] < kSideCells && !torn(sides.last) &&
           cell[sides.last + 1] - cell[sides.last] <= max_step)
      ++sides.last;
    return sides;
  }

  /// How far the straight continuations of both sides pass each other. On an arc they meet, across a step they do not.
  /// @param skipped  centres next to the break that are left out: they often follow its edge.
  double missInTheMiddle(double middle, std::size_t skipped) const
  {
    if (sides_.left - sides_.first + 1 < skipped + kLeastSideCells ||
        sides_.last - sides_.right + 1 < skipped + kLeastSideCells)
      return std::numeric_limits<double>::infinity();
    RobustLine left;
    RobustLine right;
    for (std::size_t i = sides_.left - skipped + 1; i-- > sides_.first;)
      left.add(along_[i], across_[i]);
    for (std::size_t i = sides_.right + skipped; i <= sides_.last; ++i)
      right.add(along_[i], across_[i]);
    return std::abs(left.at(middle) - right.at(middle));
  }

  bool fitInterpolation()
  {
    std::array<double, NaturalSpline::kMostKnots> x{};
    std::array<double, NaturalSpline::kMostKnots> y{};
    std::size_t count = 0;
    bool rising = true;
    sides_.each(
        [&](std::size_t i)
        {
          rising = rising && (count == 0 || along_[i] > x[count - 1]);
          x[count] = along_[i];
          y[count++] = across_[i];
        });
    if (rising)
      interpolation_.fit(x, y, count);
    return rising;
  }

  const Stripe& stripe_;
  bool along_u_;
  const std::vector<float>& along_;
  const std::vector<float>& across_;
  Break sides_{};
  LeastSquaresCubic curve_;
  NaturalSpline interpolation_;
  bool interpolating_ = false;
  double sigma_ = 0.0;
};
}  // namespace

void repairGaps(const RepairSettings& settings, Stripe& stripe, Stripe& memory)
{
  if (settings.max_gap_px == 0 || stripe.size() < 2 * kLeastSideCells)
    return;
  if (stripe.cell.back() - stripe.cell.front() == static_cast<int>(stripe.size() - 1) * settings.pitch)
    return;  // no cell is missing
  Bridge bridge(stripe);
  memory.clear();
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    memory.push_back(stripe[i]);
    if (i + 1 == stripe.size())
      break;
    const int gap = stripe.cell[i + 1] - stripe.cell[i] - settings.pitch;
    if (gap < settings.pitch || gap > settings.max_gap_px || !bridge.span(i, settings))
      continue;
    for (int cell = stripe.cell[i] + settings.pitch; cell < stripe.cell[i + 1]; cell += settings.pitch)
      if (cell >= settings.first_cell + settings.edge_trim_px && cell <= settings.last_cell - settings.edge_trim_px)
        memory.push_back(bridge.at(cell));
  }
  memory.direction = stripe.direction;
  memory.status = stripe.status;
  std::swap(stripe, memory);
}
}  // namespace weld_profiler
