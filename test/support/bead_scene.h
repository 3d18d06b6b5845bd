#pragma once

#include <cmath>

#include "support/render_stripe.h"

namespace weld_profiler
{
namespace test_support
{
/// A bead between two plates, with noise.
inline StripePicture beadScene()
{
  StripePicture scene;
  scene.width = 400;
  scene.height = 160;
  scene.snr = 50.0;
  scene.row = [](double u) { return 110.3 + 0.03 * u - 45.0 * std::exp(-0.5 * std::pow((u - 200.0) / 45.0, 2.0)); };
  return scene;
}
}  // namespace test_support
}  // namespace weld_profiler
