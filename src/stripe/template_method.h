#pragma once

#include "literal_reading.h"
#include "method.h"
#include "template_normal.h"

namespace weld_profiler
{
/// The paper's chain in the sound reading: Eq. 4, the normal of the 7x7 template around its pixel block, and the
/// second-order Taylor step along it. The initial point stays where the template or the kernel leaves the image, the
/// normal is undefined, or the step does not settle; its normal is then that of the centre line.
class TemplateMethod : public MethodBase
{
public:
  TemplateMethod(const StripeParams& params, NormalOfTemplate normal) : MethodBase(params), normal_(normal) {}

protected:
  void refine(const ImageView& image, Workspace::Scratch& scratch) const override;

private:
  NormalOfTemplate normal_;
};
}  // namespace weld_profiler
