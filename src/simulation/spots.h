#pragma once

#include <functional>
#include <vector>

#include "simulation/bead.h"
#include "simulation/cell_grid.h"
#include "weld_profiler/simulation/weld_truth.h"

namespace weld_profiler
{
namespace simulation
{
/// Balls of spatter and open pores at seeded places, in part coordinates.
class Spots
{
public:
  /// @param blocked  a block stands at (x, y): nothing sticks there.
  Spots(const SceneParams& scene, const Bead& bead, const CellGrid& grid,
        const std::function<bool(double, double)>& blocked);

  /// A surface of height z at (x, y), with the spots of the cell that (x, y) lies in.
  double apply(int cell, double x, double y, double z) const;

  /// Part coordinates.
  const std::vector<TrueSpot>& all() const { return all_; }

private:
  struct Ball
  {
    double x, y, z, radius;
  };
  struct Pit
  {
    double x, y, reach;  ///< reach: half its diameter
    double radius;       ///< of the sphere
    double drop;         ///< of the sphere's centre above the surface around
  };

  void placeBalls(const SceneParams& scene, const std::function<bool(double, double)>& blocked);
  void placePores(const SceneParams& scene);
  bool addPore(const PathPoint& place, double diameter, double depth);
  template <class Spot>
  void enlist(const Spot& spot, double reach, std::vector<std::vector<Spot>>& lists) const;

  CellGrid grid_;
  const Bead& bead_;
  std::vector<std::vector<Ball>> balls_;  ///< a list for each cell
  std::vector<std::vector<Pit>> pits_;
  std::vector<TrueSpot> all_;
};
}  // namespace simulation
}  // namespace weld_profiler
