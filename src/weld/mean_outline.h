#pragma once

#include <vector>

#include "toe_fit.h"

namespace weld_profiler
{
namespace weld
{
/// The outline of several sections beside a toe: heights above their parent lines, averaged in cells across the weld.
class MeanOutline
{
public:
  /// From a little outside of the toe to the weld's middle.
  explicit MeanOutline(const ToeQuestion& question);

  void add(const SectionProfile& profile, const Line& parent, double weight);

  /// The mean over a parent line, where sections of more than this weight show it.
  SectionProfile above(const Line& parent, double least) const;

private:
  struct Cell
  {
    double weight = 0.0, q = 0.0, above = 0.0;
  };
  double from_ = 0.0, to_ = 0.0;
  std::vector<Cell> cells_;
};
}  // namespace weld
}  // namespace weld_profiler
