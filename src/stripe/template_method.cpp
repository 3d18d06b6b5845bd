#include "template_method.h"

#include <cmath>

#include "kernel_choice.h"
#include "taylor_step.h"

namespace weld_profiler
{
void TemplateMethod::refine(const ImageView& image, Workspace::Scratch& scratch) const
{
  chooseKernel(params(), scratch.centres, scratch.widths, scratch.kernel);
  for (Centre& centre : scratch.centres)
  {
    const int block = static_cast<int>(std::lround(centre.v));
    if (!holdsTemplate(image, centre.cell, block))
      continue;
    const TemplateNormal normal = normal_(image, centre.cell, block);
    if (normal.defined)
      stepToCentre(image, scratch.kernel, &normal, scratch.statistics.noise, centre);
  }
}
}  // namespace weld_profiler
