#pragma once

#include <opencv2/core/mat.hpp>

#include "weld_profiler/core/image.h"
#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
namespace comparison
{
/// Steger's detector as a textbook writes it with OpenCV: five separable Gaussian derivatives of the whole frame in
/// float, the eigenvector of the Hessian at each pixel, in each column the strongest line point.
///
/// Source: C. Steger, "An unbiased detector of curvilinear structures", IEEE PAMI 20(2), 1998, sections 2-3.
class OpencvSteger
{
public:
  /// @param sigma  of the Gaussian [px].
  explicit OpencvSteger(double sigma);

  /// @param image   mono8 or mono16, stripe along the rows.
  /// @param stripe  one centre a column at most; sigma is 0: the method tells none.
  void process(const RawImage& image, Stripe& stripe);

private:
  void findStrongest();
  bool centreAt(int u, StripePoint& point) const;

  cv::Mat smooth_, first_, second_;  // kernels
  cv::Mat x_, y_, xx_, xy_, yy_;
  cv::Mat strongest_, row_;  // of each column
  double weakest_;
};
}  // namespace comparison
}  // namespace weld_profiler
