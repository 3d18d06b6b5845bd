#pragma once

#include <vector>

#include "centre.h"
#include "derivatives.h"
#include "site_derivatives.h"
#include "site_normals.h"
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

/// Moves centres to where the gray is largest along the normal, starting from a pixel of each.
///
/// Sound reading: the expansion is about the block, where the derivatives are taken, and so is the result: block + t n.
/// Where |t| > 1/2 the centre lies in a neighbouring pixel of the column: the block moves there and the step is
/// repeated. Sets u, v, normal and read_sigma; leaves a centre untouched where the kernel leaves the image, there is no
/// normal or no maximum, or where no pixel of the column satisfies the half-pixel condition.
class TaylorSteps
{
public:
  struct Task
  {
    const ImageView& image;
    const DerivativeKernel& kernel;
    const SiteNormals* normals = nullptr;  ///< of the sites; null = Steger's: the eigenvector of the Hessian's
                                           ///< eigenvalue of largest magnitude, anew at every block
    double noise = 0.0;                    ///< 1-sigma of one pixel [grey levels]
  };

  /// @param sites  the blocks to start from.
  void settle(const Task& task, const Sites& sites, std::vector<Centre>& centres);

private:
  enum class Outcome
  {
    Settled,
    Moved,  ///< to the block of the next round
    Failed
  };

  void begin(const Task& task, const Sites& sites);
  void measure(const Task& task);
  /// Settles one centre, or moves its site on.
  Outcome step(const Task& task, std::size_t i, Centre& centre);

  SiteDerivatives derivatives_;
  // one value a site that is not settled yet
  Sites sites_;
  std::vector<int> before_;   ///< row of the block before; that of the site in the first round
  std::vector<float> u_, v_;  ///< normal
  std::vector<float> t_, curvature_;
};
}  // namespace weld_profiler
