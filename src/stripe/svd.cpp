#include "literal_reading.h"
#include "template_method.h"

namespace weld_profiler
{
/// The paper: normal from the singular value decomposition of the 49x3 template matrix. See svdNormal, TemplateMethod.
std::unique_ptr<const StripeExtractor> makeSvd(const StripeParams& params)
{
  if (params.taylor == "literal")
    return std::make_unique<LiteralReading>(params, svdNormal);
  return std::make_unique<TemplateMethod>(params, &SiteNormals::measureSvd);
}
}  // namespace weld_profiler
