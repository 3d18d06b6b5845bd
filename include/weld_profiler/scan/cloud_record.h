#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "weld_profiler/core/scan.h"

namespace weld_profiler
{
/// One point as it lies in scan_points and in a PCD file: point_step 32.
struct CloudRecord
{
  float x, y, z;    ///< [m]
  float intensity;  ///< [DN]
  float sigma;      ///< 1-sigma in z [m]
  float stage;      ///< [m]
  float time;       ///< since the first row [s]
  std::uint8_t flags;
  std::uint8_t padding[3];  ///< 0, so that the same scan is the same bytes
};
static_assert(sizeof(CloudRecord) == 32 && offsetof(CloudRecord, flags) == 28, "the layout of scan_points");
static_assert(std::is_trivially_copyable<CloudRecord>::value, "copied as bytes");

/// A field of CloudRecord.
struct CloudField
{
  const char* name;
  std::uint32_t offset;
  bool is_float;  ///< FLOAT32, else UINT8
};

/// The fields of scan_points, in order.
constexpr CloudField kCloudFields[] = { { "x", 0, true },          { "y", 4, true },      { "z", 8, true },
                                        { "intensity", 12, true }, { "sigma", 16, true }, { "stage", 20, true },
                                        { "time", 24, true },      { "flags", 28, false } };

/// One point of a profile.
/// @param origin  the stamp that `time` counts from.
CloudRecord cloudRecord(const Profile& profile, const CloudPoint& point, Stamp origin);

/// The organised cloud: scan.rows.size() rows of scan.cells records. A hole has NaN in x y z intensity sigma; stage and
/// time are its row's, flags 0.
std::vector<CloudRecord> organisedRecords(const Scan& scan);

/// The valid points alone, row by row.
std::vector<CloudRecord> validRecords(const Scan& scan);
}  // namespace weld_profiler
