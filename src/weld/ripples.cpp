#include "ripples.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kTwoPi = 6.283185307179586;
constexpr double kStretch = 15e-3;        // [m]
constexpr double kShortest = 0.4e-3;      // pitch looked for [m]
constexpr double kLongest = 4e-3;         // [m]
constexpr double kPitchSteps = 1.015;     // from one pitch tried to the next
constexpr double kSmooth = 4e-3;          // half width of the smooth course [m]
constexpr double kShare = 0.33;           // of the variance, explained
constexpr double kFinest = 1e-4;          // of the pitch, that it is searched to
constexpr double kUnknownScatter = 0.02;  // of pitch and height, where there are too few stretches to tell it
constexpr std::size_t kFewest = 16;       // heights in a stretch

struct Wave
{
  double pitch = std::numeric_limits<double>::quiet_NaN();
  double amplitude = 0.0, share = 0.0;
};

struct Series
{
  std::vector<double> s, rise;
};

/// Least squares of a sine and a cosine of one pitch.
Wave fitWave(const Series& series, double pitch)
{
  double cc = 0.0, ss = 0.0, cs = 0.0, cy = 0.0, sy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < series.s.size(); ++i)
  {
    const double c = std::cos(kTwoPi * series.s[i] / pitch), s = std::sin(kTwoPi * series.s[i] / pitch);
    const double y = series.rise[i];
    cc += c * c, ss += s * s, cs += c * s, cy += c * y, sy += s * y, yy += y * y;
  }
  Wave wave;
  const double det = cc * ss - cs * cs;
  if (!(det > 1e-6 * cc * ss) || !(yy > 0.0))
    return wave;
  const double a = (cy * ss - sy * cs) / det, b = (sy * cc - cy * cs) / det;
  wave.pitch = pitch;
  wave.amplitude = std::hypot(a, b);
  wave.share = (a * cy + b * sy) / yy;
  return wave;
}

/// Heights about their local mean line, so that a bead that grows has no wave.
Series detrended(const std::vector<double>& s, const std::vector<double>& height, double from, double to)
{
  Series all, series;
  for (std::size_t k = 0; k < s.size(); ++k)
  {
    if (s[k] < from || s[k] >= to || !std::isfinite(height[k]))
      continue;
    all.s.push_back(s[k]);
    all.rise.push_back(height[k]);
  }
  for (std::size_t k = 0; k < all.s.size(); ++k)
  {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t j = 0; j < all.s.size(); ++j)
    {
      const double d = all.s[j] - all.s[k];
      const double weight = std::max(0.0, 1.0 - square(d / kSmooth));
      n += weight, x += weight * d, y += weight * all.rise[j], xx += weight * d * d, xy += weight * d * all.rise[j];
    }
    const double spread = n * xx - x * x;
    const double slope = spread > 0.0 ? (n * xy - x * y) / spread : 0.0;
    series.s.push_back(all.s[k]);
    series.rise.push_back(all.rise[k] - (y - slope * x) / n);
  }
  return series;
}

Wave strongestWave(const Series& series)
{
  Wave best;
  if (series.s.size() < kFewest)
    return best;
  const double length = series.s.back() - series.s.front();
  const double step = length / static_cast<double>(series.s.size() - 1);
  const double shortest = std::max(kShortest, 2.5 * step), longest = std::min(kLongest, 0.34 * length);
  for (double pitch = shortest; pitch < longest; pitch *= kPitchSteps)
  {
    const Wave wave = fitWave(series, pitch);
    if (wave.share > best.share)
      best = wave;
  }
  // at an end of the search nothing says that it is a wave at all
  if (best.pitch < shortest * kPitchSteps || best.pitch > longest / square(kPitchSteps))
    return Wave();
  for (double part = kPitchSteps - 1.0; part > kFinest; part *= 0.5)
  {
    for (const double pitch : { best.pitch * (1.0 - part), best.pitch * (1.0 + part) })
    {
      const Wave wave = fitWave(series, pitch);
      if (wave.share > best.share)
        best = wave;
    }
  }
  return best;
}
}  // namespace

namespace
{
/// 1-sigma of a median over stretches, from their scatter.
double scatterOf(const std::vector<double>& values)
{
  constexpr std::size_t kEnough = 3;
  constexpr double kOfMedian = 1.2533;  // a median's sigma over a mean's
  const double middle = median(values);
  if (values.size() < kEnough)
    return kUnknownScatter * middle;
  std::vector<double> departures;
  for (const double value : values)
    departures.push_back(value - middle);
  return kOfMedian * std::max(robustSigma(std::move(departures)), kFinest * middle) /
         std::sqrt(static_cast<double>(values.size()));
}
}  // namespace

Ripples findRipples(const std::vector<double>& s, const std::vector<double>& height, double noise)
{
  Ripples ripples;
  std::vector<double> pitches, heights;
  if (s.empty())
    return ripples;
  const int stretches = std::max(1, static_cast<int>(std::lround((s.back() - s.front()) / kStretch)));
  const double stretch = (s.back() - s.front()) / stretches;
  for (int i = 0; i < stretches; ++i)
  {
    const double from = s.front() + i * stretch;
    const Series series = detrended(s, height, from, i + 1 < stretches ? from + stretch : INFINITY);
    const Wave wave = strongestWave(series);
    const double sure = 4.0 * noise * std::sqrt(2.0 / static_cast<double>(std::max<std::size_t>(1, series.s.size())));
    if (!(wave.share > kShare) || !(wave.amplitude > sure))
      continue;
    pitches.push_back(wave.pitch);
    heights.push_back(2.0 * wave.amplitude);
  }
  if (2 * static_cast<int>(pitches.size()) <= stretches && !(stretches == 1 && pitches.size() == 1))
    return ripples;
  const double count = static_cast<double>(s.size());
  ripples.pitch = Quantity{ median(pitches), 0.0 };
  ripples.height = Quantity{ median(heights), 2.0 * noise * std::sqrt(2.0 / count) };
  // a frequency is known to sqrt(6 / N) / pi noise over (amplitude times length): D. Rife, R. Boorstyn, 1974
  ripples.pitch.sigma = square(ripples.pitch.value) * std::sqrt(6.0 / count) / 3.14159265 * noise /
                        (0.5 * ripples.height.value * std::max(stretch, 1e-3));
  ripples.pitch.sigma = std::hypot(ripples.pitch.sigma, scatterOf(pitches));
  ripples.height.sigma = std::hypot(ripples.height.sigma, scatterOf(heights));
  return ripples;
}
}  // namespace weld
}  // namespace weld_profiler
