#pragma once

#include <string>

#include "support/render_stripe.h"
#include "weld_profiler/stripe/stripe_methods.h"
#include "weld_profiler/stripe/stripe_stage.h"

namespace weld_profiler
{
namespace test_support
{
inline StripeParams paramsOf(const std::string& method, const std::string& direction = "u")
{
  StripeParams params;
  params.method = method;
  params.direction = direction;
  return params;
}

/// One frame through a fresh stage and workspace.
inline Stripe extract(const StripeParams& params, const RawImage& image)
{
  Workspace workspace;
  Stripe stripe;
  StripeStage(params).process(image, workspace, stripe);
  return stripe;
}

inline Stripe extract(const StripeParams& params, const Picture& picture)
{
  return extract(params, picture.raw());
}
}  // namespace test_support
}  // namespace weld_profiler
