#pragma once

#include <string>

#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// A stripe as text: `u_px,v_px,normal_rad,intensity,width_px,sigma_px,flags,cell`, a line a centre, header first.
/// Only the header = no stripe. Same stripe -> same bytes, whatever the locale.
std::string stripeCsv(const Stripe& stripe);
}  // namespace weld_profiler
