#pragma once

#include <vector>

namespace weld_profiler
{
/// A piece of the weld and how often it counts.
struct Stretch
{
  double begin = 0.0;  ///< along the path [m]
  double end = 0.0;
  double weight = 0.0;
};

/// What each section stands for: half way to its neighbours, but not across a gap. A step of three times the usual one
/// (the median of eleven about it) and more is a gap; of it a section takes half a usual step. A lone section stands
/// for no length.
/// @param s  of the sections, rising [m].
/// @return   a stretch of weight 1 a section.
/// @throws PreconditionError if s does not rise.
std::vector<Stretch> cellsOf(const std::vector<double>& s);

/// The gaps between stretches, each of this weight.
std::vector<Stretch> gapsBetween(const std::vector<Stretch>& cells, double weight);

/// The largest weighted length within any window of the weld. The order of stretches does not matter.
double mostWithin(const std::vector<Stretch>& stretches, double window);
}  // namespace weld_profiler
