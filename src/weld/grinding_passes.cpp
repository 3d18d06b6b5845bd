#include "grinding_passes.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "grinding_lanes.h"
#include "grinding_lines.h"
#include "surface_pose.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kMostLayers = 500.0;
constexpr double kAlmostAll = 0.97;  // of the volume; with less the plan says so
constexpr double kLeastKnown = 0.7;  // of a lane's share at a place; with less the tool would go into the unknown

/// A place of a lane, and what is to be done there.
struct Station
{
  bool passable = false;
  bool work = false;
  GrindingPoint point;
};

/// What the lattice knows around one place of a lane.
struct Share
{
  int nodes = 0, known = 0;
  double removal = 0.0, volume = 0.0;
};

/// The passes of one layer.
class LayerPlanner
{
public:
  LayerPlanner(const WeldShape& shape, const WeldLattice& lattice, const GrindingParams& params, const Layer& layer)
    : shape_(shape),
      lattice_(lattice),
      params_(params),
      layer_(layer),
      lanes_(lattice, layer, params),
      places_(placesAlong(shape, params.point_spacing))
  {
    shares_.resize(places_.size() * static_cast<std::size_t>(lanes_.count()));
    if (lanes_.count() > 0)
      share();
  }

  void operator()(std::vector<GrindingPass>& passes) const
  {
    for (int lane = 0; lane < lanes_.count(); ++lane)
    {
      std::vector<GrindingPass> of_lane = passesOf(lane);
      if (params_.order == "alternate" && lane % 2 == 1)
        reverse(of_lane);
      passes.insert(passes.end(), of_lane.begin(), of_lane.end());
    }
  }

private:
  std::size_t at(std::size_t place, int lane) const
  {
    return place * static_cast<std::size_t>(lanes_.count()) + static_cast<std::size_t>(lane);
  }

  /// Every node of the lattice to the place and lane that it is nearest to.
  void share()
  {
    const double step = places_.size() > 1 ? places_[1] - places_[0] : params_.point_spacing;
    for (int i = 0; i < lattice_.rowCount(); ++i)
    {
      const LatticeRow& row = lattice_.rows[static_cast<std::size_t>(i)];
      const auto place = static_cast<std::size_t>(std::lround((row.toes.s - places_.front()) / step));
      for (int j = row.left; row.valid && j <= row.right; ++j)
      {
        const std::size_t node = lattice_.at(i, j);
        Share& share = shares_[at(std::min(place, places_.size() - 1), lanes_.laneOf(row.toes, lattice_.q[node]))];
        ++share.nodes;
        if (!std::isfinite(lattice_.to_remove[node]))
          continue;
        const double removal = layer_.of(lattice_.to_remove[node]);
        ++share.known;
        share.removal = std::max(share.removal, removal);
        share.volume += removal * lattice_.area[node];
      }
    }
  }

  Station stationAt(std::size_t place, int lane) const
  {
    Station station;
    const double s = places_[place];
    const Share& share = shares_[at(place, lane)];
    if (!shape_.toes().has(s) || share.known < kLeastKnown * share.nodes)
      return station;
    const ToePair toes = shape_.toes().at(s);
    if (!lanes_.fits(toes))
      return station;
    const double q = lanes_.middle(toes, lane);
    const HeightSample target = shape_.targetBetween(s, q);
    if (!target.known || !shape_.bead(s, q).known)
      return station;
    station.passable = true;
    station.work = share.removal > params_.min_removal;
    station.point.pose = poseAt(shape_.frame(), { q, s }, target.z + layer_.level * steepness(target), target);
    station.point.removal = share.removal;
    station.point.volume = share.volume;
    return station;
  }

  std::vector<GrindingPass> passesOf(int lane) const
  {
    std::vector<Station> stations;
    for (std::size_t place = 0; place < places_.size(); ++place)
      stations.push_back(stationAt(place, lane));
    std::vector<GrindingPass> passes;
    for (std::size_t i = 0; i < stations.size(); ++i)
    {
      if (!stations[i].work)
        continue;
      std::size_t first = i, last = lastOf(stations, i);
      i = last;
      if (first == last && first > 0 && stations[first - 1].passable)  // a tool travels, it does not stand
        --first;
      if (first == last && last + 1 < stations.size() && stations[last + 1].passable)
        ++last;
      if (first == last)
        continue;  // no room to travel
      passes.push_back(passOf(stations, first, last));
      passes.back().lane = lane;
    }
    return passes;
  }

