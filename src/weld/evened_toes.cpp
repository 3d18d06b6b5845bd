#include "evened_toes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "face_window.h"
#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kApart = 4e-4;       // toes are compared at this distance: half of the shortest ripples' pitch [m]
constexpr double kRestless = 3e-5;    // scatter that moves toes 0.5 mm outside of their faces inward by 2 um [m]
constexpr double kReach = 2.5e-3;     // half width that is evened out over: of a wave of 4 mm a tenth is left [m]
constexpr double kStep = 5e-4;        // from one evened out face to the next [m]
constexpr double kBetween = 1.25e-3;  // a section this near to others on both sides that show the toe has it, too [m]
constexpr double kCell = 4e-5;        // that heights are averaged in [m]
constexpr double kOutside = 3e-3;     // of the toe that the outline is averaged for [m]
constexpr std::size_t kFewest = 5;    // sections in a mean
constexpr std::size_t kInner = 2;     // means from one to another that tells how toes change
constexpr double kShareSeen = 0.3;    // of the sections, that show a place
constexpr double kWhole = 0.6;        // of the window on either side, that the weld must fill
constexpr double kShareFound = 0.5;   // of the sections that show the toe: of fewer it is not known to be one
constexpr double kFlat = 0.5;   // a face steeper than this meets its parent in one place whatever its ripples [rad]
constexpr double kAlike = 1.5;  // neighbouring sections share a row: this many count as one

ToeFit& toeOf(SectionShape& shape, Side side)
{
  return side == Side::Left ? shape.toe_left : shape.toe_right;
}

/// Heights above the parent line, averaged in cells across the weld.
class MeanOutline
{
public:
  explicit MeanOutline(const ToeQuestion& question)
  {
    const double middle = 0.5 * (question.guess + question.opposite);
    const double outside = question.guess + sign(question.side) * kOutside;
    from_ = std::min(middle, outside), to_ = std::max(middle, outside);
    cells_.resize(static_cast<std::size_t>(std::ceil((to_ - from_) / kCell)) + 1);
  }

  void add(const SectionProfile& profile, const Line& parent, double weight)
  {
    auto i = static_cast<std::size_t>(std::lower_bound(profile.q.begin(), profile.q.end(), from_) - profile.q.begin());
    for (; i < profile.size() && profile.q[i] < to_; ++i)
    {
      if (profile.q[i] < from_)
        continue;
      Cell& cell = cells_[static_cast<std::size_t>((profile.q[i] - from_) / kCell)];
      cell.weight += weight;
      cell.q += weight * profile.q[i];
      cell.above += weight * (profile.z[i] - parent.at(profile.q[i]));
    }
  }

  /// The outline over a parent line, where as much was seen.
  SectionProfile above(const Line& parent, double least) const
  {
    SectionProfile profile;
    for (const Cell& cell : cells_)
    {
      if (!(cell.weight > least))
        continue;
      profile.q.push_back(cell.q / cell.weight);
      profile.z.push_back(parent.at(profile.q.back()) + cell.above / cell.weight);
    }
    return profile;
  }

private:
  struct Cell
  {
    double weight = 0.0, q = 0.0, above = 0.0;
  };
  double from_ = 0.0, to_ = 0.0;
  std::vector<Cell> cells_;
};

class Evening
{
public:
  Evening(const ToesAlong& along, const WeldParams& params, std::vector<SectionShape>& shapes)
    : along_(along), params_(params), shapes_(shapes)
  {
  }

  void operator()()
  {
    if (!restless())
      return;
    chooseSections();
    for (double s = along_.places.front(); s < along_.places.back(); s += kStep)
      addNode(s);
    if (nodes_.empty())
      return;
    for (std::size_t k = 0; k < shapes_.size(); ++k)
      settle(k);
  }

private:
  struct Node
  {
    double s = 0.0;
    ToeFit toe;
  };

  /// Whether the toes scatter along the weld by more than a line through their faces can be trusted with.
  bool restless() const
  {
    std::vector<double> differences;
    std::size_t j = 0;
    for (std::size_t k = 0; k < shapes_.size(); ++k)
    {
      while (j < k && along_.places[k] - along_.places[j + 1] >= kApart)
        ++j;
      const ToeFit& toe = shapes_[k].toe(along_.side);
      const ToeFit& before = shapes_[j].toe(along_.side);
      if (toe.found && before.found && along_.places[k] - along_.places[j] >= kApart)
        differences.push_back((toe.q - before.q) * std::sqrt(0.5));
    }
    return robustSigma(std::move(differences)) > kRestless;
  }

  /// Sections that show the toe, or lie between such.
  void chooseSections()
  {
    const std::size_t count = shapes_.size();
    std::vector<double> since(count), until(count);
    double last = -INFINITY;
    for (std::size_t k = 0; k < count; ++k)
    {
      last = shapes_[k].toe(along_.side).found ? along_.places[k] : last;
      since[k] = along_.places[k] - last;
    }
    last = INFINITY;
    for (std::size_t k = count; k-- > 0;)
    {
      last = shapes_[k].toe(along_.side).found ? along_.places[k] : last;
      until[k] = last - along_.places[k];
    }
    for (std::size_t k = 0; k < count; ++k)
      chosen_.push_back(shapes_[k].parent(along_.side).valid() && std::max(since[k], until[k]) < kBetween);
  }

