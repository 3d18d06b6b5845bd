#pragma once

#include <string>
#include <vector>

namespace weld_profiler
{
/// Everything stripe extraction can be told. Immutable once a StripeStage is built from it.
/// Counts [DN8] are grey levels of an 8-bit image; for 16-bit images they scale with the saturation level / 255.
struct StripeParams
{
  std::string method = "ridge";       ///< one of stripeMethods()
  std::string direction = "auto";     ///< auto (told from the image), u (along the rows), v (along the columns)
  std::string channel = "red";        ///< of colour and Bayer images: red, green, blue, max, luminance
  int roi_x = 0;                      ///< left edge of the region looked at [px]
  int roi_y = 0;                      ///< upper edge [px]
  int roi_width = 0;                  ///< [px], 0 = to the image's edge
  int roi_height = 0;                 ///< [px], 0 = to the image's edge
  double min_stripe_width_px = 0.5;   ///< narrowest stripe accepted, 1-sigma half width [px]
  double max_stripe_width_px = 12.0;  ///< widest stripe accepted, 1-sigma half width [px]
  double min_peak_counts = 6.0;       ///< weakest peak accepted, above background [DN8], 1..255
  double saturation_level = 0.0;      ///< grey level at which pixels clip; 0 = the container's largest value
  int median_size_px = 3;             ///< median filter of the literal reading alone: 0 = off, 3, 5
  double hessian_sigma_px = 0.0;      ///< Gaussian of the derivatives, 0.5..20 [px]; 0 = 1.155 times the stripe's width
  std::string derivatives = "gaussian";  ///< of svd and pca: gaussian, sobel (the paper)
  std::string taylor = "sound";          ///< sound: expanded where the derivatives are taken; literal: the paper's text
  int max_aperture_px = 27;              ///< of ridge: columns that one centre may be measured over: 3, 9, 27 [px]
  std::string fit = "maximum_likelihood";  ///< of gauss_fit: maximum_likelihood (read and shot noise), least_squares
  int max_gap_px = 20;                     ///< longest break repaired by a spline [px]; 0 = repair nothing
  int edge_trim_px = 4;                    ///< cells at the image's edges never interpolated [px]

  /// @throws ConfigError naming field, value and range.
  void validate() const;

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("method", method);
    v("direction", direction);
    v("channel", channel);
    v("roi_x", roi_x);
    v("roi_y", roi_y);
    v("roi_width", roi_width);
    v("roi_height", roi_height);
    v("min_stripe_width_px", min_stripe_width_px);
    v("max_stripe_width_px", max_stripe_width_px);
    v("min_peak_counts", min_peak_counts);
    v("saturation_level", saturation_level);
    v("median_size_px", median_size_px);
    v("hessian_sigma_px", hessian_sigma_px);
    v("derivatives", derivatives);
    v("taylor", taylor);
    v("max_aperture_px", max_aperture_px);
    v("fit", fit);
    v("max_gap_px", max_gap_px);
    v("edge_trim_px", edge_trim_px);
  }
};
}  // namespace weld_profiler
