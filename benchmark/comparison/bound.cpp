#include "comparison/bound.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace comparison
{
namespace
{
constexpr int kTable = 400;
constexpr double kPi = 3.14159265358979323846;
constexpr int kPhases = 5;  ///< sub-pixel places of the stripe that a bound is averaged over

/// Density and distribution of the standard normal.
double density(double x)
{
  return std::exp(-0.5 * x * x) / std::sqrt(2.0 * kPi);
}

/// P(a < X < b), without the loss of digits that a difference of two values near 1 has.
double probability(double a, double b)
{
  return a > 0.0 ? 0.5 * (std::erfc(a / std::sqrt(2.0)) - std::erfc(b / std::sqrt(2.0)))
                 : 0.5 * (std::erfc(-b / std::sqrt(2.0)) - std::erfc(-a / std::sqrt(2.0)));
}
}  // namespace

Bound::Bound(const BoundSettings& settings) : settings_(settings)
{
  for (int i = 0; i <= kTable; ++i)
    table_.push_back(pixelInformation(settings_.peak * i / kTable));
}

double Bound::pixelInformation(double light) const
{
  const double variance = std::pow(settings_.peak / settings_.snr, 2.0);
  const double s = std::sqrt(0.5 * variance * (1.0 + light / settings_.peak));
  const double s_by_light = 0.25 * variance / settings_.peak / s;
  const double mean = settings_.background + light;
  const double top = settings_.clip;
  const int first = std::clamp(static_cast<int>(mean - 9.0 * s) - 1, 0, static_cast<int>(top));
  const int last = std::clamp(static_cast<int>(mean + 9.0 * s) + 1, 0, static_cast<int>(top));
  double information = 0.0;
  for (int level = first; level <= last; ++level)
  {
    // A level holds what rounds to it; the lowest and the highest all that lies beyond.
    const bool lowest = level == 0, highest = level == static_cast<int>(top);
    const double below = lowest ? -40.0 : (level - 0.5 - mean) / s;
    const double above = highest ? 40.0 : (level + 0.5 - mean) / s;
    const double p = probability(below, above);
    if (!(p > 1e-280))
      continue;
    // d/dlight of P((level -+ 0.5 - mean) / s): the mean moves by 1, s by s_by_light.
    const double at_below = lowest ? 0.0 : density(below) * (1.0 + below * s_by_light);
    const double at_above = highest ? 0.0 : density(above) * (1.0 + above * s_by_light);
    const double change = (at_below - at_above) / s;
    information += change * change / p;
  }
  return information;
}

double Bound::informationAt(double light) const
{
  const double place = std::clamp(light / settings_.peak, 0.0, 1.0) * kTable;
  const auto i = std::min(static_cast<std::size_t>(place), table_.size() - 2);
  const double part = place - static_cast<double>(i);
  return (1.0 - part) * table_[i] + part * table_[i + 1];
}

double Bound::ofColumns(int columns) const
{
  const auto known = known_.find(columns);
  return known != known_.end() ? known->second : known_[columns] = computeOfColumns(columns);
}

double Bound::computeOfColumns(int columns) const
{
  const double cosine = 1.0 / std::sqrt(1.0 + settings_.slope * settings_.slope);
  const double sine = settings_.slope * cosine;
  const int half = columns / 2;
  const double reach = 7.0 * settings_.sigma / cosine;
  double variance = 0.0;
  for (int phase = 0; phase < kPhases; ++phase)
  {
    const double row = 0.17 + static_cast<double>(phase) / kPhases;
    double offset = 0.0, mixed = 0.0, turn = 0.0;  // Fisher information of offset and slope
    for (int x = -half; x <= half; ++x)
    {
      const double middle = row + settings_.slope * x;
      for (int y = static_cast<int>(std::ceil(middle - reach)); y <= middle + reach; ++y)
      {
        const double across = (y - middle) * cosine;
        const double along = x * cosine + (y - row) * sine;
        const double light = settings_.peak * std::exp(-0.5 * std::pow(across / settings_.sigma, 2.0));
        const double change = light * across / (settings_.sigma * settings_.sigma);
        const double weight = change * change * informationAt(light);
        offset += weight;
        mixed += weight * along;
        turn += weight * along * along;
      }
    }
    const double lost = half > 0 ? mixed * mixed / turn : 0.0;
    variance += 1.0 / (offset - lost) / kPhases;
  }
  return std::sqrt(variance);
}
}  // namespace comparison
}  // namespace weld_profiler
