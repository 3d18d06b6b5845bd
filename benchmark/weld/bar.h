#pragma once

#include <string>
#include <vector>

#include "weld/weld_case.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// One bar: what was measured must lie in [least, most].
struct Bar
{
  std::string what, unit;
  double measured = kNaN;
  double least = kNaN, most = kNaN;  ///< NaN = open on that side
  std::string detail;

  bool met() const;
  std::string limits() const;  ///< `<= 0.03`, `0.8 .. 1.3`
};

/// One line each.
void printBars(const std::vector<Bar>& bars);
}  // namespace weld_accuracy
}  // namespace weld_profiler
