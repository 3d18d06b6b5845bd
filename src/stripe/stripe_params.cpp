#include "weld_profiler/stripe/stripe_params.h"

#include "weld_profiler/core/errors.h"
#include "weld_profiler/stripe/stripe_methods.h"

namespace weld_profiler
{
namespace
{
constexpr int kLargestImage = 65535;  ///< a cell is 16 bit

using Names = std::vector<std::string>;
}  // namespace

void StripeParams::validate() const
{
  requireOneOf("stripe/method", method, stripeMethods());
  requireOneOf("stripe/direction", direction, Names{ "auto", "u", "v" });
  requireOneOf("stripe/channel", channel, Names{ "red", "green", "blue", "max", "luminance" });
  requireRange("stripe/roi_x", roi_x, 0, kLargestImage, "px");
  requireRange("stripe/roi_y", roi_y, 0, kLargestImage, "px");
  requireRange("stripe/roi_width", roi_width, 0, kLargestImage, "px");
  requireRange("stripe/roi_height", roi_height, 0, kLargestImage, "px");
  requireRange("stripe/max_stripe_width_px", max_stripe_width_px, 0.5, 50.0, "px");
  requireRange("stripe/min_stripe_width_px", min_stripe_width_px, 0.0, max_stripe_width_px, "px");
  requireRange("stripe/min_peak_counts", min_peak_counts, 1.0, 255.0);
  requireRange("stripe/saturation_level", saturation_level, 0.0, 65535.0);
  if (median_size_px != 0 && median_size_px != 3 && median_size_px != 5)
    throw ConfigError("stripe/median_size_px is " + std::to_string(median_size_px) + ", must be one of: 0, 3, 5");
  if (hessian_sigma_px != 0.0)  // told from the stripe
    requireRange("stripe/hessian_sigma_px (or 0)", hessian_sigma_px, 0.5, 20.0, "px");
  requireOneOf("stripe/derivatives", derivatives, Names{ "gaussian", "sobel" });
  requireOneOf("stripe/taylor", taylor, Names{ "sound", "literal" });
  if (max_aperture_px != 3 && max_aperture_px != 9 && max_aperture_px != 27)
    throw ConfigError("stripe/max_aperture_px is " + std::to_string(max_aperture_px) + ", must be one of: 3, 9, 27");
  requireOneOf("stripe/fit", fit, Names{ "maximum_likelihood", "least_squares" });
  requireRange("stripe/max_gap_px", max_gap_px, 0, 1000, "px");
  requireRange("stripe/edge_trim_px", edge_trim_px, 0, 1000, "px");
}
}  // namespace weld_profiler
