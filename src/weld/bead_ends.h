#pragma once

#include <cstdint>
#include <vector>

#include "stray_excess.h"

namespace weld_profiler
{
namespace weld
{
/// Tells pits and balls from the end of a bead, which departs from the sections around as well.
class BeadEnds
{
public:
  /// All must outlive it.
  BeadEnds(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface, const StrayExcess& excess)
    : grid_(grid), sampler_(sampler), surface_(surface), excess_(excess)
  {
  }

  /// Whether a pit reaches to where the bead may be ending: what of it is a pore is not known.
  bool reachedBy(const std::vector<std::size_t>& pit) const;

  /// Whether none of a pit or a ball departs by `clear` tolerances more than what else lies across the weld there, or
  /// most of a pit lies where all across is low: that is the end, seen against a median of one side.
  bool make(const std::vector<std::size_t>& spot, double clear) const;

private:
  bool isEnding(std::size_t point) const;
  std::size_t stripOf(std::size_t point) const;
  void findMiddles() const;

  const ScanGrid& grid_;
  const SectionSampler& sampler_;
  const SeamSurface& surface_;
  const StrayExcess& excess_;
  /// Of strips across the weld, what the middle of the face departs by, where the bead may be ending; told when first
  /// asked for: few welds have a pit there.
  mutable std::vector<float> middles_;
};
}  // namespace weld
}  // namespace weld_profiler
