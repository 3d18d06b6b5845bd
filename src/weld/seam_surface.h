#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "known_bead.h"
#include "seam_sections.h"
#include "seam_zones.h"

namespace weld_profiler
{
namespace weld
{
/// The surface along a weld as its sections show it in the median: what single points are held against.
class SeamSurface
{
public:
  /// @param sections  must outlive the surface.
  explicit SeamSurface(const SeamSections& sections);

  /// @param without  points of the grid that are known to be no part of the surface: they do not drag its median along.
  SeamSurface(const SeamSections& sections, const SectionSampler& sampler, const std::vector<std::uint8_t>& without);

  std::size_t size() const { return sections_.size(); }
  double placeOf(std::size_t k) const { return sections_.places()[k]; }
  std::size_t nearestSection(double s) const { return zones_.nearestSection(s); }
  bool onFace(std::size_t k, double q) const { return zones_.zone(k, q) == Zone::Weld; }
  /// How a point between the toes lies to the nearer plate: 1 above it, 0 on it, -1 below.
  int overPlate(std::size_t k, double q, double z) const
  {
    const double rise = z - zones_.plate(k, q);
    return rise > parent_tolerance_ ? 1 : rise < -parent_tolerance_ ? -1 : 0;
  }
  /// From a place on the face to the nearer toe [m].
  double toToe(std::size_t k, double q) const { return std::min(q - zones_.leftToe(k), zones_.rightToe(k) - q); }
  double yaw(std::size_t k) const { return sections_.profile(k).place.yaw; }

  /// How far z lies above the median of the neighbouring sections at this place; NaN where nothing is known [m].
  double departure(std::size_t k, double q, double z) const;

  /// Whether a place lies in a hollow of the face that is too wide to be told from the sections near it alone.
  bool inHollow(std::size_t k, double q) const
  {
    const double bin = hollow_.empty() ? -1.0 : binOf(k, q);
    return bin >= 0.0 && hollow_[k * static_cast<std::size_t>(bins_) + static_cast<std::size_t>(std::lround(bin))] != 0;
  }

  /// What more is let pass where the surface rises or falls along the weld, as at its ends; anything
  /// where the bead is not known [m].
  double alongSlack(std::size_t k, const PathPlace& place) const { return alongSlack(k, place, binOf(k, place.q)); }

  /// Departures beyond this are no part of the surface; more is let pass where no section lies [m].
  double tolerance(std::size_t k, const PathPlace& place) const;

  /// Whether what lies lower at a place near section k may be the bead that ends. Between a section and one where it
  /// is ending nothing tells where that begins.
  bool isEnding(std::size_t k, double s) const
  {
    constexpr double kAtSection = 1e-5;  // rows' points lie this near to their section [m]
    const double beyond = s - placeOf(k);
    const std::size_t next = beyond > 0.0 ? std::min(k + 1, size() - 1) : k - std::min<std::size_t>(k, 1);
    return course_.ending[k] != 0 || (std::abs(beyond) > kAtSection && course_.ending[next] != 0);
  }

private:
  /// Position in the stack of bins: whole numbers are bins' middles; negative = beyond the stack.
  double binOf(std::size_t k, double q) const;
  double placeOf(std::size_t k, int bin) const;
  double alongSlack(std::size_t k, const PathPlace& place, double bin) const;
  double rise(std::size_t k, double bin) const;
  bool atSwayingToe(std::size_t k, double q) const;
  std::vector<float> prepare();
  void sampleSection(std::size_t k, const SectionProfile& profile, std::vector<float>& rises) const;
  void fillMedians(const std::vector<float>& rises, double reach);
  void takeOut(std::vector<float>& rises);
  void fillWithout(const std::vector<float>& clean, const std::vector<float>& all);
  void findKnown(const std::vector<float>& sampled);

  const SeamSections& sections_;
  SeamZones zones_;
  int inside_ = 1;                    ///< bins between the toes
  int bins_ = 0;                      ///< bins in all
  std::vector<float> medians_;        ///< sections x bins, above flush
  std::vector<float> tolerances_;     ///< one a bin
  std::vector<std::uint8_t> hollow_;  ///< sections x bins, whether it is; empty = none is
  double parent_tolerance_ = 0.0;
  std::vector<double> sway_left_, sway_right_;  ///< of each section's toes [m]
  BeadCourse course_;
};
}  // namespace weld
}  // namespace weld_profiler
