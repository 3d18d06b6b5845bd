#pragma once

#include "weld_profiler/core/scan.h"

namespace weld_profiler
{
/// 3 rows of 5 cells: two points, none, and three.
inline Scan someScan()
{
  Scan scan;
  scan.frame_id = "part";
  scan.cells = 5;
  const Stamp start = 1700000000123456789LL;
  for (int i = 0; i < 3; ++i)
    scan.rows.push_back(Profile{ start + i * 50000000LL, 7u + static_cast<unsigned>(i), 0.25 + 0.001 * i, 5, {} });
  scan.rows[0].points = { { 0.1F, 0.25F, 0.3F, 40.0F, 1e-5F, 1, 0 }, { 0.2F, 0.25F, 0.31F, 41.0F, 2e-5F, 4, 2 } };
  scan.rows[2].points = { { 0.1F, 0.26F, 0.32F, 42.0F, 3e-5F, 0, 5 },
                          { 0.2F, 0.26F, 0.33F, 43.0F, 4e-5F, 1, 0 },
                          { 0.3F, 0.26F, 0.34F, 44.0F, 5e-5F, 2, 1 } };
  return scan;
}
}  // namespace weld_profiler
