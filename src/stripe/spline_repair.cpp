#include "spline_repair.h"

#include <algorithm>
#include <cmath>

#include "least_squares_cubic.h"
#include "natural_spline.h"

namespace weld_profiler
{
namespace
{
constexpr std::size_t kSideCells = 15;  ///< centres either side that hold the curve
constexpr std::size_t kLeastSideCells = 4;
constexpr double kTear = 3.0;       ///< rows a column from which neighbours are not one line
constexpr double kRoughest = 0.35;  ///< residual of the fit from which the break is an edge [px]
constexpr double kRoughestSigmas = 3.0;
constexpr double kUnseen = 6.5e-4;  ///< error of a filled cell by curvature nobody saw, per px^2 (docs/paper.md)
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
    curve_.begin(middle, std::max(middle - stripe_.cell[sides_.first], stripe_.cell[sides_.last] - middle) + 1.0);
    double sigma = 0.0;
    sides_.each(
        [&](std::size_t i)
        {
          curve_.add(along_[i], across_[i]);
          sigma += stripe_.sigma[i] / static_cast<double>(sides_.count());
        });
    curve_.solve();
    double squares = 0.0;
    sides_.each([&](std::size_t i) { squares += std::pow(curve_.at(along_[i]) - across_[i], 2.0); });
    const double roughness = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(sides_.count(), 5) - 4));
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
    point.normal_angle = normalAngle(slope);
    point.intensity = (1.0F - share) * left.intensity + share * right.intensity;
    point.width = (1.0F - share) * left.width + share * right.width;
    point.sigma = static_cast<float>(std::hypot(sigma_ * (1.0 + curve_.sigmaGain(cell)), unseen) /
                                     std::sqrt(1.0 + slope * slope));
    point.flags = stripe_flag::kInterpolated;
    return point;
  }

private:
  bool torn(std::size_t i) const
  {
    const double columns = std::abs(static_cast<double>(along_[i + 1]) - along_[i]);
    return std::abs(static_cast<double>(across_[i + 1]) - across_[i]) > kTear * columns + 1.0;
  }

  Break sidesOf(std::size_t left, int max_step) const
  {
    const auto& cell = stripe_.cell;
    Break sides{ left, left, left + 1, left + 1 };
    while (sides.first > 0 && left - sides.first + 1 < kSideCells && !torn(sides.first - 1) &&
           cell[sides.first] - cell[sides.first - 1] <= max_step)
      --sides.first;
    while (sides.last + 1 < cell.size() && sides.last - sides.right + 1 < kSideCells && !torn(sides.last) &&
           cell[sides.last + 1] - cell[sides.last] <= max_step)
      ++sides.last;
    return sides;
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

  float normalAngle(double slope) const
  {
    const double half_turn = std::acos(-1.0);
    const double angle = along_u_ ? std::atan2(1.0, -slope) : std::atan2(-slope, 1.0);
    return static_cast<float>(angle > 0.5 * half_turn ? angle - half_turn : angle);
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
