#pragma once

#include <random>
#include <vector>

namespace weld_profiler
{
namespace test_support
{
/// What a speckle pattern is like.
struct SpeckleSettings
{
  int width = 0, height = 0;
  double contrast = 0.2;  ///< standard deviation over mean of the intensity, (0, 1]
  double grain_px = 2.0;  ///< full width at half maximum of the intensity's autocovariance
};

/// Relative intensity of speckle, mean 1, row after row: the mean of 1 / contrast^2 independent patterns, each the
/// squared modulus of a complex Gaussian field (J. W. Goodman, "Speckle Phenomena in Optics", 2007, chapters 3 and 5).
std::vector<double> speckleIntensity(const SpeckleSettings& settings, std::mt19937& random);
}  // namespace test_support
}  // namespace weld_profiler
