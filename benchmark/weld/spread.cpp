#include "weld/spread.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace weld_profiler
{
namespace weld_accuracy
{
const std::array<const char*, kSizes> kSizeNames = {
  "width",          "reinforcement",   "height_left",    "height_right",    "undercut_left",
  "undercut_right", "misalignment",    "toe_angle_left", "toe_angle_right", "angle",
  "area",           "incomplete_fill", "leg_left",       "leg_right",       "throat",
};

namespace
{
constexpr double kMm = 1e3;
constexpr double kDegrees = 180.0 / 3.141592653589793;
constexpr double kAwayFromFold = 3.0;  // sigmas
constexpr double kOneSigma = 0.6827;
}  // namespace

const std::vector<Group>& groups()
{
  static const std::vector<Group> all = {
    { "width", { Width }, kMm, "mm", false },
    { "reinforcement", { Reinforcement }, kMm, "mm", true },
    { "undercut", { UndercutLeft, UndercutRight }, kMm, "mm", true },
    { "misalignment", { Misalignment }, kMm, "mm", true },
    { "toe angle", { ToeAngleLeft, ToeAngleRight }, kDegrees, "deg", false },
    { "height over plates", { HeightLeft, HeightRight }, kMm, "mm", true },
    { "angle of plates", { Angle }, kDegrees, "deg", false },
    { "area", { Area }, kMm * kMm, "mm2", false },
    { "incomplete fill", { IncompleteFill }, kMm, "mm", true },
    { "leg", { LegLeft, LegRight }, kMm, "mm", false },
    { "throat", { Throat }, kMm, "mm", false },
  };
  return all;
}

const Group& group(const std::string& name)
{
  for (const Group& candidate : groups())
  {
    if (candidate.name == name)
      return candidate;
  }
  throw std::logic_error("no group of sizes is called " + name);
}

bool counts(const WeldCase& /*weld*/, const SectionCase& section)
{
  return section.stature != Stature::Low;
}

std::vector<Sample> samplesOf(const std::vector<WeldCase>& welds, const Group& group, const Chosen& chosen)
{
  std::vector<Sample> samples;
  for (const WeldCase& weld : welds)
  {
    for (const SectionCase& section : weld.sections)
    {
      if (!section.hasBead() || !chosen(weld, section))
        continue;
      for (const Size which : group.sizes)
      {
        const Deviation& size = section.sizes[which];
        if (std::isfinite(size.truth))
          samples.push_back(
              { weld.seed, { size.value * group.scale, size.sigma * group.scale, size.truth * group.scale } });
      }
    }
  }
  return samples;
}

double quantile(std::vector<double> values, double share)
{
  if (values.empty())
    return kNaN;
  const auto at = std::lround(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

Spread spreadOf(const std::vector<Sample>& samples, bool folded)
{
  Spread spread;
  std::vector<double> errors, sizes, ratios;
  double sum = 0.0, squares = 0.0;
  for (const Sample& sample : samples)
  {
    if (!sample.size.known())
      continue;
    const double error = sample.size.error();
    errors.push_back(error);
    sizes.push_back(std::abs(error));
    if (!(sample.size.sigma > 0.0) || (folded && sample.size.truth < kAwayFromFold * sample.size.sigma))
      continue;
    const double ratio = error / sample.size.sigma;
    ratios.push_back(std::abs(ratio));
    sum += ratio, squares += ratio * ratio;
  }
  spread.count = errors.size();
  spread.known = samples.empty() ? kNaN : static_cast<double>(errors.size()) / static_cast<double>(samples.size());
  spread.median = quantile(errors, 0.5);
  spread.within95 = quantile(sizes, 0.95);
  spread.largest = quantile(sizes, 1.0);
  const auto n = static_cast<double>(ratios.size());
  spread.honest_count = ratios.size();
  spread.plain = ratios.size() > 1 ? std::sqrt(std::max(0.0, squares / n - sum / n * sum / n)) : kNaN;
  spread.robust = quantile(ratios, kOneSigma);
  return spread;
}

std::vector<Worst> worstFirst(std::vector<Worst> welds, std::size_t count)
{
  welds.erase(std::remove_if(welds.begin(), welds.end(), [](const Worst& weld) { return !(weld.value == weld.value); }),
              welds.end());
  std::stable_sort(welds.begin(), welds.end(), [](const Worst& a, const Worst& b) { return a.value > b.value; });
  welds.resize(std::min(count, welds.size()));
  return welds;
}

double overAllowance(const WeldCase& weld, double measured, double truth)
{
  const double allowed = std::max(0.01 * std::abs(truth), 5e-6 * weld.width * weld.volumes.length);
  return std::abs(measured - truth) / allowed;
}

double intersectionOverUnion(const std::array<std::array<long, 5>, 5>& labels, std::size_t label)
{
  long either = -labels[label][label];
  for (std::size_t i = 0; i < labels.size(); ++i)
    either += labels[label][i] + labels[i][label];
  return either > 0 ? static_cast<double>(labels[label][label]) / static_cast<double>(either) : kNaN;
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
