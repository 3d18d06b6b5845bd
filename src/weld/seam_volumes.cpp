#include "seam_volumes.h"

#include <algorithm>
#include <cmath>

#include "seam_maps.h"
#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kErrAlike = 5e-3;     // sections nearer than this share their parents' error [m]
constexpr double kBridge = 2.5;        // median steps between two sections that an integral goes on over ...
constexpr double kLargestSpot = 4e-3;  // ... and over such a spot, where the bead's width is told in between [m]

/// Area of a section above the target [m^2].
double areaAboveTarget(const SectionProfile& profile, const SectionShape& shape, const WeldParams& params)
{
  const Line chord = shape.chord();
  const double rest = restAbove(chord, params);
  double area = 0.0, last_q = shape.toe_left.q, last_above = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    const double q = profile.q[i];
    if (q <= last_q || q >= shape.toe_right.q)
      continue;
    const double above = std::max(0.0, profile.z[i] - chord.at(q) - rest);
    area += 0.5 * (above + last_above) * (q - last_q);
    last_q = q, last_above = above;
  }
  return area + 0.5 * last_above * (shape.toe_right.q - last_q);
}

/// What the sections' areas make along the weld, by trapezoids. Told areas are joined where they lie near each other,
/// or where all sections in between show the bead; nothing is added for other breaks.
class AlongIntegral
{
public:
  AlongIntegral(const SeamSections& sections, const WeldParams& params, const WeldResult& result)
    : places_(sections.places())
  {
    std::vector<double> areas;
    step_ = usualStep(result.sections);
    near_ = std::max(kBridge * step_, params.max_bridge);
    for (std::size_t k = 0; k < places_.size(); ++k)
    {
      const WeldSection& section = result.sections[k];
      has_bead_.push_back(section.hasBead());
      if (!section.area.measured())
        continue;
      told_.push_back(Told{ k, section.area.value, areaAboveTarget(sections.profile(k), sections.shape(k), params) });
      areas.push_back(section.area.value);
      sigmas_.push_back(section.area.sigma);
    }
    const double usual = median(areas);
    for (double& area : areas)
      area -= usual;
    scatter_ = robustSigma(std::move(areas));
  }

  void operator()(WeldResult& result) const
  {
    if (told_.empty() || !std::isfinite(step_))
      return;
    double volume = 0.0, removal = 0.0, length = 0.0, bridged = 0.0;
    const auto add = [&](double along, const Told& a, const Told& b)
    {
      volume += 0.5 * along * (a.area + b.area), removal += 0.5 * along * (a.removal + b.removal);
      length += along;
    };
    add(0.5 * step_, told_.front(), told_.front());
    for (std::size_t i = 1; i < told_.size(); ++i)
    {
      const Told &a = told_[i - 1], &b = told_[i];
      const double apart = places_[b.section] - places_[a.section];
      if (!joined(a.section, b.section))
      {
        add(0.5 * step_, a, a);
        add(0.5 * step_, b, b);
        continue;
      }
      add(apart, a, b);
      // in between it may be as much more or less as it is elsewhere along the weld
      if (apart > kBridge * step_)
        bridged += square(apart * std::max(scatter_, 0.5 * std::abs(b.area - a.area)));
    }
    add(0.5 * step_, told_.back(), told_.back());
    const double noise = median(sigmas_) * length / std::sqrt(std::max(1.0, length / kErrAlike));
    result.volume = Quantity{ volume, std::sqrt(square(noise) + bridged) };
    result.removal_volume = Quantity{ removal, result.volume.sigma };
    result.volume_length = length;
  }

private:
  struct Told
  {
    std::size_t section;
    double area, removal;
  };

  bool joined(std::size_t a, std::size_t b) const
  {
    const auto at = [&](std::size_t k) { return has_bead_.begin() + static_cast<std::ptrdiff_t>(k); };
    const bool seen = b > a + 1 && std::all_of(at(a), at(b), [](bool bead) { return bead; });
    return places_[b] - places_[a] < (seen ? near_ + kLargestSpot : near_);
  }

  const std::vector<double>& places_;
  std::vector<bool> has_bead_;
  std::vector<Told> told_;
  std::vector<double> sigmas_;
  double step_ = 0.0, near_ = 0.0, scatter_ = 0.0;
};
}  // namespace

double usualStep(const std::vector<WeldSection>& sections)
{
  std::vector<double> steps;
  for (std::size_t k = 1; k < sections.size(); ++k)
    steps.push_back(sections[k].s - sections[k - 1].s);
  return median(std::move(steps));
}

void fillVolumes(const SeamSections& sections, const WeldParams& params, WeldResult& result)
{
  AlongIntegral(sections, params, result)(result);
}
}  // namespace weld
}  // namespace weld_profiler
