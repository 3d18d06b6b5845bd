#include "template_method.h"

#include "kernel_choice.h"
#include "template_normal.h"

namespace weld_profiler
{
void TemplateMethod::refine(const ImageView& image, Workspace::Scratch& scratch) const
{
  chooseKernel(params(), scratch.centres, scratch.widths, scratch.kernel);
  scratch.sites.clear();
  for (std::size_t i = 0; i < scratch.centres.size(); ++i)
  {
    const Block block{ scratch.centres[i].cell, nearestPixel(scratch.centres[i].v) };
    if (holdsTemplate(image, block))
      scratch.sites.push_back(Site{ i, block.u, block.v });
  }
  (scratch.normals.*normals_)(image, levelsOf(image, params()), scratch.sites);
  scratch.steps.settle({ image, scratch.kernel, &scratch.normals, scratch.finder.noise() }, scratch.sites,
                       scratch.centres);
}
}  // namespace weld_profiler
