#pragma once

#include <memory>
#include <string>
#include <vector>

#include "weld_profiler/stripe/stripe_extractor.h"
#include "weld_profiler/stripe/stripe_params.h"

namespace weld_profiler
{
/// Names of all registered methods, in the order of the table.
std::vector<std::string> stripeMethods();

/// Builds the method that params.method names.
/// @throws ConfigError for an unknown name (listing the known ones) or params that do not validate.
std::unique_ptr<const StripeExtractor> makeStripeExtractor(const StripeParams& params);
}  // namespace weld_profiler
