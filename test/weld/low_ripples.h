#pragma once

#include <cmath>
#include <vector>

#include "weld/ideal_scan.h"
#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
inline constexpr double kPi = 3.14159265358979323846;

/// Errors of the sections that tell a value.
struct Errors
{
  std::vector<double> errors, in_sigmas;

  void add(const Quantity& told, double truth)
  {
    if (!told.measured())
      return;
    errors.push_back(told.value - truth);
    in_sigmas.push_back(errors.back() / told.sigma);
  }
  double quadraticMean() const
  {
    double sum = 0.0;
    for (const double one : in_sigmas)
      sum += one * one / static_cast<double>(in_sigmas.size());
    return std::sqrt(sum);
  }
};

/// A low bead whose ripples trail at the toes by a third of its width, as molten pools leave them.
struct Crescents
{
  IdealWeld weld;
  double ripple = 1e-4, pitch = 1.2e-3;

  Crescents() { weld.width = 0.010, weld.height = 2e-4; }

  double operator()(double x, double y) const
  {
    const double share = 4.0 * x * x / (weld.width * weld.width);
    if (share >= 1.0 || y < weld.begin)
      return weld(x, y);
    const double phase = (y + 0.3 * weld.width * share) / pitch;
    return weld(x, y) + 0.5 * ripple * (1.0 - share) * std::sin(2.0 * kPi * phase);
  }
};

/// 20 mm of it, a row every 0.2 mm.
inline IdealScanner fineRows()
{
  IdealScanner scanner;
  scanner.rows = 100;
  return scanner;
}
}  // namespace weld_profiler
