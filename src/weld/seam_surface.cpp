#include "seam_surface.h"

#include <algorithm>
#include <cmath>

#include "column_medians.h"
#include "hollows.h"
#include "statistics.h"
#include "toe_sway.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kBin = 1e-4;              // [m]
constexpr int kOutside = 30;               // bins outside of each toe
constexpr double kReach = 2e-3;            // sections this near make the median [m]
constexpr std::size_t kMost = 15;          // of them at most so many, evenly chosen
constexpr double kSigmas = 6.0;            // of a parent's noise
constexpr double kRippleSigmas = 3.0;      // of the face's departures: a sine has none beyond 1, told by its median
constexpr double kLeastFace = 6e-5;        // ripples and blurred kinks depart by less [m]
constexpr double kLeastParent = 3e-5;      // [m]
constexpr double kAlong = 6e-4;            // by which a sloping surface may be met elsewhere along the weld [m]
constexpr std::size_t kAlongSections = 3;  // its slope is taken from section to section so many off
constexpr double kLevel = 0.1;             // ripples make slopes up to this
constexpr double kBeyond = 3e-4;           // of the last section, that is still told from it [m]
static_assert(kMost <= kMostMedianRows, "more rows than medians are told of");
}  // namespace

SeamSurface::SeamSurface(const SeamSections& sections) : sections_(sections), zones_(sections)
{
  std::vector<float> rises = prepare();
  for (std::size_t k = 0; k < sections.size(); ++k)
    sampleSection(k, sections.profile(k), rises);
  findKnown(rises);
  std::vector<float> clean = rises;
  takeOut(clean);
  if (hollow_.empty())
    fillMedians(rises, kReach);
  else
    fillWithout(clean, rises);
}

SeamSurface::SeamSurface(const SeamSections& sections, const SectionSampler& sampler,
                         const std::vector<std::uint8_t>& without)
  : sections_(sections), zones_(sections)
{
  std::vector<float> rises = prepare(), clean = rises;
  SectionProfile profile;
  for (std::size_t k = 0; k < sections.size(); ++k)
  {
    sampleSection(k, sections.profile(k), rises);
    sampler.sample(sections.places()[k], without, profile);
    sampleSection(k, profile, clean);
  }
  findKnown(clean);
  takeOut(clean);
  fillWithout(clean, rises);
}

void SeamSurface::takeOut(std::vector<float>& rises)
{
  const auto columns = static_cast<std::size_t>(bins_), last = columns - 1 - static_cast<std::size_t>(kOutside);
  hollow_ = takeOutHollows(SectionStack{ sections_.places(), rises, course_.known, columns, kOutside, last, kBin });
}

/// Medians of what is clean, else of all.
void SeamSurface::fillWithout(const std::vector<float>& clean, const std::vector<float>& all)
{
  fillMedians(clean, kReach);
  // between two spots something is left further off; where nothing is there was more than a spot
  const std::vector<float> near = std::move(medians_);
  fillMedians(clean, 2.0 * kReach);
  const std::vector<float> far = std::move(medians_);
  fillMedians(all, kReach);
  for (std::size_t i = 0; i < near.size(); ++i)
    medians_[i] = std::isfinite(near[i]) ? near[i] : std::isfinite(far[i]) ? far[i] : medians_[i];
}

/// The stack's measures, and room for its heights.
std::vector<float> SeamSurface::prepare()
{
  const SeamSections& sections = sections_;
  std::vector<double> widths, scatters;
  for (std::size_t k = 0; k < sections.size(); ++k)
  {
    const SectionShape& shape = sections.shape(k);
    if (shape.whole())
      widths.push_back(shape.toe_right.q - shape.toe_left.q);
    for (const ParentFit* parent : { &shape.left, &shape.right })
      if (parent->valid())
        scatters.push_back(parent->scatter);
  }
  sway_left_ = toeSway(sections, Side::Left, kReach);
  sway_right_ = toeSway(sections, Side::Right, kReach);
  const double scatter = median(scatters), width = median(widths);
  parent_tolerance_ = std::max(kLeastParent, std::isfinite(scatter) ? kSigmas * scatter : 0.0);
  inside_ = std::isfinite(width) ? std::max(4, static_cast<int>(std::lround(width / kBin))) : 4;
  bins_ = inside_ + 1 + 2 * kOutside;
  return std::vector<float>(sections.size() * static_cast<std::size_t>(bins_), std::numeric_limits<float>::quiet_NaN());
}

/// Each section's own height, not the median's: at an end that is taken from one side.
void SeamSurface::findKnown(const std::vector<float>& sampled)
{
  std::vector<double> levels;
  for (std::size_t k = 0; k < sections_.size(); ++k)
  {
    const auto face = sampled.begin() + static_cast<std::ptrdiff_t>(k) * bins_ + kOutside;
    levels.push_back(median(std::vector<double>(face, face + inside_ + 1)));
  }
  course_ = beadCourse(sections_, levels);
}

double SeamSurface::binOf(std::size_t k, double q) const
{
  const double left = zones_.leftToe(k), right = zones_.rightToe(k);
  switch (zones_.zone(k, q))
  {
    case Zone::LeftParent:
      return kOutside - (left - q) / kBin;
    case Zone::RightParent:
    {
      const double bin = kOutside + inside_ + (q - right) / kBin;
      return bin < bins_ - 1 ? bin : -1.0;
    }
    case Zone::Weld:
      return kOutside + inside_ * (q - left) / (right - left);
    case Zone::Nowhere:
      break;
  }
  return -1.0;
}

