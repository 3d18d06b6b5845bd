#include "known_bead.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kTaper = 0.15;       // of a bead's usual height: where it is lower by more it may be ending
constexpr double kLeastTaper = 1e-4;  // ... and by more than this [m]
constexpr double kGone = 0.35;        // ... to less than this share of it, or on to the weld's end
constexpr double kAround = 8e-3;      // sections this near tell what is usual [m]
constexpr double kNear = 2e-3;        // so near a section must show both toes [m]
constexpr double kEnd = 2e-3;         // of a longer end the sections around show the course themselves [m]
constexpr double kSigmas = 3.0;       // of what ripples make of a section's height
constexpr double kLeast = 6e-5;       // ... and no less [m]

struct Around
{
  double usual = 0.0;  ///< median height
  bool whole = false;  ///< a section that shows both toes is near
};

Around lookAround(const SeamSections& sections, const std::vector<double>& levels, std::size_t k)
{
  const std::vector<double>& places = sections.places();
  std::vector<double> heights;
  bool whole = false;
  for (std::size_t j = 0; j < sections.size(); ++j)
  {
    const double apart = std::abs(places[j] - places[k]);
    if (sections.shape(j).whole() && apart < kAround)
      heights.push_back(levels[j]);
    whole = whole || (sections.shape(j).whole() && apart < kNear);
  }
  return Around{ median(std::move(heights)), whole };
}

/// What is not known ends the bead; so does what is lower beside it.
std::vector<std::uint8_t> endingBead(const SeamSections& sections, const std::vector<std::uint8_t>& known,
                                     const std::vector<double>& departures)
{
  const std::vector<double>& places = sections.places();
  const std::size_t count = known.size();
  std::vector<double> of_known;
  for (std::size_t k = 0; k < count; ++k)
    of_known.push_back(known[k] != 0 ? departures[k] : kNaN);
  const double sigma = robustSigma(std::move(of_known));
  const double low = -std::max(kLeast, std::isfinite(sigma) ? kSigmas * sigma : 0.0);
  std::vector<std::uint8_t> ending(count, 0);
  const auto walk = [&](std::size_t from, int step)
  {
    for (std::size_t k = from; k < count; k += static_cast<std::size_t>(step))
    {
      if (std::abs(places[k] - places[from]) > kEnd || (known[k] != 0 && !(departures[k] < low)))
        break;
      ending[k] = 1;
    }
  };
  for (std::size_t k = 0; k < count; ++k)
  {
    if (known[k] == 0)
      walk(k, 1), walk(k, -1);
  }
  return ending;
}
}  // namespace

BeadCourse beadCourse(const SeamSections& sections, const std::vector<double>& levels)
{
  const std::size_t count = sections.size();
  std::vector<std::uint8_t> known(count, 0);
  std::vector<double> shares(count, 0.0), departures;  // of the usual height, and from it
  for (std::size_t k = 0; k < count; ++k)
  {
    const Around around = lookAround(sections, levels, k);
    const double least = around.usual - std::max(kTaper * std::abs(around.usual), kLeastTaper);
    known[k] = around.whole && levels[k] > least ? 1 : 0;
    departures.push_back(levels[k] - around.usual);
    shares[k] = around.whole && std::isfinite(levels[k]) ? levels[k] / std::abs(around.usual) : 0.0;
  }
  for (std::size_t first = 0, end = 0; first < count; first = std::max(end, first + 1))
  {
    for (end = first; end < count && known[end] == 0;)
      ++end;
    const bool between = first > 0 && end > first && end < count;
    const auto at = [](auto& of, std::size_t i) { return of.begin() + static_cast<std::ptrdiff_t>(i); };
    if (!between)
      continue;
    const double lowest = *std::min_element(at(shares, first), at(shares, end));
    if (lowest > kGone)
      std::fill(at(known, first), at(known, end), static_cast<std::uint8_t>(1));
  }
  return BeadCourse{ known, endingBead(sections, known, departures) };
}
}  // namespace weld
}  // namespace weld_profiler