  /// Where a pass that begins at a place ends: with the last work before a hole or a long stretch without work.
  std::size_t lastOf(const std::vector<Station>& stations, std::size_t first) const
  {
    std::size_t last = first;
    for (std::size_t i = first + 1; i < stations.size() && stations[i].passable; ++i)
    {
      if (!stations[i].work)
        continue;
      if (i > last + 1 && places_[i] - places_[last] > params_.bridge_length)
        break;
      last = i;
    }
    return last;
  }

  GrindingPass passOf(const std::vector<Station>& stations, std::size_t first, std::size_t last) const
  {
    GrindingPass pass;
    pass.layer = layer_.index;
    for (std::size_t i = first; i <= last; ++i)
      pass.points.push_back(stations[i].point);
    pass.approach = lifted(pass.points.front().pose, params_.approach_height);
    pass.retract = lifted(pass.points.back().pose, params_.approach_height);
    return pass;
  }

  static void reverse(std::vector<GrindingPass>& passes)
  {
    std::reverse(passes.begin(), passes.end());
    for (GrindingPass& pass : passes)
    {
      std::reverse(pass.points.begin(), pass.points.end());
      std::swap(pass.approach, pass.retract);
      pass.approach = reversed(pass.approach);
      pass.retract = reversed(pass.retract);
      for (GrindingPoint& point : pass.points)
        point.pose = reversed(point.pose);
    }
  }

  const WeldShape& shape_;
  const WeldLattice& lattice_;
  const GrindingParams& params_;
  Layer layer_;
  Lanes lanes_;
  std::vector<double> places_;
  std::vector<Share> shares_;  ///< places x lanes
};
/// Of the face, the widest there is.
double widestFace(const WeldShape& shape)
{
  double widest = 0.0;
  for (const ToePair& toes : shape.toes().pairs())
    widest = std::max(widest, std::hypot(toes.width(), toes.z_right - toes.z_left));
  return widest;
}

/// What the passes do not remove, and why; empty when it is next to nothing.
std::string leftOver(const WeldShape& shape, const GrindingParams& params, const GrindingPlan& plan)
{
  if (plan.planned_volume >= kAlmostAll * plan.removal_volume)
    return "";
  std::ostringstream text;
  const double widest = widestFace(shape);
  if (shape.corner() && widest < params.tool_width)
    text << "tool_width " << 1e3 * params.tool_width << " mm is more than the face between the parents ("
         << 1e3 * widest << " mm): the tool would cut into them, take a narrower one";
  else
    text << "the passes remove " << std::lround(100.0 * plan.planned_volume / plan.removal_volume)
         << " % of what stands above the target: the rest lies beside holes in the data"
         << (shape.corner() ? " or where the tool does not fit between the parents" : "");
  return text.str();
}
}  // namespace

void addPasses(const WeldShape& shape, const WeldLattice& lattice, const GrindingParams& params, GrindingPlan& plan)
{
  double highest = 0.0;
  for (std::size_t i = 0; i < lattice.to_remove.size(); ++i)
  {
    if (!std::isfinite(lattice.to_remove[i]))
      continue;
    highest = std::max(highest, lattice.to_remove[i]);
    plan.removal_volume += lattice.to_remove[i] * lattice.area[i];
  }
  std::ostringstream reason;
  const double layers = std::ceil(highest / params.depth_per_pass - 1e-9);
  if (!(highest > params.min_removal))
    reason << "nothing stands more than min_removal (" << 1e3 * params.min_removal << " mm) above the target";
  else if (layers > kMostLayers)
    reason << "depth_per_pass " << 1e3 * params.depth_per_pass << " mm makes " << layers << " layers of "
           << 1e3 * highest << " mm, must be at most " << kMostLayers;
  plan.reason = reason.str();
  if (!plan.reason.empty())
    return;
  plan.layers = static_cast<int>(layers);
  for (int k = 0; k < plan.layers; ++k)
  {
    const Layer layer{ k, (plan.layers - 1 - k) * params.depth_per_pass, params.depth_per_pass, shape.corner() };
    LayerPlanner(shape, lattice, params, layer)(plan.passes);
  }
  for (const GrindingPass& pass : plan.passes)
    for (const GrindingPoint& point : pass.points)
      plan.planned_volume += point.volume;
  plan.reason = leftOver(shape, params, plan);
}
}  // namespace weld
}  // namespace weld_profiler
