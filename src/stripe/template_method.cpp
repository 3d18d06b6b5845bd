#include "template_method.h"

#include <cmath>

#include "kernel_choice.h"
#include "taylor_step.h"

namespace weld_profiler
{
void TemplateMethod::refine(const ImageView& image, Workspace::Scratch& scratch) const
{
  chooseKernel(params(), scratch.centres, scratch.widths, scratch.kernel);
  const Levels levels = levelsOf(image, params());
  for (Centre& centre : scratch.centres)
  {
    const Block block{ centre.cell, static_cast<int>(std::lround(centre.v)) };
    if (!holdsTemplate(image, block))
      continue;
    const TemplateNormal normal = normal_(image, levels, block);
    if (normal.defined)
      stepToCentre(image, scratch.kernel, &normal, scratch.statistics.noise, centre);
  }
}
}  // namespace weld_profiler
