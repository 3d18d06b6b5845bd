#pragma once

#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
/// A small thing on the surface: a pore that is open to it (ISO 6520-1 no. 2017) or spatter (602).
struct WeldSpot
{
  enum class Kind
  {
    Pore,
    Spatter
  };
  Kind kind = Kind::Spatter;
  double x = 0.0, y = 0.0, z = 0.0;  ///< its middle in the cloud's frame [m]
  double s = 0.0;                    ///< along the weld's path [m]
  Quantity diameter;                 ///< of a circle of its area [m]
  Quantity height;                   ///< above (below: < 0) the surface around it [m]
};

/// Diameters of the largest pores that the face may have without one being told: in a quarter of it ripples, noise and
/// the distance of the rows would hide them [m].
struct UnseenPores
{
  double round = 0.0;    ///< half as deep as wide
  double shallow = 0.0;  ///< a quarter as deep as wide
};
}  // namespace weld_profiler
