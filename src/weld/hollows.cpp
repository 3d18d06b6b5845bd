#include "hollows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kReach = 5e-3;   // the face before a hollow and behind it is seen over so much [m]
constexpr std::size_t kMost = 7;  // sections on either side tell it, evenly chosen
constexpr std::size_t kFewest = 5;
constexpr double kWhole = 0.75;       // of a section's departures lie below what all of it does
constexpr double kSigmas = 3.0;       // of what the bin departs by
constexpr double kWaves = 1.5;        // of what it departs by along the weld: a wave's trough has none beyond 1
constexpr double kShallowest = 6e-5;  // ripples and blurred kinks depart by less [m]
constexpr double kWidest = 4e-3;      // what is wider is a change of the bead [m]
constexpr double kLeastArea = 8e-7;   // of a disc of 1 mm; the median looks past less [m^2]

class HollowFinder
{
public:
  explicit HollowFinder(const SectionStack& stack)
    : stack_(stack), face_(stack.last + 1 - stack.first), along_(stack.places.size() * face_, kNaN), departures_(along_)
  {
    step_ = (stack.places.back() - stack.places.front()) / static_cast<double>(stack.places.size() - 1);
    stride_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(kReach / (kMost * step_))));
  }

  std::vector<std::uint8_t> operator()()
  {
    for (std::size_t k = 0; k < stack_.places.size(); ++k)
      compare(k);
    low_.assign(departures_.size(), 0);
    for (std::size_t column = 0; column < face_; ++column)
      markLow(column);
    std::vector<std::uint8_t> hollow;
    for (std::size_t i = 0; i < low_.size(); ++i)
    {
      if (low_[i] != 0)
        takeOut(connected(i), hollow);
    }
    return hollow;
  }

private:
  static constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

  float height(std::size_t k, std::size_t column) const
  {
    return stack_.known[k] == 0 ? kNaN : stack_.heights[k * stack_.columns + stack_.first + column];
  }

  /// Median of the sections on one side of the k-th; infinite where too few of them are seen.
  float beside(std::size_t k, std::size_t column, bool before) const
  {
    std::array<float, kMost> seen;
    std::size_t count = 0;
    for (std::size_t n = 1; n <= kMost; ++n)
    {
      const std::size_t apart = n * stride_;
      if (before ? k < apart : k + apart >= stack_.places.size())
        break;
      const float at = height(before ? k - apart : k + apart, column);
      if (!std::isfinite(at))
        continue;
      std::size_t place = count++;
      for (; place > 0 && seen[place - 1] > at; --place)
        seen[place] = seen[place - 1];
      seen[place] = at;
    }
    return count < kFewest ? std::numeric_limits<float>::infinity() : seen[count / 2];
  }

  /// How a section departs from what lies lower, before it or behind, less what all of it does, or most: of the rest
  /// may lie in a hollow.
  void compare(std::size_t k)
  {
    float* const along = along_.data() + k * face_;
    std::vector<float> known;
    for (std::size_t column = 0; column < face_; ++column)
    {
      const float usual = std::min(beside(k, column, true), beside(k, column, false));
      along[column] = std::isfinite(usual) ? height(k, column) - usual : kNaN;
      if (std::isfinite(along[column]))
        known.push_back(along[column]);
    }
    if (known.empty())
      return;
    const auto whole = known.begin() + static_cast<std::ptrdiff_t>(kWhole * static_cast<double>(known.size()));
    std::nth_element(known.begin(), whole, known.end());
    for (std::size_t column = 0; column < face_; ++column)
      departures_[k * face_ + column] = along[column] - *whole;
  }

  /// What a bin departs by, in robust standard deviations about zero.
  static double scatter(const std::vector<float>& departures, std::size_t column, std::size_t face)
  {
    std::vector<double> of_bin;
    for (std::size_t i = column; i < departures.size(); i += face)
      of_bin.push_back(static_cast<double>(departures[i]));
    const double sigma = robustSigma(std::move(of_bin));
    return std::isfinite(sigma) ? sigma : 0.0;
  }

  void markLow(std::size_t column)
  {
    const double along = -kWaves * scatter(along_, column, face_);
    const double least = -std::max(kShallowest, kSigmas * scatter(departures_, column, face_));
    for (std::size_t i = column; i < low_.size(); i += face_)
      low_[i] = static_cast<double>(departures_[i]) < least && static_cast<double>(along_[i]) < along ? 1 : 0;
  }

  /// Low places that hang together; they are no longer marked.
  std::vector<std::size_t> connected(std::size_t start)
  {
    std::vector<std::size_t> places{ start };
    low_[start] = 0;
    for (std::size_t next = 0; next < places.size(); ++next)
    {
      const std::size_t k = places[next] / face_, column = places[next] % face_;
      const auto join = [&](bool inside, std::size_t i)
      {
        if (!inside || low_[i] == 0)
          return;
        low_[i] = 0;
        places.push_back(i);
      };
      join(k > 0, places[next] - face_);
      join(k + 1 < stack_.places.size(), places[next] + face_);
      join(column > 0, places[next] - 1);
      join(column + 1 < face_, places[next] + 1);
    }
    return places;
  }

  void takeOut(const std::vector<std::size_t>& places, std::vector<std::uint8_t>& hollow) const
  {
    std::size_t left = face_, right = 0;
    for (const std::size_t i : places)
      left = std::min(left, i % face_), right = std::max(right, i % face_);
    const auto [first, last] = std::minmax_element(places.begin(), places.end());
    const double length = stack_.places[*last / face_] - stack_.places[*first / face_];
    const double width = static_cast<double>(right - left) * stack_.bin;
    const bool ends = *first / face_ == 0 || *last / face_ + 1 == stack_.places.size();
    if (ends || std::max(length, width) > kWidest ||
        static_cast<double>(places.size()) * step_ * stack_.bin < kLeastArea)
      return;
    hollow.resize(stack_.heights.size(), 0);
    for (const std::size_t i : places)
    {
      const std::size_t at = i / face_ * stack_.columns + stack_.first + i % face_;
      hollow[at] = 1;
      stack_.heights[at] = kNaN;
    }
  }

  const SectionStack& stack_;
  std::size_t face_;               ///< bins
  std::vector<float> along_;       ///< departures along the weld, sections x face [m]
  std::vector<float> departures_;  ///< less those of the whole section
  std::vector<std::uint8_t> low_;  ///< likewise
  double step_ = 0.0;              ///< between sections [m]
  std::size_t stride_ = 1;
};
}  // namespace

std::vector<std::uint8_t> takeOutHollows(const SectionStack& stack)
{
  if (stack.places.size() <= 2 * kFewest)
    return {};
  return HollowFinder(stack)();
}
}  // namespace weld
}  // namespace weld_profiler
