#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "weld_profiler/core/image.h"

namespace weld_profiler
{
namespace test_support
{
/// An ideal stripe, rendered on its own: Gaussian (or another profile) across its own normal, integrated over nothing,
/// sampled at pixel centres.
struct StripePicture
{
  int width = 320;
  int height = 120;
  double sigma = 2.0;       ///< 1-sigma half width across the stripe [px]
  double peak = 200.0;      ///< above background [DN]
  double background = 8.0;  ///< [DN]
  double snr = 0.0;         ///< peak over its noise, half read and half shot in variance; 0 = no noise
  double read_noise = 0.0;  ///< [DN]; above 0, it and shot_gain stand in for snr
  double shot_gain = 0.0;   ///< variance of the shot noise over the light [DN]
  double speckle = 0.0;     ///< contrast along the stripe, grain about 2 px
  double grain_px = 0.0;    ///< FWHM of the speckle's autocorrelation, as light makes it; 0 = noise smoothed over 3x3
  unsigned seed = 1;
  int bit_depth = 8;
  std::function<double(double)> row;              ///< the centre line: row at column u
  std::function<double(double)> slope;            ///< its derivative; empty = numerically
  std::function<double(double)> gain;             ///< brightness along the stripe; empty = 1
  std::function<double(double)> sigma_at;         ///< sigma at column u of the centre line; empty = sigma everywhere
  std::function<double(double)> profile;          ///< light at a signed distance, 1 at its peak; empty = Gaussian
  std::function<double(double, double)> ambient;  ///< added light at (u, v), without shot noise; empty = none
  std::vector<double> more_light;                 ///< added light with shot noise, row after row; empty = none [DN]
  double clip = 255.0;                            ///< full scale [DN8]
};

/// Pixels that own themselves.
struct Picture
{
  int width = 0, height = 0, bit_depth = 8;
  std::vector<std::uint8_t> bytes;

  ImageView view() const;
  RawImage raw() const;  ///< mono8 or mono16
  double at(int u, int v) const;
  void set(int u, int v, double value);
};

/// The stripe's own light without background, speckle or noise, row after row. [DN]
std::vector<double> lightOf(const StripePicture& stripe);

Picture blank(int width, int height, double value = 0.0, int bit_depth = 8);
Picture render(const StripePicture& stripe);
/// Another exposure of the same light, which lightOf() gave.
Picture render(const StripePicture& stripe, const std::vector<double>& light);
Picture transposed(const Picture& picture);

/// A line at an angle through the middle of the picture, its offset at column 0.
StripePicture straight(double degrees, double row_at_zero);

/// The signed distance of (u, v) from the centre line, across it. [px]
double distanceAcross(const StripePicture& stripe, double u, double v);
}  // namespace test_support
}  // namespace weld_profiler
