#pragma once

#include <vector>

#include "weld_profiler/core/image.h"

namespace weld_profiler
{
/// Partial derivatives of the gray at one pixel: I_x, I_y, I_xx, I_xy, I_yy of Eq. 10, x along u and y along v.
struct Derivatives
{
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
};

/// Takes derivatives at single pixels, so that only those on the stripe cost anything; the values are those of a
/// convolution of the whole image.
class DerivativeKernel
{
public:
  enum class Sobel
  {
    Scaled,   ///< divided by the operator's gain, 8 for first and 4 for second derivatives
    Unscaled  ///< in the proportion of the operator's own output: a Taylor step twice as long
  };

  /// The paper's choice: 3x3. Poor for: noise; it looks at nine pixels.
  void setSobel(Sobel scaling);
  /// Steger's: Gaussian smoothed. Best with a sigma of 1.155 times the stripe's.
  void setGaussian(double sigma);

  int reach() const { return reach_; }
  bool holds(const ImageView& image, int u, int v) const;
  /// @param u, v  a pixel for which holds() is true.
  Derivatives at(const ImageView& image, int u, int v) const;

  /// The kernel's one-dimensional factors in single precision, 2 reach() + 1 values each: smooth, then first and second
  /// derivative; a two-dimensional derivative is the product of one along u and one along v.
  void copyFactors(std::vector<float>& factors) const;

  /// 1-sigma of a first derivative across the stripe for a noise of one grey level.
  double noiseGain() const { return noise_gain_; }

private:
  void finish();

  int reach_ = 0;
  std::vector<double> smooth_, first_, second_;  ///< one-dimensional factors; the kernel is separable
  double first_gain_ = 1.0;
  double noise_gain_ = 0.0;
};
}  // namespace weld_profiler
