#include "toe_unrest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kApart = 5e-4;       // toes are compared at this distance: it shows ripples from 0.6 to 4 mm [m]
constexpr double kAside = 4e-4;       // a section this far from a place still stands for it [m]
constexpr double kBetween = 1.25e-3;  // a ripple's length: so near to others on both sides that show the toe [m]
constexpr double kRound = 1e-5;       // rounding of places [m]
}  // namespace

std::vector<double> toeUnrest(const std::vector<double>& places, const std::vector<double>& toes)
{
  /// The toe of the first section from a place on, if it is near; NaN where none is known.
  const auto near = [&](double s)
  {
    const auto k =
        static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), s - kRound) - places.begin());
    return k < places.size() && places[k] - s < kAside ? toes[k] : std::numeric_limits<double>::quiet_NaN();
  };
  std::vector<double> unrest;
  unrest.reserve(places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const double middle = 0.5 * (near(places[k] - kApart) + near(places[k] + kApart));
    unrest.push_back((toes[k] - middle) * std::sqrt(2.0 / 3.0));
  }
  return unrest;
}

std::vector<char> sectionsWithToe(const std::vector<double>& places, const std::vector<double>& toes, bool begins,
                                  bool ends)
{
  const std::size_t count = places.size();
  std::vector<double> since(count);
  double last = begins || places.empty() ? -INFINITY : places.front();
  for (std::size_t k = 0; k < count; ++k)
  {
    last = std::isfinite(toes[k]) ? places[k] : last;
    since[k] = places[k] - last;
  }
  std::vector<char> chosen(count);
  last = ends || places.empty() ? INFINITY : places.back();
  for (std::size_t k = count; k-- > 0;)
  {
    last = std::isfinite(toes[k]) ? places[k] : last;
    chosen[k] = std::max(since[k], last - places[k]) < kBetween ? 1 : 0;
  }
  return chosen;
}
}  // namespace weld
}  // namespace weld_profiler
