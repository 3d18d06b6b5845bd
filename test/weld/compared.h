#pragma once

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
constexpr double kLength = 59 * 2e-4;  ///< of an IdealScanner's scan, first row to last [m]

/// Value within 3 of its sigmas, and within what issue and domain ask for: 1 % or 5 um over the width.
inline void expectVolume(const char* what, const Quantity& volume, double truth, double width)
{
  ASSERT_TRUE(volume.measured()) << what;
  EXPECT_LT(std::abs(volume.value - truth), 3.0 * volume.sigma)
      << what << " " << 1e9 * volume.value << " is " << 1e9 * truth << " mm^3, sigma " << 1e9 * volume.sigma;
  EXPECT_NEAR(volume.value, truth, std::max(0.01 * truth, 5e-6 * width * kLength)) << what;
  EXPECT_LT(volume.sigma, std::max(0.01 * truth, 5e-6 * width * kLength)) << what << ": a sigma that says nothing";
}
}  // namespace weld_profiler
