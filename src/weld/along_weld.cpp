#include "along_weld.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr std::array<double, 4> kWindows{ { 0.6e-3, 1.2e-3, 2.5e-3, 5e-3 } };  // half widths [m]
constexpr std::size_t kFewest = 5;                                             // measured sections in a window
constexpr double kDoubt = 2.0;     // scatter is real change beyond this multiple of what noise makes
constexpr double kStretch = 1e-3;  // half length of the stretch that this is judged over [m]

struct Neighbour
{
  double d, value, weight;
};

struct LocalLine
{
  double value = std::numeric_limits<double>::quiet_NaN();  ///< at the section
  double slope = 0.0;
  double share = 1.0;  ///< variance of the value over that of one section
};

/// What is used over and over, so that it is taken from memory once.
struct Scratch
{
  std::vector<Neighbour> found;
  std::vector<double> residuals, sorted;
};

/// The measured sections around section k, `skip` on either side of it (and itself) left out; skip < 0: none.
void findNeighbours(const std::vector<double>& s, const AlongWeld& raw, std::size_t k, double window, int skip,
                    std::vector<Neighbour>& found)
{
  found.clear();
  auto j = static_cast<std::size_t>(std::upper_bound(s.begin(), s.end(), s[k] - window) - s.begin());
  for (; j < s.size() && s[j] < s[k] + window; ++j)
  {
    if (!(raw.sigma[j] > 0.0) || std::abs(static_cast<int>(j) - static_cast<int>(k)) <= skip)
      continue;
    const double d = s[j] - s[k];
    found.push_back(Neighbour{ d, raw.value[j], (1.0 - square(d / window)) / square(raw.sigma[j]) });
  }
}

LocalLine regress(const std::vector<Neighbour>& found)
{
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, squares = 0.0;
  for (const Neighbour& one : found)
  {
    n += one.weight, x += one.weight * one.d, y += one.weight * one.value;
    xx += one.weight * one.d * one.d, xy += one.weight * one.d * one.value, squares += square(one.weight);
  }
  LocalLine line;
  const double spread = n > 0.0 ? xx / n - square(x / n) : 0.0;
  if (!(spread > 0.0))
    return line;
  line.slope = (xy / n - x / n * y / n) / spread;
  line.value = y / n - line.slope * x / n;
  line.share = std::min(1.0, squares / square(n) * (1.0 + square(x / n) / spread));
  return line;
}

LocalLine mean(const std::vector<Neighbour>& found)
{
  LocalLine line;
  double n = 0.0, sum = 0.0;
  for (const Neighbour& one : found)
    n += one.weight, sum += one.weight * one.value;
  if (n > 0.0)
    line.value = sum / n;
  return line;
}

/// A robust line through scratch.found, whose weights it changes.
LocalLine predict(Scratch& scratch)
{
  std::vector<Neighbour>& found = scratch.found;
  if (found.size() < kFewest)
    return LocalLine();
  const LocalLine first = regress(found);
  scratch.residuals.clear();
  for (const Neighbour& one : found)
    scratch.residuals.push_back(one.value - first.value - first.slope * one.d);
  scratch.sorted = scratch.residuals;
  const double scale = robustSigmaInPlace(scratch.sorted);
  if (!(scale > 0.0))
    return first;
  for (std::size_t i = 0; i < found.size(); ++i)
    found[i].weight *= tukey(scratch.residuals[i] / scale);
  return regress(found);
}

/// The window that foretells left-out sections best; 0 = too few sections.
double bestWindow(const std::vector<double>& s, const AlongWeld& raw)
{
  double best = 0.0, least = INFINITY;
  Scratch scratch;
  std::vector<double> errors;
  for (const double window : kWindows)
  {
    errors.clear();
    for (std::size_t k = 0; k < s.size(); ++k)
    {
      if (!std::isfinite(raw.value[k]))
        continue;
      findNeighbours(s, raw, k, window, 1, scratch.found);
      errors.push_back(raw.value[k] - predict(scratch).value);
    }
    const double error = robustSigmaInPlace(errors);
    if (!(error < least))
      continue;
    least = error;
    best = window;
  }
  return best;
}

