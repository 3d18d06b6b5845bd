#pragma once

#include <string>
#include <vector>

#include "comparison/score.h"

namespace weld_profiler
{
namespace comparison
{
constexpr double kDegree = 3.14159265358979323846 / 180.0;

/// A straight stripe in a frame it does not leave, away from the noise's limits. Its sub-pixel place varies along it.
/// @param degrees  of slope.
test_support::StripePicture straightScene(double sigma, double degrees, unsigned seed);
/// 45 deg flanks, curvature up to 0.03 / px.
test_support::StripePicture beadScene(double snr, unsigned seed);

/// Where a stripe is dark.
struct Break
{
  int first = 0, length = 0;  ///< [columns]
};
/// The bead, SNR 50, with breaks: columns without light. What is longer than a repair's limit is to stay open.
Sample brokenBead(const std::vector<Break>& breaks, unsigned seed);

/// One line of the table of scenes.
struct SceneSet
{
  std::string name;
  double stripe_sigma = 2.0;
  std::vector<Sample> samples;
  bool noise = true;           ///< without it a told sigma has nothing to be compared with
  bool centre_defined = true;  ///< false: a lopsided profile has no one centre; a constant offset is not counted
};

/// Names of all scenes of the table.
std::vector<std::string> sceneNames();
/// Renders one of them.
SceneSet makeScene(const std::string& name, int seeds);
}  // namespace comparison
}  // namespace weld_profiler
