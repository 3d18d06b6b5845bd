#pragma once

#include "pixels.h"

namespace weld_profiler
{
/// Direction across the stripe as one template tells it.
struct TemplateNormal
{
  bool defined = false;     ///< false: `normal undefined`, u and v are 0
  double u = 0.0, v = 0.0;  ///< unit; of the two opposite ones that with v > 0, or v = 0 and u > 0
};

/// The pixel that a template is laid on.
struct Block
{
  int u = 0, v = 0;
};

constexpr int kTemplateSize = 7;  ///< the template is 7x7 pixels
constexpr int kTemplateReach = kTemplateSize / 2;
constexpr double kTemplateCoordinates = 392.0;  ///< sum(x^2 + y^2) over it
constexpr double kLeastMoment = 1e-6;           ///< |(a, b)| over |P|^2 that defines svdNormal()
constexpr double kLeastAnisotropy = 1e-9;  ///< difference of the eigenvalues over their sum that defines pcaNormal()

/// Whether the template around a pixel block lies inside the image.
bool holdsTemplate(const ImageView& image, const Block& block);

/// The paper's normal, Eqs. 5-9: the 49x3 matrix P = (x, y, gray) of the template around the block, x and y counted
/// from the block; the right singular vector of its smallest singular value, projected to the image plane.
///
/// With that origin P'P = [[196, 0, a], [0, 196, b], [a, b, c]], a = sum(x I), b = sum(y I), and the projection of its
/// smallest eigenvector is exactly parallel to (a, b): the first moment of the template. So it is computed. It is
/// ill-posed where the stripe runs through the middle of the block (any direction at an offset of 0), hence `defined`
/// only where
/// |(a, b)| > 1e-6 |P|^2. Poor for: a normal anyone relies on; 10 to 18 deg RMS at a peak 50 times its noise.
/// Gray is counted in levels of 8 bit, as in the paper: for a deeper image `defined` would else mean something else.
/// @param block  one whose template lies inside the image.
TemplateNormal svdNormal(const ImageView& image, const Levels& levels, const Block& block);

/// The paper's reference [16], Eq. 2: the covariance of the template's coordinates, weighted by gray; the eigenvector
/// of its smallest eigenvalue. Undefined where the eigenvalues differ by less than 1e-9 of their sum. Poor for: stripes
/// wider than the template, whose square shape then pulls the normal toward 0 and 45 deg.
TemplateNormal pcaNormal(const ImageView& image, const Levels& levels, const Block& block);
}  // namespace weld_profiler