/// Share of each section's departure from the smooth line that is real change.
std::vector<double> realShares(const std::vector<double>& s, const AlongWeld& raw, const std::vector<LocalLine>& lines)
{
  std::vector<double> shares(s.size(), 0.0);
  for (std::size_t k = 0; k < s.size(); ++k)
  {
    double scatter = 0.0, noise = 0.0;
    auto j = static_cast<std::size_t>(std::upper_bound(s.begin(), s.end(), s[k] - kStretch) - s.begin());
    for (; j < s.size() && s[j] < s[k] + kStretch; ++j)
    {
      if (!std::isfinite(raw.value[j]) || !std::isfinite(lines[j].value))
        continue;
      scatter += square(raw.value[j] - lines[j].value);
      noise += square(raw.sigma[j]);
    }
    shares[k] = scatter > 0.0 ? std::max(0.0, 1.0 - kDoubt * noise / scatter) : 0.0;
  }
  return shares;
}
}  // namespace

AlongWeld smoothAlong(const std::vector<double>& s, const AlongWeld& raw)
{
  AlongWeld result = raw;
  const double window = bestWindow(s, raw);
  if (!(window > 0.0))
    return result;
  std::vector<LocalLine> lines(s.size());
  std::vector<double> departures;
  Scratch scratch;
  for (std::size_t k = 0; k < s.size(); ++k)
  {
    if (!std::isfinite(raw.value[k]))
      continue;
    findNeighbours(s, raw, k, window, -1, scratch.found);
    lines[k] = predict(scratch);
    departures.push_back((raw.value[k] - lines[k].value) / raw.sigma[k] /
                         std::sqrt(std::max(0.1, 1.0 - lines[k].share)));
  }
  const double observed = robustSigma(std::move(departures));
  const double grown = std::isfinite(observed) ? std::max(1.0, observed) : 1.0;
  const std::vector<double> shares = realShares(s, raw, lines);
  for (std::size_t k = 0; k < s.size(); ++k)
  {
    if (!std::isfinite(raw.value[k]) || !std::isfinite(lines[k].value))
      continue;
    const double share = shares[k];
    result.value[k] = lines[k].value + share * (raw.value[k] - lines[k].value);
    result.sigma[k] =
        raw.sigma[k] * grown * std::sqrt(std::min(1.0, share * share + (1.0 - share * share) * lines[k].share));
  }
  return result;
}

AlongWeld continueAlong(const std::vector<double>& s, const AlongWeld& smooth, const Continuation& how)
{
  AlongWeld result = smooth;
  Scratch scratch;
  for (std::size_t k = 0; k < s.size(); ++k)
  {
    if (std::isfinite(smooth.value[k]))
      continue;
    double nearest = INFINITY;
    for (std::size_t j = 0; j < s.size(); ++j)
    {
      if (std::isfinite(smooth.value[j]))
        nearest = std::min(nearest, std::abs(s[j] - s[k]));
    }
    if (!(nearest <= how.reach))
      continue;
    std::vector<Neighbour>& found = scratch.found;
    found.clear();
    std::vector<double> sigmas;
    for (std::size_t j = 0; j < s.size(); ++j)
    {
      if (!std::isfinite(smooth.value[j]) || std::abs(s[j] - s[k]) > nearest + how.window)
        continue;
      found.push_back(Neighbour{ s[j] - s[k], smooth.value[j], 1.0 / std::max(square(smooth.sigma[j]), 1e-18) });
      sigmas.push_back(smooth.sigma[j]);
    }
    const LocalLine line = how.level ? mean(found) : predict(scratch);
    if (!std::isfinite(line.value))
      continue;
    // smoothed neighbours err alike: a line's slope is no better than one sigma over half the window
    result.value[k] = line.value;
    result.sigma[k] = median(sigmas) * (1.0 + 2.0 * nearest / how.window);
  }
  return result;
}
}  // namespace weld
}  // namespace weld_profiler
