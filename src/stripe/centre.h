#pragma once

#include <vector>

#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// One column's centre on its way through a method. Coordinates of the view [px], grey levels of the image.
struct Centre
{
  int cell = 0;
  double u = 0.0, v = 0.0;
  double initial_v = 0.0;      ///< where the centroid put it; its pixel block is the nearest pixel
  double initial_sigma = 0.0;  ///< what read_sigma was there; 0 = unknown
  double sigma_column = 0.0;   ///< 1-sigma half width of the stripe down the column
  double background = 0.0;     ///< under the stripe, at v
  double gradient = 0.0;       ///< of the background, per row
  double amplitude = 0.0;      ///< of the top above the background
  double read_sigma = 0.0;     ///< 1-sigma of the centre, down the column, that the background's noise alone explains
  double slope = 0.0;          ///< of the centre line, rows a column
  double normal_u = 0.0, normal_v = 0.0;  ///< unit; (0, 0) = the method defines none, the centre line's is taken
  bool starts_piece = false;              ///< the stripe is torn before this centre
  bool saturated = false;
  bool ambiguous = false;
};
}  // namespace weld_profiler
