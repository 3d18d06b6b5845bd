#pragma once

#include <vector>

namespace weld_profiler
{
namespace weld
{
/// A quantity along the weld, one value a section; NaN = not measured there, and stays so.
struct AlongWeld
{
  std::vector<double> value;
  std::vector<double> sigma;
};

/// Evens out what neighbouring sections measured, as far as noise explains their differences.
///
/// Local straight lines (robust, Tukey's biweight) over the window, out of four and none, that foretells left-out
/// sections best (cross validation). What then is left in a stretch beyond the sections' own sigmas is real change and
/// is kept (positive-part James-Stein, as docs/ridge.md has it). The told sigmas grow to the scatter that is observed.
/// @param s  of each section, rising [m].
AlongWeld smoothAlong(const std::vector<double>& s, const AlongWeld& raw);

/// How a quantity is continued to where it was not measured.
struct Continuation
{
  double reach = 0.0;   ///< from the nearest section that was measured [m]
  double window = 0.0;  ///< of measured sections, from the nearest on, that it is told from [m]
  bool level = false;   ///< by their mean; else by a straight line through them
};

/// Continues a quantity to sections where it was not measured. The sigma grows with the distance. For a plate, which
/// goes on where no one looks, and for maps; not for what is said to be measured.
AlongWeld continueAlong(const std::vector<double>& s, const AlongWeld& smooth, const Continuation& how);
}  // namespace weld
}  // namespace weld_profiler
