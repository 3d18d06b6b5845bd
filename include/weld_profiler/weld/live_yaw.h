#pragma once

#include <vector>

#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
/// Tells which way a weld runs while it is being scanned, from the middles of the rows so far: a robust parabola
/// (Tukey's biweight) through those near by, with how far welds are yawed and bent for a prior.
///
/// Good for: a bead whose middle wanders by a few hundredths of a millimetre. Poor for: paths that turn within a few
/// millimetres; the first rows, which tell little, and say so.
class LiveYaw
{
public:
  /// The middle of the bead in a row, in the cloud's frame [m]. Rows hardly apart count once; after a jump those before
  /// are forgotten. What is not finite is left out.
  void add(double x, double y);

  /// Of the path against y at y, from +y toward -x, with its 1-sigma [rad]. Before the first row: 0 with the sigma of
  /// the prior.
  Quantity at(double y) const;

  void restart() { middles_.clear(); }

private:
  struct Middle
  {
    double x, y;
  };
  std::vector<Middle> middles_;
};
}  // namespace weld_profiler
