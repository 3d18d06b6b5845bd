#pragma once

#include <string>
#include <vector>

#include "comparison/candidates.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace comparison
{
/// What a cell of a rendered frame should yield.
enum class Expected : std::uint8_t
{
  Nothing,   ///< there is no stripe, and it is not to be made up
  Optional,  ///< none is missed, but what is there is judged: a break that a repair may fill
  Beyond,    ///< not judged: the ends of the image
  Centre
};

/// A frame with its truth.
struct Sample
{
  test_support::StripePicture truth;
  test_support::Picture picture;
  std::vector<Expected> expected;  ///< one a column
};

/// The frame of a scene; every column is to yield a centre but for `margin` columns at either end.
Sample sampleOf(const test_support::StripePicture& scene, int margin = 0);

/// Errors across the stripe of measured or of interpolated centres. [px]
struct ErrorSums
{
  std::size_t count = 0, with_sigma = 0;
  double sum = 0.0, squares = 0.0, in_sigmas = 0.0, largest = 0.0;

  void add(double error, double sigma);
  double rmse() const;
  double bias() const;
  double spread() const;   ///< standard deviation about the bias
  double honesty() const;  ///< RMS of error over told sigma: 1 is honest; NaN where none is told
};

/// What a contestant made of one scene.
struct Score
{
  ErrorSums measured, interpolated;          ///< within a pixel of the truth
  double squares = 0.0, largest = 0.0;       ///< of all centres, those beyond a pixel included
  std::size_t points = 0, outliers = 0;      ///< outliers: more than a pixel off
  std::size_t expected = 0, missing = 0;     ///< cells
  std::size_t breaks = 0, filled = 0;        ///< optional cells; those with an interpolated centre
  std::size_t empty = 0, made_up = 0;        ///< cells without a stripe; centres found there
  std::size_t saturated = 0, ambiguous = 0;  ///< flags told
  std::vector<int> columns_told;             ///< of each measured centre

  void add(const Sample& sample, const Stripe& stripe, const Candidate& candidate);
  double rmse() const;  ///< of every centre [px]
  double outlierPercent() const;
  double missingPercent() const;
};

/// Every sample through a contestant, each as the first frame of a stream.
Score judge(Candidate& candidate, const std::vector<Sample>& samples);
}  // namespace comparison
}  // namespace weld_profiler
