#include "otsu.h"

namespace weld_profiler
{
int otsuBin(const Histogram& histogram)
{
  double total = 0.0;
  double total_moment = 0.0;
  for (int i = 0; i < kBins; ++i)
  {
    total += histogram[i];
    total_moment += static_cast<double>(i) * histogram[i];
  }
  double below = 0.0;
  double moment = 0.0;
  double best = 0.0;
  int threshold = 0;
  for (int i = 0; i < kBins; ++i)
  {
    below += histogram[i];
    moment += static_cast<double>(i) * histogram[i];
    const double above = total - below;
    if (below <= 0.0 || above <= 0.0)
      continue;
    const double distance = moment / below - (total_moment - moment) / above;
    const double between = below * above * distance * distance;
    // A hair more, so that rounding does not move the threshold across an empty stretch of equal maxima.
    if (between > best * (1.0 + 1e-12))
    {
      best = between;
      threshold = i;
    }
  }
  return threshold;
}
}  // namespace weld_profiler
