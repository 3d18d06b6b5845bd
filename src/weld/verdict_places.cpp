#include "verdict_places.h"

#include <algorithm>
#include <cmath>

#include "verdict_level.h"

namespace weld_profiler
{
namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr double kLeastSigmas = 2.0;
constexpr double kOneSided = 0.02275;   // of a normal distribution beyond 2 sigma
constexpr double kFarthestSigma = 8.0;  // beyond any number of places

Quantity middle(const Quantity& a, const Quantity& b)
{
  return { 0.5 * (a.value + b.value), 0.5 * (a.sigma + b.sigma) };
}

/// The median of places that are in any order.
Place medianOf(std::vector<const Place*> places, const Place& at)
{
  std::sort(places.begin(), places.end(),
            [](const Place* a, const Place* b) { return a->margin.value < b->margin.value; });
  const Place& low = *places[(places.size() - 1) / 2];
  const Place& high = *places[places.size() / 2];
  Place median = at;
  median.value = middle(low.value, high.value);
  median.limit = middle(low.limit, high.limit);
  median.margin = middle(low.margin, high.margin);
  median.count = static_cast<int>(places.size());
  return median;
}

/// Where the upper tail of a normal distribution holds this share.
double upperQuantile(double share)
{
  double low = 0.0;
  double high = kFarthestSigma;
  for (int i = 0; i < 60; ++i)
  {
    const double mid = 0.5 * (low + high);
    (0.5 * std::erfc(mid / std::sqrt(2.0)) > share ? low : high) = mid;
  }
  return low;
}

const Place* smallestMargin(const Place* best, const Place& candidate)
{
  return best == nullptr || candidate.margin.value < best->margin.value ? &candidate : best;
}
}  // namespace

std::vector<Place> runningMedians(const std::vector<Place>& places, double window)
{
  constexpr double kRounding = 1e-9;  // sections at the window's very end belong to it [m]
  std::vector<Place> medians;
  std::vector<const Place*> inside;
  std::size_t first = 0;
  std::size_t last = 0;
  for (const Place& place : places)
  {
    while (places[first].s < place.s - 0.5 * window - kRounding)
      ++first;
    while (last < places.size() && places[last].s <= place.s + 0.5 * window + kRounding)
      ++last;
    inside.clear();
    for (std::size_t i = first; i < last; ++i)
      inside.push_back(&places[i]);
    medians.push_back(medianOf(inside, place));
  }
  return medians;
}

std::vector<double> failSigmas(const std::vector<Place>& medians)
{
  double independent = 0.0;
  for (const Place& place : medians)
    independent += 1.0 / place.count;
  const double largest = upperQuantile(kOneSided / std::max(1.0, independent));
  std::vector<double> sigmas;
  for (const Place& place : medians)
  {
    const double median_noise = std::min(1.0, std::sqrt(kPi / (2.0 * place.count)));  // of independent sections
    sigmas.push_back(std::max(kLeastSigmas, median_noise * largest));
  }
  return sigmas;
}

SizeDecision decideSize(const std::vector<Place>& singles, const std::vector<Place>& medians)
{
  if (medians.empty())
    return {};
  const std::vector<double> sigmas = failSigmas(medians);
  const Place* failed = nullptr;
  const Place* near = nullptr;
  const Place* any = nullptr;
  for (std::size_t i = 0; i < medians.size(); ++i)
  {
    const Decision decision = decide(medians[i].margin, sigmas[i]);
    any = smallestMargin(any, medians[i]);
    if (decision == Decision::Fail)
      failed = smallestMargin(failed, medians[i]);
    else if (decision != Decision::Pass)
      near = smallestMargin(near, medians[i]);
  }
  if (failed != nullptr)
    return { Decision::Fail, *failed };
  if (near != nullptr)
    return { Decision::Undecided, *near };
  for (const Place& single : singles)
  {
    if (decide({ single.margin.value, 0.0 }) == Decision::Fail)
      near = smallestMargin(near, single);
  }
  return near != nullptr ? SizeDecision{ Decision::Undecided, *near } : SizeDecision{ Decision::Pass, *any };
}
}  // namespace weld_profiler
