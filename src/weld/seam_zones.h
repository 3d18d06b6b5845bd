#pragma once

#include <algorithm>
#include <cstddef>
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

  std::size_t nearestSection(double s) const
  {
    const std::vector<double>& places = sections_.places();
    if (!(s > begin_) || nearest_.empty())
      return 0;
    std::size_t k = nearest_[static_cast<std::size_t>(std::min((s - begin_) * per_metre_, last_step_))];
    while (k + 1 < places.size() && !(s - places[k] < places[k + 1] - s))
      ++k;
    return k;
  }

  Zone zone(std::size_t k, double q) const
  {
    const Across& across = across_[k];
    return q < across.left ? across.before : q > across.right ? across.behind : across.between;
  }

  /// Parent lines, and the chord of the toes between them; NaN where nothing is known [m].
  double flush(std::size_t k, double q) const { return flush(k, q, zone(k, q)); }
  double flush(std::size_t k, double q, Zone zone) const
  {
    const Across& across = across_[k];
    switch (zone)
    {
      case Zone::LeftParent:
        return across.left_parent.at(q);
      case Zone::RightParent:
        return across.right_parent.at(q);
      case Zone::Weld:
        return across.chord.at(q);
      case Zone::Nowhere:
        break;
    }
    return kNaN;
  }

  /// Toes that a section is mapped between [m].
  double leftToe(std::size_t k) const { return across_[k].left; }
  double rightToe(std::size_t k) const { return across_[k].right; }

  /// The nearer parent, continued below the weld; NaN where it is not known [m].
  double plate(std::size_t k, double q) const
  {
    const Across& across = across_[k];
    return 2.0 * q < across.left + across.right ? across.left_parent.at(q) : across.right_parent.at(q);
  }

  /// Through the parent lines at the toes that a section is mapped between; not valid where one is not known.
  const Line& chord(std::size_t k) const { return across_[k].chord; }

  /// What more is let pass at s: nothing between the first section and the last [m].
  double slack(double s) const;

private:
  /// A section's parts from left to right: every point of a scan asks for them.
  struct Across
  {
    double left = kNaN, right = kNaN;
    Zone before = Zone::Nowhere, between = Zone::Nowhere, behind = Zone::Nowhere;
    Line left_parent, chord, right_parent;
  };
  static Across acrossOf(const SeamSections& sections, std::size_t k);

  const SeamSections& sections_;
  std::vector<Across> across_;
  double begin_ = 0.0;
  double per_metre_ = 1.0;  ///< steps
  double last_step_ = 0.0;
  std::vector<std::size_t> nearest_;  ///< of each equal step along the weld, the section nearest to where it begins
};

}  // namespace weld
}  // namespace weld_profiler
