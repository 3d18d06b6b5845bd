#pragma once

#include <vector>

#include "weld_lattice.h"
#include "weld_profiler/weld/grinding.h"

namespace weld_profiler
{
namespace weld
{
/// A layer of removal: what stands above the target by more than `level`, at most `depth` of it.
struct Layer
{
  int index = 0;        ///< from 0 = the uppermost
  double level = 0.0;   ///< of what is left, above the target [m]
  double depth = 0.0;   ///< [m]
  bool corner = false;  ///< the parents rise beside the toes: lanes stay between these

  double of(double to_remove) const
  {
    const double above = to_remove - level;
    return above < 0.0 ? 0.0 : (above > depth ? depth : above);
  }
};

/// Where the lanes of a layer lie: side by side, as shares of the width between the toes, so that they follow these.
class Lanes
{
public:
  /// Lanes over all of the layer's material; in the last layer over the whole bead and, unless in a corner, the margin.
  Lanes(const WeldLattice& lattice, const Layer& layer, const GrindingParams& params);

  int count() const { return count_; }

  /// Whether the tool has room there; in a corner it must not be wider than the face.
  bool fits(const ToePair& toes) const;

  /// Middle of a lane.
  double middle(const ToePair& toes, int lane) const;

  /// Lane whose share of the work a place is.
  int laneOf(const ToePair& toes, double q) const;

private:
  struct Span
  {
    double from = 0.0, step = 0.0;  ///< middles of the first lane and between lanes
  };
  Span span(const ToePair& toes) const;

  double left_ = 0.0, right_ = 0.0;  ///< of the material, shares of the width: 0 = left toe, 1 = right toe
  double margin_ = 0.0, half_tool_ = 0.0;
  bool corner_ = false;
  int count_ = 0;
};
}  // namespace weld
}  // namespace weld_profiler