  void addNode(double s)
  {
    const auto from = static_cast<std::size_t>(
        std::lower_bound(along_.places.begin(), along_.places.end(), s - kReach) - along_.places.begin());
    double found = 0.0, all = 0.0;
    std::vector<std::size_t> members;
    for (std::size_t k = from; k < along_.places.size() && along_.places[k] < s + kReach; ++k)
    {
      all += 1.0;
      found += shapes_[k].toe(along_.side).found ? 1.0 : 0.0;
      if (chosen_[k])
        members.push_back(k);
    }
    if (members.size() < kFewest || found < kShareFound * all)
      return;
    // a window that the weld fills on one side only evens out nothing
    const double before = s - along_.places[members.front()], behind = along_.places[members.back()] - s;
    if (std::min(before, behind) < kWhole * kReach)
      return;
    const auto nearer = [&](std::size_t a, std::size_t b)
    { return std::abs(along_.places[a] - s) < std::abs(along_.places[b] - s); };
    fitMean(s, members, *std::min_element(members.begin(), members.end(), nearer));
  }

  void fitMean(double s, const std::vector<std::size_t>& members, std::size_t nearest)
  {
    const ToeQuestion& question = along_.questions[nearest];
    MeanOutline mean(question);
    double all = 0.0, squares = 0.0, place = 0.0;
    for (const std::size_t k : members)
    {
      const double weight = 1.0 - square((along_.places[k] - s) / kReach);
      all += weight, squares += square(weight), place += weight * along_.places[k];
      mean.add(along_.profiles[k], shapes_[k].parent(along_.side).line, weight);
    }
    ParentFit parent = shapes_[nearest].parent(along_.side);
    parent.scatter *= std::sqrt(std::min(1.0, kAlike * squares / square(all)));
    const Node node{ place / all, fitToe(mean.above(parent.line, kShareSeen * all), question, parent, params_) };
    if (node.toe.found && std::abs(node.toe.flank) < kFlat)
      nodes_.push_back(node);
  }

  void settle(std::size_t k)
  {
    if (!chosen_[k])
      return;
    const double s = along_.places[k];
    auto after = static_cast<std::size_t>(
        std::lower_bound(nodes_.begin(), nodes_.end(), s, [](const Node& node, double at) { return node.s < at; }) -
        nodes_.begin());
    const Node& a = nodes_[after > 0 ? after - 1 : 0];
    const Node& b = nodes_[std::min(after, nodes_.size() - 1)];
    if (std::max(a.s - s, s - b.s) > kReach || b.s - a.s > 1.5 * kStep)
      return;
    const double share = b.s > a.s ? (s - a.s) / (b.s - a.s) : 0.0;
    const ToeFit& near = share < 0.5 ? a.toe : b.toe;
    const double q = a.toe.q + share * (b.toe.q - a.toe.q);
    const ParentFit& parent = shapes_[k].parent(along_.side);
    const FaceArc face = faceAt(k, q);
    if (!face.valid())
      return;
    ToeFit& toe = toeOf(shapes_[k], along_.side);
    toe = near;
    toe.sigma = std::hypot(toe.sigma, changeBeyond(s));
    toe.energy = square(parent.scatter) * parent.correlated_cells;
    toe.q = q;
    toe.z = parent.line.at(q);
    toe.face = face;
    toe.evened = true;
  }

  /// By how much the toe may have changed from the nearest mean's place to s, where there is none on either side.
  double changeBeyond(double s) const
  {
    const double beyond = std::max({ 0.0, nodes_.front().s - s, s - nodes_.back().s });
    const std::size_t inner = std::min<std::size_t>(nodes_.size() - 1, kInner);
    if (!(beyond > 0.0) || inner == 0)
      return 0.0;
    const bool first = s < nodes_.front().s;
    const Node& end = first ? nodes_.front() : nodes_.back();
    const Node& other = first ? nodes_[inner] : nodes_[nodes_.size() - 1 - inner];
    return beyond * std::abs((end.toe.q - other.toe.q) / (end.s - other.s));
  }

  FaceArc faceAt(std::size_t k, double q) const
  {
    const double inward = -sign(along_.side);
    const SectionProfile& profile = along_.profiles[k];
    const ToeQuestion& question = along_.questions[k];
    const double reach = faceReach(std::abs(question.opposite - question.guess), params_);
    const double low = inward > 0.0 ? q : q - reach, high = inward > 0.0 ? q + reach : q;
    const auto first = std::lower_bound(profile.q.begin(), profile.q.end(), low) - profile.q.begin();
    const auto last = std::lower_bound(profile.q.begin(), profile.q.end(), high) - profile.q.begin();
    std::vector<Eigen::Vector2d> points;
    for (auto i = first; i < last; ++i)
      points.emplace_back(inward * profile.q[static_cast<std::size_t>(i)], profile.z[static_cast<std::size_t>(i)]);
    if (inward < 0.0)
      std::reverse(points.begin(), points.end());
    const Eigen::Vector2d corner(inward * q, shapes_[k].parent(along_.side).line.at(q));
    return FaceArc::fit(faceWindow(points, corner, reach, params_));
  }

  const ToesAlong& along_;
  const WeldParams& params_;
  std::vector<SectionShape>& shapes_;
  std::vector<char> chosen_;
  std::vector<Node> nodes_;
};
}  // namespace

void evenToes(const ToesAlong& along, const WeldParams& params, std::vector<SectionShape>& shapes)
{
  if (!along.places.empty())
    Evening(along, params, shapes)();
}
}  // namespace weld
}  // namespace weld_profiler
