#include "literal_reading.h"
#include "template_method.h"

namespace weld_profiler
{
/// The paper's reference [16]: normal from the covariance of the template. See pcaNormal, TemplateMethod.
std::unique_ptr<const StripeExtractor> makePca(const StripeParams& params)
{
  if (params.taylor == "literal")
    return std::make_unique<LiteralReading>(params, pcaNormal);
  return std::make_unique<TemplateMethod>(params, &SiteNormals::measurePca);
}
}  // namespace weld_profiler
