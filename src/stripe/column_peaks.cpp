#include "column_peaks.h"

#include <algorithm>

namespace weld_profiler
{
namespace
{
constexpr float kDrop = 0.5F;   ///< share of its height by which a top must be left before it counts as one
constexpr float kTorn = 0.35F;  ///< a dip that stays above this share is speckle inside one stripe
}  // namespace

void ColumnPeaks::find(const std::vector<float>& profile, float least_contrast)
{
  peaks_.clear();
  const float* p = profile.data();
  const int count = static_cast<int>(profile.size());
  ColumnPeak peak{ 0, 0, 0 };
  bool rising = true;
  for (int i = 1; i < count; ++i)
  {
    if (rising)
    {
      const float height = p[peak.top] - p[peak.left_foot];
      if (p[i] > p[peak.top])
        peak.top = i;
      else if (p[i] < p[peak.left_foot] && height < least_contrast)
        peak.left_foot = peak.top = i;
      else if (height >= least_contrast && p[peak.top] - p[i] >= std::max(least_contrast, kDrop * height))
      {
        peak.right_foot = i;
        rising = false;
      }
    }
    else if (p[i] < p[peak.right_foot])
      peak.right_foot = i;
    else if (p[i] - p[peak.right_foot] >= least_contrast)
    {
      peaks_.push_back(peak);
      peak = ColumnPeak{ peak.right_foot, i, i };
      rising = true;
    }
  }
  if (!rising)
    peaks_.push_back(peak);
  mergeTorn(p);
}

/// Speckle tears the top of a wide stripe: neighbours that share a high dip are one.
void ColumnPeaks::mergeTorn(const float* p)
{
  std::size_t kept = 0;
  for (std::size_t i = 1; i < peaks_.size(); ++i)
  {
    ColumnPeak& before = peaks_[kept];
    const ColumnPeak& next = peaks_[i];
    const float base = std::max(p[before.left_foot], p[next.right_foot]);
    const float lower_top = std::min(p[before.top], p[next.top]);
    if (p[before.right_foot] - base > kTorn * (lower_top - base))
      before = ColumnPeak{ before.left_foot, p[before.top] >= p[next.top] ? before.top : next.top, next.right_foot };
    else
      peaks_[++kept] = next;
  }
  if (!peaks_.empty())
    peaks_.resize(kept + 1);
}
}  // namespace weld_profiler
