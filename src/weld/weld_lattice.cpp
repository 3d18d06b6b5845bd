#include "weld_lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "scan_grid.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kMostNodes = 2e7;
constexpr double kLeastMargin = 1.5;  // steps; columns on two lines nearer than this would make slivers

/// Whole columns of a row, counted from q = 0; no node is known yet.
LatticeRow makeRow(const WeldShape& shape, double s, double step, double margin)
{
  LatticeRow row;
  row.toes.s = s;
  if (!shape.toes().has(s))
    return row;
  row.toes = shape.toes().at(s);
  const auto column = [step](double q) { return static_cast<int>(std::lround(q / step)); };
  const double inset = std::min(margin, 0.0);
  row.left = column(row.toes.left - inset);
  row.right = column(row.toes.right + inset);
  row.first = std::min(row.left, column(row.toes.left - margin));
  row.last = std::max(row.right, column(row.toes.right + margin));
  row.valid = row.right - row.left >= 2;
  return row;
}

void requireMemory(double rows, double columns, double step)
{
  if (rows * columns <= kMostNodes)
    return;
  std::ostringstream text;
  text << "mesh_step is " << step << " m, which makes " << rows * columns << " nodes of this weld, must be at most "
       << kMostNodes << ": take a larger step";
  throw ConfigError(text.str());
}

void placeNodes(const WeldShape& shape, double step, double margin, int offset, WeldLattice& lattice)
{
  for (int i = 0; i < lattice.rowCount(); ++i)
  {
    const LatticeRow& row = lattice.rows[static_cast<std::size_t>(i)];
    for (int j = row.first; row.valid && j <= row.last; ++j)
    {
      const double inset = std::min(margin, 0.0);
      double q = (j - offset) * step;
      if (j == row.left)
        q = row.toes.left - inset;
      else if (j == row.right)
        q = row.toes.right + inset;
      else if (j == row.first)
        q = row.toes.left - margin;
      else if (j == row.last)
        q = row.toes.right + margin;
      const Eigen::Vector2d place = shape.frame().at({ q, row.toes.s });
      const std::size_t at = lattice.at(i, j);
      lattice.q[at] = q, lattice.x[at] = place.x(), lattice.y[at] = place.y();
    }
  }
}

/// What grinding can leave at most: no higher than the bead is, no lower than flush.
double leavable(double target, double chord, double bead)
{
  if (std::isnan(bead))
    return target;
  return std::max(std::min(chord, target), std::min(target, bead));
}

void sample(const WeldShape& shape, const LatticeRow& row, int i, WeldLattice& lattice)
{
  for (int j = row.first; j <= row.last; ++j)
  {
    const std::size_t at = lattice.at(i, j);
    const double q = lattice.q[at], s = row.toes.s;
    const bool on_toe = j == row.left || j == row.right;
    const auto height = [](const HeightSample& found) { return found.known ? found.z : kNaN; };
    double target = kNaN;
    if (!row.between(j) || on_toe)
      target = height(shape.targetBeside(s, q));
    if (row.between(j))
    {
      double bead = height(shape.bead(s, q));
      if (std::isfinite(bead) && q == row.toes.left)
        bead = row.toes.z_left;  // the face ends there, by definition; told from one side it would be rough
      else if (std::isfinite(bead) && q == row.toes.right)
        bead = row.toes.z_right;
      const HeightSample between = shape.targetBetween(s, q);
      if (std::isnan(target))
        target = leavable(height(between), row.toes.chord(q), bead);
      lattice.bead[at] = bead;
      const double upright = std::isfinite(bead) && std::isfinite(target) ? std::max(0.0, bead - target) : kNaN;
      lattice.area[at] = steepness(between);
      lattice.to_remove[at] = upright / lattice.area[at];
    }
    lattice.target[at] = target;
  }
}

/// Shares of the nodes between the toes; rows at an end have half a step.
/// @pre  area holds how much larger a piece of the target is than it looks from above.
void shareArea(int i, WeldLattice& lattice)
{
  const LatticeRow& row = lattice.rows[static_cast<std::size_t>(i)];
  const auto usable = [&](int other, int column)
  { return other >= 0 && other < lattice.rowCount() && lattice.rows[static_cast<std::size_t>(other)].uses(column); };
  for (int j = row.left; j <= row.right; ++j)
  {
    const std::size_t at = lattice.at(i, j);
    const double from = lattice.q[at - (j > row.left ? 1 : 0)], to = lattice.q[at + (j < row.right ? 1 : 0)];
    const int before = usable(i - 1, j) ? i - 1 : i, after = usable(i + 1, j) ? i + 1 : i;
    const std::size_t a = lattice.at(before, j), b = lattice.at(after, j);
    // on a bend the inner side is shorter; columns next to a toe are no measure of it, as they jump across
    const bool plain = lattice.q[a] == lattice.q[at] && lattice.q[b] == lattice.q[at] && after > before;
    const double per_row = plain
                               ? std::hypot(lattice.x[b] - lattice.x[a], lattice.y[b] - lattice.y[a]) / (after - before)
                               : lattice.step_s;
    const bool end = i == 0 || i + 1 == lattice.rowCount();
    lattice.area[at] *= 0.5 * (to - from) * per_row * (end ? 0.5 : 1.0);
  }
}
/// Rows from the first toes to the last. @return false when the weld is shorter than a step.
bool makeRows(const WeldShape& shape, double step, double margin, WeldLattice& lattice)
{
  const double from = shape.toes().pairs().front().s, to = shape.toes().pairs().back().s;
  const double steps = std::round((to - from) / step);
  if (steps < 1.0)
    return false;
  requireMemory(steps, 1.0, step);
  lattice.step_s = (to - from) / steps;
  const int count = static_cast<int>(steps) + 1;
  for (int i = 0; i < count; ++i)
    lattice.rows.push_back(makeRow(shape, i + 1 < count ? from + i * lattice.step_s : to, step, margin));
  return true;
}
}  // namespace

WeldLattice makeLattice(const WeldShape& shape, double step, double margin)
{
  WeldLattice lattice;
  if (margin < kLeastMargin * step)
    margin = std::min(margin, 0.0);
  if (!makeRows(shape, step, margin, lattice))
    return WeldLattice();
  int first = std::numeric_limits<int>::max(), last = std::numeric_limits<int>::min();
  for (const LatticeRow& row : lattice.rows)
    if (row.valid)
      first = std::min(first, row.first), last = std::max(last, row.last);
  if (first > last)
    return WeldLattice();
  lattice.columns = last - first + 1;
  requireMemory(lattice.rowCount(), lattice.columns, step);
  for (LatticeRow& row : lattice.rows)
    for (int* column : { &row.first, &row.last, &row.left, &row.right })
      *column -= first;
  const std::size_t nodes = lattice.at(lattice.rowCount(), 0);
  for (auto* field : { &lattice.q, &lattice.x, &lattice.y, &lattice.bead, &lattice.target, &lattice.to_remove })
    field->assign(nodes, kNaN);
  lattice.area.assign(nodes, 0.0);
  placeNodes(shape, step, margin, -first, lattice);
  for (int i = 0; i < lattice.rowCount(); ++i)
  {
    const LatticeRow& row = lattice.rows[static_cast<std::size_t>(i)];
    if (!row.valid)
      continue;
    sample(shape, row, i, lattice);
    shareArea(i, lattice);
  }
  return lattice;
}
}  // namespace weld
}  // namespace weld_profiler
