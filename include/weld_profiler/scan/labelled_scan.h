#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "weld_profiler/scan/cloud_record.h"

namespace weld_profiler
{
/// What is known of each point of an organised scan, row by row, a column a cell.
struct ScanLabels
{
  const std::vector<std::uint8_t>& labels;  ///< rows x cells; 0 = unknown
  const std::vector<float>& removal;        ///< rows x cells, height above the target [m], NaN = unknown
};

/// One point as it lies in weld_points: that of scan_points, its label and what is to be removed there.
struct LabelledRecord
{
  CloudRecord point;
  std::uint32_t label;  ///< 0 unknown, 1 base, 2 bead, 3 undercut, 4 spatter
  float removal;        ///< [m], >= 0, NaN = unknown
};
static_assert(sizeof(LabelledRecord) == 40 && offsetof(LabelledRecord, removal) == 36, "the layout of weld_points");
static_assert(std::is_trivially_copyable<LabelledRecord>::value, "copied as bytes");

/// The organised cloud. Maps that are empty are unknown throughout; a hole has label 0 and no removal.
/// @throws PreconditionError when a map that is not empty has another size than the scan.
std::vector<LabelledRecord> labelledRecords(const Scan& scan, const ScanLabels& labels);

/// Writes them as an organised, binary PCD, whole or not at all.
/// @param comments  for the file's head, one line each.
/// @throws InputError naming path and cause.
void saveLabelledScan(const Scan& scan, const ScanLabels& labels, const std::string& path,
                      const std::vector<std::string>& comments = {});
}  // namespace weld_profiler
