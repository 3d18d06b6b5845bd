#include "grinding_lines.h"

#include <algorithm>
#include <cmath>

#include "surface_pose.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kCrestShare = 0.8;   // of the largest height: what lies above it is the crest
constexpr double kCrestReach = 1e-3;  // rows this near make a place of the crest [m]

/// Poses to lines: a place without one ends a line.
class LineMaker
{
public:
  void add(const SurfacePose& pose)
  {
    if (broken_)
      lines_.emplace_back();
    broken_ = false;
    lines_.back().push_back(pose);
  }
  void interrupt() { broken_ = true; }
  std::vector<PoseLine> lines() { return std::move(lines_); }

private:
  std::vector<PoseLine> lines_;
  bool broken_ = true;
};

/// Of each row the middle of the bead's highest fifth, NaN where the row is not known.
std::vector<double> crestPlaces(const WeldLattice& lattice)
{
  std::vector<double> places(lattice.rows.size(), std::nan(""));
  for (int i = 0; i < lattice.rowCount(); ++i)
  {
    const LatticeRow& row = lattice.rows[static_cast<std::size_t>(i)];
    double highest = 0.0, weight = 0.0, sum = 0.0;
    const auto height = [&](int j)
    {
      const std::size_t at = lattice.at(i, j);
      const double z = lattice.bead[at];
      return std::isfinite(z) ? z - row.toes.chord(lattice.q[at]) : 0.0;
    };
    for (int j = row.left; row.valid && j <= row.right; ++j)
      highest = std::max(highest, height(j));
    for (int j = row.left; row.valid && j <= row.right; ++j)
    {
      const double w = std::max(0.0, height(j) - kCrestShare * highest);
      weight += w, sum += w * lattice.q[lattice.at(i, j)];
    }
    if (weight > 0.0)
      places[static_cast<std::size_t>(i)] = sum / weight;
  }
  return places;
}

/// Mean of the rows around s; NaN when the nearest row knows nothing.
double crestAt(const WeldLattice& lattice, const std::vector<double>& places, double s)
{
  const double at = (s - lattice.rows.front().toes.s) / lattice.step_s;
  const int middle = static_cast<int>(std::lround(at)), last = lattice.rowCount() - 1;
  const int reach = std::max(1, static_cast<int>(kCrestReach / lattice.step_s));
  // as far to either side as there are rows: a mean of one side would be about another place
  const int equal = std::min({ reach, middle, last - middle });
  if (middle < 0 || middle > last || std::isnan(places[static_cast<std::size_t>(middle)]))
    return std::nan("");
  double sum = 0.0;
  int count = 0;
  for (int i = middle - equal; i <= middle + equal; ++i)
    if (std::isfinite(places[static_cast<std::size_t>(i)]))
      sum += places[static_cast<std::size_t>(i)], ++count;
  return sum / count;
}
}  // namespace

std::vector<double> placesAlong(const WeldShape& shape, double spacing)
{
  const double from = shape.toes().pairs().front().s, length = shape.toes().pairs().back().s - from;
  const int steps = std::max(1, static_cast<int>(std::ceil(length / spacing - 1e-6)));
  std::vector<double> places;
  for (int i = 0; i <= steps; ++i)
    places.push_back(i < steps ? from + i * length / steps : from + length);
  return places;
}

void addLines(const WeldShape& shape, const WeldLattice& lattice, double point_spacing, GrindingPlan& plan)
{
  LineMaker left, right, crest;
  const std::vector<double> crest_places = crestPlaces(lattice);
  for (const double s : placesAlong(shape, point_spacing))
  {
    const bool known = shape.toes().has(s);
    const ToePair toes = known ? shape.toes().at(s) : ToePair();
    const auto addToe = [&](double q, double z, LineMaker& line)
    {
      const HeightSample slope = known ? shape.targetBetween(s, q) : HeightSample();
      slope.known ? line.add(poseAt(shape.frame(), { q, s }, z, slope)) : line.interrupt();
    };
    addToe(toes.left, toes.z_left, left);
    addToe(toes.right, toes.z_right, right);
    const double q = known ? crestAt(lattice, crest_places, s) : std::nan("");
    const HeightSample top = std::isfinite(q) ? shape.bead(s, q) : HeightSample();
    top.known ? crest.add(poseAt(shape.frame(), { q, s }, top.z, top)) : crest.interrupt();
  }
  plan.toe_left = left.lines();
  plan.toe_right = right.lines();
  plan.crest = crest.lines();
}
}  // namespace weld
}  // namespace weld_profiler
