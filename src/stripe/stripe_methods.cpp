#include "weld_profiler/stripe/stripe_methods.h"

#include "method.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
struct MethodEntry
{
  const char* name;
  std::unique_ptr<const StripeExtractor> (*make)(const StripeParams&);
};

/// The one table: a method that stands here can be chosen by name, and is under the contract tests.
const MethodEntry kMethods[] = {
  { "ridge", makeRidge },
  { "gray_centroid", makeGrayCentroid },
  { "squared_centroid", makeSquaredCentroid },
  { "svd", makeSvd },
  { "pca", makePca },
  { "steger", makeSteger },
  { "gauss_fit", makeGaussFit },
  { "fir_peak", makeFirPeak },
  { "log_parabola", makeLogParabola },
};
}  // namespace

std::vector<std::string> stripeMethods()
{
  std::vector<std::string> names;
  for (const MethodEntry& entry : kMethods)
    names.emplace_back(entry.name);
  return names;
}

std::unique_ptr<const StripeExtractor> makeStripeExtractor(const StripeParams& params)
{
  params.validate();
  for (const MethodEntry& entry : kMethods)
    if (params.method == entry.name)
      return entry.make(params);
  throw ConfigError("stripe/method is '" + params.method + "', which is not in the table of methods");
}
}  // namespace weld_profiler
