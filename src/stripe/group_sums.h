#pragma once

#include <cstdint>
#include <vector>

#include "weld_profiler/core/image.h"

namespace weld_profiler
{
constexpr int kGroup = 8;  ///< neighbouring columns that are searched as one

/// Sums of the grey levels of 8 neighbouring columns, in every n-th row: one read of the image, after which a stripe is
/// looked for in a picture 8 n times smaller and less noisy by sqrt(8).
class GroupSums
{
public:
  /// Lays out the rows of an image; sums nothing yet.
  /// @param image     at least 8 columns wide.
  /// @param row_step  1 = every row.
  void layOut(const ImageView& image, int row_step);

  /// Sums rows first, first + every, ... below last, counted as row() counts them.
  void sum(const ImageView& image, int first, int last, int every = 1);

  int groups() const { return groups_; }
  int columns() const { return last_column_ + kGroup; }
  int rows() const { return rows_; }
  int rowStep() const { return row_step_; }
  std::size_t stride() const { return stride_; }  ///< from one row to the next; a multiple of 16
  const std::uint16_t* row(int i) const { return sums_.data() + static_cast<std::size_t>(i) * stride_; }

  /// First column of a group; the last group of a width that 8 does not divide overlaps its neighbour.
  int firstColumn(int group) const { return group + 1 < groups_ ? group * kGroup : last_column_; }
  float middle(int group) const { return static_cast<float>(firstColumn(group)) + 0.5F * (kGroup - 1); }

  /// What a sum counts for each grey level of the image.
  float perLevel() const { return per_level_; }

private:
  template <class Pixel>
  void sumRow(const Pixel* pixels, std::uint16_t* sums) const;

  int groups_ = 0;
  int rows_ = 0;
  int row_step_ = 1;
  int last_column_ = 0;
  int shift_ = 0;
  float per_level_ = 1.0F;
  std::size_t stride_ = 0;
  std::vector<std::uint16_t> sums_;
};
}  // namespace weld_profiler
