#pragma once

#include <vector>

#include "seam_sections.h"

namespace weld_profiler
{
namespace weld
{
/// Where a place lies across the weld.
enum class Zone
{
  LeftParent,
  Weld,
  RightParent,
  Nowhere  ///< nothing is known there: a parent or a toe was not found
};

/// Which part of the weld lies where, and what lies flush there.
class SeamZones
{
public:
  /// @param sections  must outlive the zones.
  explicit SeamZones(const SeamSections& sections);

  std::size_t nearestSection(double s) const;
  Zone zone(std::size_t k, double q) const;

  /// Parent lines, and the chord of the toes between them; NaN where nothing is known [m].
  double flush(std::size_t k, double q) const;

  /// Through the parent lines at the toes that a section is mapped between; not valid where one is not known.
  Line chord(std::size_t k) const;

  /// What more is let pass at s: nothing between the first section and the last [m].
  double slack(double s) const;

private:
  const SeamSections& sections_;
  double begin_ = 0.0;
  double per_metre_ = 1.0;          ///< steps
  std::vector<std::size_t> first_;  ///< of each equal step along the weld, the first section not before it
};

}  // namespace weld
}  // namespace weld_profiler
