#pragma once

#include <cstdint>
#include <vector>

#include "scan_grid.h"

namespace weld_profiler
{
namespace weld
{
/// A triangle between points of a ScanGrid, as indices of it.
struct Facet
{
  std::uint32_t a = 0, b = 0, c = 0;
};

/// The surface between the points of neighbouring rows. No facet reaches over a break longer than max_gap, or than the
/// rows' own distance; facets that lean over backwards are left out.
std::vector<Facet> makeFacets(const ScanGrid& grid, double max_gap);

/// Twice the facet's area seen from above [m^2]; > 0.
double doubledArea(const ScanGrid& grid, const Facet& facet);
}  // namespace weld
}  // namespace weld_profiler
