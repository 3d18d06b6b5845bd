#pragma once

#include "method.h"
#include "template_normal.h"

namespace weld_profiler
{
using NormalOfTemplate = TemplateNormal (*)(const ImageView& image, const Levels& levels, const Block& block);

/// The paper's text taken to the letter: everything is measured on the median-filtered image, Eq. 4 sums what Otsu's
/// threshold leaves of a column, the derivatives are the Sobel operator's own output at the pixel block, and the step
/// is added to the initial point, (x_c + t n_x, y_c + t n_y). Points that break the half-pixel condition are dropped.
/// For comparison only: docs/paper.md has the figures.
class LiteralReading : public StripeExtractor
{
public:
  LiteralReading(const StripeParams& params, NormalOfTemplate normal) : params_(params), normal_(normal) {}

  void extract(const ImageView& image, const StripeHint& hint, Workspace& workspace, Stripe& stripe) const override;

private:
  void refine(const ImageView& filtered, Workspace::Scratch& scratch) const;

  StripeParams params_;
  NormalOfTemplate normal_;
};
}  // namespace weld_profiler
