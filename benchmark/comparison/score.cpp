#include "comparison/score.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weld_profiler
{
namespace comparison
{
namespace
{
constexpr double kOutlier = 1.0;  ///< [px]
const double kNone = std::numeric_limits<double>::quiet_NaN();

double share(std::size_t part, std::size_t whole)
{
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}
}  // namespace

Sample sampleOf(const test_support::StripePicture& scene, int margin)
{
  Sample sample{ scene, test_support::render(scene), {} };
  sample.expected.assign(static_cast<std::size_t>(scene.width), Expected::Centre);
  for (int u = 0; u < scene.width; ++u)
    if (u < margin || u >= scene.width - margin)
      sample.expected[static_cast<std::size_t>(u)] = Expected::Beyond;
  return sample;
}

void ErrorSums::add(double error, double sigma)
{
  ++count;
  sum += error;
  squares += error * error;
  largest = std::max(largest, std::abs(error));
  if (!(sigma > 0.0F))
    return;
  ++with_sigma;
  in_sigmas += error * error / (sigma * sigma);
}

double ErrorSums::rmse() const
{
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : kNone;
}

double ErrorSums::bias() const
{
  return count > 0 ? sum / static_cast<double>(count) : kNone;
}

double ErrorSums::spread() const
{
  return std::sqrt(std::max(0.0, rmse() * rmse() - bias() * bias()));
}

double ErrorSums::honesty() const
{
  return with_sigma > 0 ? std::sqrt(in_sigmas / static_cast<double>(with_sigma)) : kNone;
}

void Score::add(const Sample& sample, const Stripe& stripe, const Candidate& candidate)
{
  std::vector<bool> found(sample.expected.size(), false);
  std::size_t traced = 0;  // centres measured so far: what is told of each knows nothing of those a repair added
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    const bool repaired = (stripe.flags[i] & stripe_flag::kInterpolated) != 0;
    const std::size_t trace = traced;
    traced += repaired ? 0 : 1;
    const std::size_t cell = stripe.cell[i];
    found[cell] = true;
    if (sample.expected[cell] == Expected::Nothing)
      ++made_up;
    if (sample.expected[cell] == Expected::Nothing || sample.expected[cell] == Expected::Beyond)
      continue;
    filled += repaired && sample.expected[cell] == Expected::Optional ? 1 : 0;
    const double error = distanceAcross(sample.truth, stripe.u[i], stripe.v[i]);
    ++points;
    squares += error * error;
    largest = std::max(largest, std::abs(error));
    saturated += (stripe.flags[i] & stripe_flag::kSaturated) != 0 ? 1 : 0;
    ambiguous += (stripe.flags[i] & stripe_flag::kAmbiguous) != 0 ? 1 : 0;
    if (!(std::abs(error) <= kOutlier))
    {
      ++outliers;
      continue;
    }
    (repaired ? interpolated : measured).add(error, stripe.sigma[i]);
    if (!repaired)
      columns_told.push_back(candidate.columnsTold(trace));
  }
  for (std::size_t cell = 0; cell < found.size(); ++cell)
  {
    expected += sample.expected[cell] == Expected::Centre ? 1 : 0;
    missing += sample.expected[cell] == Expected::Centre && !found[cell] ? 1 : 0;
    breaks += sample.expected[cell] == Expected::Optional ? 1 : 0;
    empty += sample.expected[cell] == Expected::Nothing ? 1 : 0;
  }
}

double Score::rmse() const
{
  return points > 0 ? std::sqrt(squares / static_cast<double>(points)) : kNone;
}

double Score::outlierPercent() const
{
  return share(outliers, points);
}

double Score::missingPercent() const
{
  return share(missing, expected);
}

Score judge(Candidate& candidate, const std::vector<Sample>& samples)
{
  Score score;
  Stripe stripe;
  for (const Sample& sample : samples)
  {
    candidate.reset();
    candidate.process(sample.picture.raw(), stripe);
    score.add(sample, stripe, candidate);
  }
  return score;
}
}  // namespace comparison
}  // namespace weld_profiler
