#pragma once

#include "gray_column.h"

namespace weld_profiler
{
/// amplitude * exp(-(v - centre)^2 / (2 sigma^2)) + background, of one column. [px] and grey levels
struct GaussModel
{
  double amplitude = 0.0, centre = 0.0, sigma = 1.0;
  double background = 0.0;  ///< what the column's own background was off by
};

/// Variance of a pixel: read^2 + gain * signal [grey levels^2].
struct PixelNoise
{
  double read = 1.0;
  double gain =
      0.0;  ///< grey levels a photo-electron; 0 = the same noise everywhere, which makes the fit least squares
};

struct GaussFit
{
  bool settled = false;
  GaussModel model;
  double read_sigma = 0.0;  ///< 1-sigma of the centre that noise.read alone explains [px]
};

/// Fits the model by maximum likelihood: Fisher scoring (Gauss-Newton with the expected information), damped as
/// Levenberg and Marquardt do so that no step makes the fit less likely.
///
/// A clipped pixel says no more than that its light was at least the ceiling: it takes part with the probability of
/// that (Tobin's censored likelihood) instead of being left out or taken at its word.
/// @param start  the first guess.
/// @return settled = false where the rows are too few or 30 steps do not settle; the model is then worth nothing.
GaussFit fitGauss(const GrayColumn& column, const PixelNoise& noise, const GaussModel& start);

/// The gain that explains by how much a fitted column's residuals grow with its signal, from least squares; 0 where
/// they don't.
double gainOf(const GrayColumn& column, const GaussModel& model, double read);
}  // namespace weld_profiler
