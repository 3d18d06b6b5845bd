#pragma once

#include "method.h"
#include "site_normals.h"

namespace weld_profiler
{
using NormalsOfTemplates = void (SiteNormals::*)(const ImageView& image, const Levels& levels, const Sites& sites);

/// The paper's chain in the sound reading: Eq. 4, the normal of the 7x7 template around its pixel block, and the
/// second-order Taylor step along it. The initial point stays where the template or the kernel leaves the image, the
/// normal is undefined, or the step does not settle; its normal is then that of the centre line.
class TemplateMethod : public MethodBase
{
public:
  TemplateMethod(const StripeParams& params, NormalsOfTemplates normals) : MethodBase(params), normals_(normals) {}

protected:
  void refine(const ImageView& image, Workspace::Scratch& scratch) const override;

private:
  NormalsOfTemplates normals_;
};
}  // namespace weld_profiler
