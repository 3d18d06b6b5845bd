#include "kernel_choice.h"
#include "method.h"

namespace weld_profiler
{
namespace
{
/// C. Steger, "An unbiased detector of curvilinear structures", IEEE PAMI 20(2), 1998 (the paper's reference [11]):
/// normal and step from the Hessian of the Gaussian-smoothed image, here at the pixels of the stripe alone; the values
/// are those of the whole image's convolution. Good for: oblique flanks, brightness that changes along the stripe. Poor
/// for: corners, which its kernel rounds.
class Steger : public MethodBase
{
public:
  using MethodBase::MethodBase;

protected:
  void refine(const ImageView& image, Workspace::Scratch& scratch) const override
  {
    chooseKernel(params(), scratch.centres, scratch.widths, scratch.kernel);
    scratch.sites.clear();
    for (std::size_t i = 0; i < scratch.centres.size(); ++i)
      scratch.sites.push_back(Site{ i, scratch.centres[i].cell, nearestPixel(scratch.centres[i].v) });
    scratch.steps.settle({ image, scratch.kernel, nullptr, scratch.finder.noise() }, scratch.sites, scratch.centres);
  }
};
}  // namespace

std::unique_ptr<const StripeExtractor> makeSteger(const StripeParams& params)
{
  return std::make_unique<Steger>(params);
}
}  // namespace weld_profiler
