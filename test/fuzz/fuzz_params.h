#pragma once

#include <string>

#include "fuzz/bytes.h"
#include "weld_profiler/stripe/stripe_params.h"

namespace weld_profiler
{
namespace fuzz
{
/// Parameters that mostly validate. Walks over the struct's own visitor, so that a new parameter takes part by itself;
/// of a new choice add the words to fuzz_params.cpp.
StripeParams readParams(Bytes& bytes);
}  // namespace fuzz
}  // namespace weld_profiler
