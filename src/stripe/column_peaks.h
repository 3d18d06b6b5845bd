#pragma once

#include <vector>

namespace weld_profiler
{
/// A top between its two feet; indices into the profile of a column.
struct ColumnPeak
{
  int left_foot, top, right_foot;
};

/// Finds the tops of a profile by how far they stand out of their own surroundings, whatever lies under them.
class ColumnPeaks
{
public:
  /// @param least_contrast  height above both feet that counts.
  void find(const std::vector<float>& profile, float least_contrast);
  const std::vector<ColumnPeak>& found() const { return peaks_; }

private:
  void mergeTorn(const float* p);

  std::vector<ColumnPeak> peaks_;
};
}  // namespace weld_profiler
