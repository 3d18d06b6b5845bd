#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace weld_profiler
{
namespace reference
{
/// A centre of plainSvd().
struct PlainCentre
{
  int cell = 0;
  double u = 0.0, v = 0.0;  ///< where `defined` is false: the initial point
  bool defined = false;     ///< the template has a normal and the step settled
};

/// The paper's chain as one writes it with OpenCV and Eigen, over the whole frame: median, Otsu's threshold, Eq. 4,
/// five Gaussian derivatives of the frame in single precision, the singular value decomposition of the 49x3 matrix of
/// every template, the second-order Taylor step from its pixel block. In the sound reading, as method `svd` has it by
/// default (docs/paper.md), and sharing no code with it.
/// @param gray8             8 bit, one channel; the stripe runs along the rows.
/// @param hessian_sigma_px  of the derivatives; the kernels reach 4 sigma.
/// @param initial_rows      one a column, NaN = none: taken for the initial points in place of Eq. 4's, which is
///                          computed all the same. Empty = Eq. 4's.
/// @return a centre for each column that has an initial point.
std::vector<PlainCentre> plainSvd(const cv::Mat& gray8, double hessian_sigma_px,
                                  const std::vector<double>& initial_rows = {});
}  // namespace reference
}  // namespace weld_profiler
