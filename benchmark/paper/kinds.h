#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weld_profiler/core/image.h"
#include "weld_profiler/simulation/simulated_scan.h"
#include "weld_profiler/stripe/stripe_params.h"

namespace weld_profiler
{
namespace paper_tables
{
/// One frame of the scan, and what is true of it.
struct KindFrame
{
  std::vector<std::uint8_t> pixels;
  RawImage image;
  std::vector<TruthCentre> truth;  ///< visible cells only
};

/// One of the four stripes of the paper's Fig. 8: neighbouring frames of the scan, the middle one for Eq. 12.
struct Kind
{
  std::string name;
  std::vector<KindFrame> frames;

  const KindFrame& middle() const { return frames[frames.size() / 2]; }
};

/// Renders flat, start, middle and end of the scene's weld.
std::vector<Kind> renderKinds(const std::string& scene_path);

/// A method under the paper's settings.
struct Entry
{
  std::string name;
  StripeParams params;
};

/// All registered methods, and the paper to the letter.
std::vector<Entry> entries();
}  // namespace paper_tables
}  // namespace weld_profiler
