#pragma once

#include <vector>

#include "line.h"
#include "section_sampler.h"
#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
namespace weld
{
/// Height of the surface at one place of a section, from a parabola fitted to the points around it.
struct HeightNode
{
  double q = 0.0, z = 0.0;
  double sigma = 0.0;    ///< of z [m]
  double bend = 0.0;     ///< second derivative [1/m]
  double between = 0.0;  ///< part of sigma: what ripples between the rows may lift or lower all around it [m]
  bool lone = false;     ///< most of its points are of one row that lies off the section's plane
};

/// What local fits are made over.
struct HeightSpan
{
  double from = 0.0, to = 0.0;  ///< points outside are not looked at [m]
  double half_window = 3e-4;    ///< of each fit [m]
  double step = 1e-4;           ///< between nodes [m]
  double max_gap = 5e-4;        ///< no node in a longer break [m]
  double energy = 0.0;          ///< variance of a point times the neighbours that share its error [m^2]
  double row_bend = 0.0;        ///< of the face from row to row: what lies between rows errs by it [1/m]
};

/// Local fits from `from` to `to`. Places in a break, or with less than five points around, have no node.
std::vector<HeightNode> localHeights(const SectionProfile& profile, const HeightSpan& span);

/// Without those that the last row before a break tells alone and ripples move: how the face goes on is not theirs to
/// say.
std::vector<HeightNode> withoutGuessed(const std::vector<HeightNode>& nodes, double step);

/// Largest distance of the nodes above a line. Not measured where it lies beside a break, or where the face may rise
/// higher in one: where the courses of both sides meet.
/// @param step  between nodes where there is no break [m].
/// @param rims  so many nodes at either end stand apart from the others without a break.
Quantity largestAbove(const std::vector<HeightNode>& nodes, const Line& line, double step, std::size_t rims = 0);

/// Longest break between neighbouring points in [from, to], its ends included [m].
double longestGap(const SectionProfile& profile, double from, double to);
}  // namespace weld
}  // namespace weld_profiler