double SeamSurface::placeOf(std::size_t k, int bin) const
{
  const double left = zones_.leftToe(k), right = zones_.rightToe(k);
  if (bin < kOutside)
    return left - (kOutside - bin) * kBin;
  if (bin > kOutside + inside_)
    return right + (bin - kOutside - inside_) * kBin;
  return left + (right - left) * (bin - kOutside) / inside_;
}

void SeamSurface::sampleSection(std::size_t k, const SectionProfile& profile, std::vector<float>& rises) const
{
  if (!std::isfinite(placeOf(k, 0) + placeOf(k, bins_ - 1)))
    return;
  std::size_t after = 0;
  for (int bin = 0; bin < bins_; ++bin)
  {
    const double q = placeOf(k, bin);
    while (after < profile.size() && profile.q[after] < q)
      ++after;
    if (after == 0 || after == profile.size() || profile.q[after] - profile.q[after - 1] > 3.0 * kBin)
      continue;
    const double share = (q - profile.q[after - 1]) / (profile.q[after] - profile.q[after - 1]);
    const double z = profile.z[after - 1] + share * (profile.z[after] - profile.z[after - 1]);
    rises[k * static_cast<std::size_t>(bins_) + static_cast<std::size_t>(bin)] =
        static_cast<float>(z - zones_.flush(k, q));
  }
}

void SeamSurface::fillMedians(const std::vector<float>& rises, double reach)
{
  const auto columns = static_cast<std::size_t>(bins_);
  const std::vector<double>& places = sections_.places();
  tolerances_.clear();
  medians_.assign(rises.size(), std::numeric_limits<float>::quiet_NaN());
  std::vector<std::vector<double>> departures(columns, std::vector<double>(places.size()));
  std::vector<const float*> near;
  std::vector<double> middles;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const auto begin =
        static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), places[k] - reach) - places.begin());
    const auto end =
        static_cast<std::size_t>(std::upper_bound(places.begin(), places.end(), places[k] + reach) - places.begin());
    const std::size_t stride = (end - begin + kMost - 1) / kMost;
    near.clear();
    for (std::size_t j = begin; j < end; j += stride)
      near.push_back(rises.data() + j * columns);
    columnMedians(near, columns, middles);
    for (std::size_t bin = 0; bin < columns; ++bin)
    {
      medians_[k * columns + bin] = static_cast<float>(middles[bin]);
      departures[bin][k] = static_cast<double>(rises[k * columns + bin]) - middles[bin];
    }
  }
  for (std::vector<double>& one : departures)
  {
    const double sigma = robustSigmaInPlace(one);
    tolerances_.push_back(static_cast<float>(std::max(kLeastFace, std::isfinite(sigma) ? kRippleSigmas * sigma : 0.0)));
  }
}

double SeamSurface::rise(std::size_t k, double bin) const
{
  const auto below = static_cast<std::size_t>(bin);
  const std::size_t at = k * static_cast<std::size_t>(bins_) + below;
  const double share = bin - static_cast<double>(below);
  const double first = static_cast<double>(medians_[at]);
  return share > 0.0 ? first + share * (static_cast<double>(medians_[at + 1]) - first) : first;
}

double SeamSurface::departure(std::size_t k, double q, double z) const
{
  const double bin = binOf(k, q);
  return z - zones_.flush(k, q) - (bin >= 0.0 ? rise(k, bin) : 0.0);
}

/// Whether the bead's edge may lie here or not.
bool SeamSurface::atSwayingToe(std::size_t k, double q) const
{
  return std::abs(q - zones_.leftToe(k)) < sway_left_[k] || std::abs(q - zones_.rightToe(k)) < sway_right_[k];
}

double SeamSurface::alongSlack(std::size_t k, const PathPlace& place, double bin) const
{
  // where a bead ends and its toes close in, what lies between them is not known
  const bool beside = zones_.slack(place.s) > 0.0 && std::abs(place.s - sections_.places()[k]) > kBeyond;
  if (((course_.known[k] == 0 || beside) && onFace(k, place.q)) || atSwayingToe(k, place.q))
    return INFINITY;
  const std::size_t before = k - std::min(k, kAlongSections),
                    after = std::min(k + kAlongSections, sections_.size() - 1);
  if (bin < 0.0 || before == after)
    return 0.0;
  const auto at = static_cast<std::size_t>(std::lround(bin));
  const auto median = [&](std::size_t section)
  { return static_cast<double>(medians_[section * static_cast<std::size_t>(bins_) + at]); };
  const double slope =
      std::abs(median(after) - median(before)) / (sections_.places()[after] - sections_.places()[before]);
  return std::isfinite(slope) ? kAlong * std::max(0.0, slope - kLevel) : 0.0;
}

double SeamSurface::tolerance(std::size_t k, const PathPlace& place) const
{
  const double bin = binOf(k, place.q);
  const double known =
      bin >= 0.0 ? static_cast<double>(tolerances_[static_cast<std::size_t>(std::lround(bin))]) : parent_tolerance_;
  return known + zones_.slack(place.s) + alongSlack(k, place, bin);
}
}  // namespace weld
}  // namespace weld_profiler
