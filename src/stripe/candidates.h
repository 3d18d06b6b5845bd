#pragma once

#include <cstdint>
#include <vector>

#include "column_peaks.h"
#include "frame_statistics.h"
#include "median_filter.h"
#include "seed.h"

namespace weld_profiler
{
/// Finds in each column the rises that could be the stripe: local contrast, never a threshold alone, so that glow and
/// ambient light under the stripe do no harm.
class CandidateFinder
{
public:
  static constexpr int kPerColumn = 5;  ///< the brightest are kept

  /// @param candidates  of every column of the image, rising in v within a column.
  void find(const ImageView& image, const StripeParams& params, const FrameStatistics& statistics,
            CandidateList& candidates);

private:
  /// Rows of one column, in blocks of TiledMedian::kTileRows, that rise above the frame's background.
  struct Zone
  {
    std::int16_t first_block, last_block;
  };
  static constexpr int kZones = 12;  ///< in a column; a frame with more shows no stripe

  template <class Pixel>
  void findZones(const ImageView& image, double floor);
  template <class Pixel>
  std::vector<Pixel>& maxima();
  void addBlock(int u, int block);
  void requestTiles(int width, int blocks);
  template <class Pixel>
  void readProfile(int u, int first_row, int last_row);
  void addCandidate(const ColumnPeak& peak, int first_row, double widest);
  void keepBrightest(CandidateList& candidates);

  TiledMedian median_;
  float least_contrast_ = 0.0F;
  std::vector<std::uint8_t> zone_count_;
  std::vector<Zone> zones_;
  std::vector<std::uint8_t> maxima8_;
  std::vector<std::uint16_t> maxima16_;
  std::vector<float> profile_;
  ColumnPeaks peaks_;
  std::vector<Candidate> found_;
};
}  // namespace weld_profiler
