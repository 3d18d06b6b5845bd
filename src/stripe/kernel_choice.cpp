#include "kernel_choice.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace
{
constexpr double kKernelPerWidth = 1.155;  ///< 2 / sqrt(3): Steger's sigma >= w / sqrt(3), w half the width of 4 sigma
constexpr double kStep = 0.25;      ///< the kernel's sigma is rounded, so that it is the same from frame to frame [px]
constexpr double kNarrowest = 1.0;  ///< a narrower Gaussian is not sampled well enough [px]
constexpr double kWidest = 20.0;
}  // namespace

void chooseKernel(const StripeParams& params, const std::vector<Centre>& centres, std::vector<double>& widths,
                  DerivativeKernel& kernel)
{
  if (params.derivatives == "sobel" && params.method != "steger")
  {
    kernel.setSobel(DerivativeKernel::Sobel::Scaled);
    return;
  }
  double sigma = params.hessian_sigma_px;
  if (sigma == 0.0)
  {
    widths.clear();
    for (const Centre& centre : centres)
      widths.push_back(centre.sigma_column / std::sqrt(1.0 + centre.slope * centre.slope));
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    const double ideal = kKernelPerWidth * (widths.empty() ? kNarrowest : *middle);
    sigma = std::clamp(kStep * std::round(ideal / kStep), kNarrowest, kWidest);
  }
  kernel.setGaussian(sigma);
}
}  // namespace weld_profiler
