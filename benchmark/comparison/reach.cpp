#include "comparison/reach.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "comparison/candidates.h"
#include "comparison/scenes.h"

namespace weld_profiler
{
namespace comparison
{
namespace
{
using test_support::Picture;
using test_support::StripePicture;

constexpr double kDisturbance = 6.0;  ///< [DN]: small beside the stripe, above its noise
constexpr double kCounts = 0.01;      ///< of the largest effect; less is lost in the rounding of a float
constexpr int kQuiet = 12;            ///< columns without effect, after which no further one is tried
constexpr int kFarthest = 120;        ///< column from the middle that is tried
constexpr int kPlaces = 5;            ///< stripes whose median is taken: in one, a weight may be 0 by accident

/// Place of the middle column's centre across the stripe; NaN when it has none.
double placeOf(Candidate& candidate, const StripePicture& scene, const Picture& picture)
{
  Stripe stripe;
  candidate.reset();
  candidate.process(picture.raw(), stripe);
  for (std::size_t i = 0; i < stripe.size(); ++i)
    if (stripe.cell[i] == scene.width / 2)
      return distanceAcross(scene, stripe.u[i], stripe.v[i]);
  return std::nan("");
}

/// Lifts the light below the line in one column, which draws a centre down.
Picture disturbed(const StripePicture& scene, Picture picture, int u)
{
  const double slope = scene.slope(u);
  const double reach = 3.0 * scene.sigma * std::sqrt(1.0 + slope * slope);
  for (int v = static_cast<int>(std::ceil(scene.row(u))); v <= scene.row(u) + reach; ++v)
    picture.set(u, v, picture.at(u, v) + kDisturbance);
  return picture;
}

int reachOn(Candidate& candidate, const StripePicture& scene)
{
  const Picture picture = render(scene);
  const int middle = scene.width / 2;
  const double place = placeOf(candidate, scene, picture);
  const auto effect = [&](int k)
  { return std::abs(placeOf(candidate, scene, disturbed(scene, picture, middle + k)) - place); };
  std::vector<double> effects{ effect(0) };
  double largest = effects.front();
  for (int k = 1, reach = 0; k <= kFarthest && k <= reach + kQuiet; ++k)
  {
    effects.push_back(std::max(effect(k), effect(-k)));
    largest = std::max(largest, effects.back());
    if (effects.back() > kCounts * largest)
      reach = k;
  }
  std::size_t reach = effects.size() - 1;
  while (reach > 0 && !(effects[reach] > kCounts * largest))
    --reach;
  return static_cast<int>(reach);
}
}  // namespace

int columnsUsed(const std::string& method, double sigma, double degrees)
{
  static const std::set<std::string> column_methods = { "gray_centroid", "squared_centroid", "gauss_fit", "fir_peak",
                                                        "log_parabola" };
  static std::map<std::string, int> known;
  if (column_methods.count(method) > 0)
    return 1;
  const std::string key = method + "/" + std::to_string(sigma) + "/" + std::to_string(degrees);
  const auto found = known.find(key);
  return found != known.end() ? found->second : known[key] = columnsByDisturbing(method, sigma, degrees);
}

int columnsByDisturbing(const std::string& method, double sigma, double degrees)
{
  CandidateSettings settings;
  settings.stripe_sigma = sigma;
  settings.repair = false;
  const std::unique_ptr<Candidate> candidate = makeCandidate(method, settings);
  std::vector<int> reaches;
  for (unsigned seed = 1; seed <= kPlaces; ++seed)
  {
    StripePicture scene = straightScene(sigma, degrees, 2 * seed);
    scene.width = 300;
    scene.snr = 100.0;
    reaches.push_back(reachOn(*candidate, scene));
  }
  std::nth_element(reaches.begin(), reaches.begin() + kPlaces / 2, reaches.end());
  return 2 * reaches[kPlaces / 2] + 1;
}
}  // namespace comparison
}  // namespace weld_profiler
