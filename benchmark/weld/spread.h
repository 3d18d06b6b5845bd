#pragma once

#include <functional>
#include <string>
#include <vector>

#include "weld/weld_case.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// A size, or the same one of both sides, as a person reads it.
struct Group
{
  const char* name;
  std::vector<Size> sizes;
  double scale;  ///< from SI to the unit printed
  const char* unit;
  bool folded;  ///< never negative: near 0 its error is not normal
};
const std::vector<Group>& groups();
const Group& group(const std::string& name);

/// Which sections take part.
using Chosen = std::function<bool(const WeldCase&, const SectionCase&)>;
bool counts(const WeldCase& weld, const SectionCase& section);  ///< the sections that the bars hold for

/// Measured and true sizes of the chosen sections, in the group's unit.
struct Sample
{
  std::uint64_t seed;
  Deviation size;
};
std::vector<Sample> samplesOf(const std::vector<WeldCase>& welds, const Group& group, const Chosen& chosen);

/// NaN of an empty list.
double quantile(std::vector<double> values, double share);

/// How errors are spread, in the group's unit.
struct Spread
{
  std::size_t count = 0;  ///< compared
  double known = kNaN;    ///< share of the sections with a width that have this size too
  double median = kNaN, within95 = kNaN, largest = kNaN;
  std::size_t honest_count = 0;
  double plain = kNaN;   ///< standard deviation of error over sigma
  double robust = kNaN;  ///< what 68.27 % of |error| over sigma stay below
};
Spread spreadOf(const std::vector<Sample>& samples, bool folded);

/// Welds by what is worst of them, worst first.
struct Worst
{
  std::uint64_t seed;
  double value;
};
std::vector<Worst> worstFirst(std::vector<Worst> welds, std::size_t count);

/// Error of an integral over what is allowed: max(1 %, 5 um x width x length). NaN = not measured.
double overAllowance(const WeldCase& weld, double measured, double truth);

/// Points of a label found, over points that have it or were given it. NaN = there are none.
double intersectionOverUnion(const std::array<std::array<long, 5>, 5>& labels, std::size_t label);
}  // namespace weld_accuracy
}  // namespace weld_profiler
