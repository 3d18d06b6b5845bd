#include <algorithm>
#include <cmath>

#include "gauss_model.h"
#include "method.h"

namespace weld_profiler
{
namespace
{
constexpr double kWindowSigmas = 3.0;  ///< half a window; beyond, a Gaussian says nothing
constexpr int kLeastHalf = 3;          ///< 7 rows for 4 unknowns, however narrow the stripe [px]
constexpr double kAstraySigmas = 1.0;  ///< from the centroid; a fit that went farther follows something else
constexpr double kNarrower = 0.4;      ///< share of the centroid's width that a fit may tell
constexpr double kWider = 2.5;
constexpr std::size_t kGainColumns = 128;  ///< that tell the gain, to 6 %

/// A Gaussian (amplitude, centre, sigma, background) fitted to each column.
///
/// Source: R. B. Fisher, D. K. Naidu, "A Comparison of Algorithms for Subpixel Peak Detection", 1996 (Gaussian
/// approximation, there through three points). `fit: least_squares` weighs all pixels alike; `maximum_likelihood` by
/// read and shot noise, the gain being told by how the residuals of the least-squares fit grow with the signal. Clipped
/// pixels are censored in both. Good for: stripes with a Gaussian cross-section, clipped ones above all; reaches the
/// bound of one column. Poor for: flat-topped or torn cross-sections (speckle), brightness that changes along an
/// oblique stripe, and time. A column whose fit does not settle within its stripe keeps the centroid.
class GaussFitMethod : public MethodBase
{
public:
  using MethodBase::MethodBase;

protected:
  void refine(const ImageView& image, Workspace::Scratch& scratch) const override
  {
    PixelNoise noise;
    noise.read = scratch.finder.noise();
    if (params().fit == "maximum_likelihood")
      noise.gain = typicalGain(image, noise, scratch);
    const Levels levels = levelsOf(image, params());
    for (Centre& centre : scratch.centres)
    {
      const GaussFit fit = fitTo(image, noise, centre, scratch.column);
      if (!isTheStripe(fit, centre))
        continue;
      centre.background += centre.gradient * (fit.model.centre - centre.v);
      centre.v = fit.model.centre;
      centre.sigma_column = fit.model.sigma;
      centre.amplitude = std::min(fit.model.amplitude, levels.saturation - centre.background);
      centre.read_sigma = fit.read_sigma;
    }
  }

private:
  GaussFit fitTo(const ImageView& image, const PixelNoise& noise, const Centre& centre, GrayColumn& column) const
  {
    const int half = std::max(kLeastHalf, static_cast<int>(std::lround(kWindowSigmas * centre.sigma_column)));
    readColumn(image, levelsOf(image, params()), centre, static_cast<int>(std::lround(centre.v)), half, column);
    return fitGauss(column, noise, GaussModel{ centre.amplitude, centre.v, centre.sigma_column, 0.0 });
  }

  static bool isTheStripe(const GaussFit& fit, const Centre& centre)
  {
    return fit.settled && std::abs(fit.model.centre - centre.v) <= kAstraySigmas * centre.sigma_column &&
           fit.model.sigma >= kNarrower * centre.sigma_column && fit.model.sigma <= kWider * centre.sigma_column;
  }

  /// The median of what some columns tell: a spatter in some of them says nothing about the noise.
  double typicalGain(const ImageView& image, const PixelNoise& noise, Workspace::Scratch& scratch) const
  {
    scratch.gains.clear();
    const std::size_t stride = std::max<std::size_t>(1, scratch.centres.size() / kGainColumns);
    for (std::size_t i = 0; i < scratch.centres.size(); i += stride)
    {
      const Centre& centre = scratch.centres[i];
      const GaussFit fit = fitTo(image, noise, centre, scratch.column);
      if (isTheStripe(fit, centre))
        scratch.gains.push_back(gainOf(scratch.column, fit.model, noise.read));
    }
    if (scratch.gains.empty())
      return 0.0;
    const auto middle = scratch.gains.begin() + static_cast<std::ptrdiff_t>(scratch.gains.size() / 2);
    std::nth_element(scratch.gains.begin(), middle, scratch.gains.end());
    return *middle;
  }
};
}  // namespace

std::unique_ptr<const StripeExtractor> makeGaussFit(const StripeParams& params)
{
  return std::make_unique<GaussFitMethod>(params);
}
}  // namespace weld_profiler
