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

  /// What more is let pass at s: nothing between the first section and the last [m].
  double slack(double s) const;

private:
  const SeamSections& sections_;
  double begin_ = 0.0;
  double per_metre_ = 1.0;          ///< steps
  std::vector<std::size_t> first_;  ///< of each equal step along the weld, the first section not before it
};

/// The surface along a weld as its sections show it in the median: what single points are held against.
class SeamSurface
{
public:
  /// @param sections  must outlive the surface.
  explicit SeamSurface(const SeamSections& sections);

  std::size_t nearestSection(double s) const { return zones_.nearestSection(s); }
  bool onFace(std::size_t k, double q) const { return zones_.zone(k, q) == Zone::Weld; }
  double yaw(std::size_t k) const { return sections_.profile(k).place.yaw; }

  /// How far z lies above the median of the neighbouring sections at this place; NaN where nothing is known [m].
  double departure(std::size_t k, double q, double z) const;

  /// Departures beyond this are no part of the surface; more is let pass where no section lies [m].
  double tolerance(std::size_t k, const PathPlace& place) const;

private:
  /// Position in the stack of bins: whole numbers are bins' middles; negative = beyond the stack.
  double binOf(std::size_t k, double q) const;
  double placeOf(std::size_t k, int bin) const;
  double rise(std::size_t k, double bin) const;
  void sampleSection(std::size_t k, std::vector<float>& rises) const;
  void fillMedians(const std::vector<float>& rises);

  const SeamSections& sections_;
  SeamZones zones_;
  int inside_ = 1;                 ///< bins between the toes
  int bins_ = 0;                   ///< bins in all
  std::vector<float> medians_;     ///< sections x bins, above flush
  std::vector<float> tolerances_;  ///< one a bin
  double parent_tolerance_ = 0.0;
};
}  // namespace weld
}  // namespace weld_profiler
