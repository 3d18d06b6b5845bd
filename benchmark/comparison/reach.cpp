#include "comparison/reach.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "comparison/candidates.h"
#include "comparison/scenes.h"

namespace weld_profiler
{
namespace comparison
{
namespace
{
constexpr double kDisturbance = 6.0;  ///< [DN]: small beside the stripe, above its noise
constexpr double kCounts = 0.01;      ///< of the largest effect; less is lost in the rounding of a float
constexpr int kFarthest = 75;         ///< column from the middle that is tried

/// Place of the middle column's centre across the stripe; NaN when it has none.
double placeOf(Candidate& candidate, const test_support::StripePicture& scene, const test_support::Picture& picture)
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
test_support::Picture disturbed(const test_support::StripePicture& scene, test_support::Picture picture, int u)
{
  const double slope = scene.slope(u);
  const double reach = 3.0 * scene.sigma * std::sqrt(1.0 + slope * slope);
  for (int v = static_cast<int>(std::ceil(scene.row(u))); v <= scene.row(u) + reach; ++v)
    picture.set(u, v, picture.at(u, v) + kDisturbance);
  return picture;
}
}  // namespace

int columnsByDisturbing(const std::string& method, double sigma, double degrees)
{
  test_support::StripePicture scene = straightScene(sigma, degrees, 1);
  scene.snr = 100.0;
  CandidateSettings settings;
  settings.stripe_sigma = sigma;
  settings.repair = false;
  const std::unique_ptr<Candidate> candidate = makeCandidate(method, settings);
  const test_support::Picture picture = render(scene);
  const double place = placeOf(*candidate, scene, picture);
  std::vector<double> moved;
  for (int k = -kFarthest; k <= kFarthest; ++k)
    moved.push_back(std::abs(placeOf(*candidate, scene, disturbed(scene, picture, scene.width / 2 + k)) - place));
  const double largest = *std::max_element(moved.begin(), moved.end());
  int reach = 0;
  for (int k = -kFarthest; k <= kFarthest; ++k)
    if (moved[static_cast<std::size_t>(k + kFarthest)] > kCounts * largest)
      reach = std::max(reach, std::abs(k));
  return 2 * reach + 1;
}
}  // namespace comparison
}  // namespace weld_profiler
