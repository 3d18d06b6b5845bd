#pragma once

#include "centre.h"
#include "derivatives.h"
#include "template_normal.h"

namespace weld_profiler
{
constexpr double kHalfPixel = 0.5;  ///< the paper's condition: a centre lies inside its own pixel

/// The offset t along the unit normal at which the gray is largest, Eqs. 10-11:
/// t = -(n_x I_x + n_y I_y) / (n_x^2 I_xx + 2 n_x n_y I_xy + n_y^2 I_yy).
struct TaylorStep
{
  bool maximum = false;    ///< the gray is curved downward along the normal, so there is one
  double t = 0.0;          ///< from where the derivatives were taken [px]
  double curvature = 0.0;  ///< second derivative along the normal [grey levels / px^2]
};

TaylorStep taylorStep(const Derivatives& derivatives, const TemplateNormal& normal);

/// Steger's normal: the eigenvector of the Hessian's eigenvalue of largest magnitude. Undefined in a flat image.
TemplateNormal hessianNormal(const Derivatives& derivatives);

/// Moves a centre to where the gray is largest along the normal, starting from its pixel block (cell, round(v)).
///
/// Sound reading: the expansion is about the block, where the derivatives are taken, and so is the result: block + t n.
/// Where |t| > 1/2 the centre lies in a neighbouring pixel of the column: the block moves there and the step is
/// repeated. Sets u, v, normal and read_sigma.
/// @param normal  of the block; null = the Hessian's, taken anew at every block.
/// @param noise   1-sigma of one pixel [grey levels].
/// @return false, the centre untouched, where the kernel leaves the image, there is no normal or no maximum, or where
/// no
///         pixel of the column satisfies the half-pixel condition.
bool stepToCentre(const ImageView& image, const DerivativeKernel& kernel, const TemplateNormal* normal, double noise,
                  Centre& centre);
}  // namespace weld_profiler
