#include "evened_toes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "face_window.h"
#include "mean_outline.h"
#include "statistics.h"
#include "toe_unrest.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kNear = 1e-5;      // rounding of places [m]
constexpr double kRestless = 3e-5;  // scatter that moves toes 0.5 mm outside of their faces inward by 2 um [m]
constexpr double kReach = 2.5e-3;   // half width that is evened out over: of a wave of 4 mm a tenth is left [m] ...
constexpr double kLeastReach = 1.25e-3;  // ... near an end of the scan: of ripples of 1.2 mm 7 % is left [m]
constexpr double kStep = 5e-4;           // from one evened out face to the next [m]
constexpr double kOblique = 0.15;        // a toe that runs at this slope over the path is none of a steady weld
constexpr std::size_t kFewest = 5;       // sections in a mean
constexpr std::size_t kInner = 2;        // means from one to another that tells how toes change
constexpr double kShareSeen = 0.3;       // of the sections, that show a place
constexpr double kShareFound = 0.5;      // of the sections that show the toe: of fewer it is not known to be one
constexpr double kFlat = 0.5;   // a face steeper than this meets its parent in one place whatever its ripples [rad]
constexpr double kLost = 0.25;  // of a steeper face ripples do not take the rise away: no toe is lost to them [rad]
constexpr double kJump = 5.0;   // unrests that ripples move a toe by at most
constexpr double kAlike = 1.5;  // neighbouring sections share a row: this many count as one

class Evening
{
public:
  Evening(const ToesAlong& along, const WeldParams& params, std::vector<SectionShape>& shapes)
    : along_(along), params_(params), shapes_(shapes)
  {
  }

  void operator()()
  {
    std::vector<double> toes;
    for (const SectionShape& shape : shapes_)
      toes.push_back(shape.toe(along_.side).found ? shape.toe(along_.side).q : kNaN);
    unrest_ = toeUnrest(along_.places, toes);
    if (std::none_of(unrest_.begin(), unrest_.end(), [](double one) { return std::abs(one) > kRestless; }))
      return;
    chosen_ = sectionsWithToe(along_.places, toes, along_.begins, along_.ends);
    for (std::size_t k = 0; k < chosen_.size(); ++k)
      chosen_[k] = chosen_[k] && shapes_[k].parent(along_.side).valid() ? 1 : 0;
    leaveEnds();
    for (double s = along_.places.front(); s < along_.places.back(); s += kStep)
      addNode(s);
    dropOblique();
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
    double unrest = 0.0;  ///< of the toes that it is told in place of [m]
  };

  static bool isNear(const std::vector<double>& places, double s)
  {
    return std::any_of(places.begin(), places.end(), [s](double place) { return std::abs(s - place) < kReach; });
  }

  /// Sections near these places keep the toes that they show themselves.
  void leave(const std::vector<double>& places)
  {
    for (std::size_t k = 0; k < chosen_.size() && !places.empty(); ++k)
      chosen_[k] = chosen_[k] && !isNear(places, along_.places[k]) ? 1 : 0;
  }

  /// Where a bead begins or ends within the scan its toes run together, which a mean shows too late.
  void leaveEnds()
  {
    std::vector<double> ends;
    for (std::size_t k = 0; k < chosen_.size(); ++k)
    {
      const bool begins = k > 0 ? !chosen_[k - 1] : along_.begins;
      const bool stops = k + 1 < chosen_.size() ? !chosen_[k + 1] : along_.ends;
      if (chosen_[k] && (begins || stops))
        ends.push_back(along_.places[k]);
    }
    leave(ends);
  }

  /// @param s  of the mean. Near an end of the weld less is evened out.
  void addNode(double s)
  {
    const auto first = static_cast<std::size_t>(std::find(chosen_.begin(), chosen_.end(), 1) - chosen_.begin());
    const auto last = static_cast<std::size_t>(std::find(chosen_.rbegin(), chosen_.rend(), 1) - chosen_.rbegin());
    if (first + last >= chosen_.size())
      return;
    const double room = std::min(s - along_.places[first], along_.places[chosen_.size() - 1 - last] - s);
    const double reach = std::min(room + kNear, kReach);
    if (!(reach >= kLeastReach))
      return;
    const auto from = static_cast<std::size_t>(std::lower_bound(along_.places.begin(), along_.places.end(), s - reach) -
                                               along_.places.begin());
    double found = 0.0, all = 0.0;
    std::vector<std::size_t> members;
    std::vector<double> unrest;
    for (std::size_t k = from; k < along_.places.size() && along_.places[k] < s + reach; ++k)
    {
      all += 1.0;
      found += shapes_[k].toe(along_.side).found ? 1.0 : 0.0;
      unrest.push_back(unrest_[k]);
      if (chosen_[k])
        members.push_back(k);
    }
    const double restless = robustSigma(unrest);
    if (members.size() < kFewest || found < kShareFound * all || !(restless > kRestless))
      return;
    const Node node = meanOf(s, reach, members);
    if (node.toe.found && std::abs(node.toe.flank) < kFlat)
      nodes_.push_back(Node{ node.s, node.toe, restless });
  }

  Node meanOf(double s, double reach, const std::vector<std::size_t>& members)
  {
    const auto nearer = [&](std::size_t a, std::size_t b)
    { return std::abs(along_.places[a] - s) < std::abs(along_.places[b] - s); };
    const std::size_t nearest = *std::min_element(members.begin(), members.end(), nearer);
    const ToeQuestion& question = along_.questions[nearest];
    MeanOutline mean(question);
    double all = 0.0, squares = 0.0, place = 0.0;
    for (const std::size_t k : members)
    {
      const double weight = 1.0 - square((along_.places[k] - s) / reach);
      all += weight, squares += square(weight), place += weight * along_.places[k];
      mean.add(along_.profiles[k], shapes_[k].parent(along_.side).line, weight);
    }
    ParentFit parent = shapes_[nearest].parent(along_.side);
    parent.scatter *= std::sqrt(std::min(1.0, kAlike * squares / square(all)));
    return Node{ place / all, fitToe(mean.above(parent.line, kShareSeen * all), question, parent, params_) };
  }

  /// Where toes run obliquely from mean to mean the bead tapers: such sections are left as they are.
  void dropOblique()
  {
    std::vector<double> oblique;
    for (std::size_t i = 1; i < nodes_.size(); ++i)
    {
      const double step = nodes_[i].s - nodes_[i - 1].s;
      if (step < 1.5 * kStep && std::abs(nodes_[i].toe.q - nodes_[i - 1].toe.q) > kOblique * step)
        oblique.push_back(0.5 * (nodes_[i].s + nodes_[i - 1].s));
    }
    const auto beside = [&oblique](const Node& node) { return isNear(oblique, node.s); };
    nodes_.erase(std::remove_if(nodes_.begin(), nodes_.end(), beside), nodes_.end());
    leave(oblique);
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
    const bool between = a.s <= s && s <= b.s && b.s - a.s <= 1.5 * kStep;
    if (!between && !beforeScansEnd(s))
      return;
    const double share = b.s > a.s ? (s - a.s) / (b.s - a.s) : 0.0;
    const ToeFit& near = share < 0.5 ? a.toe : b.toe;
    const double q = a.toe.q + share * (b.toe.q - a.toe.q);
    ToeFit& toe = shapes_[k].toe(along_.side);
    // what leaves the others is no ripple but the bead's end
    if (toe.found ? std::abs(toe.q - q) > kJump * std::max(a.unrest, b.unrest) : std::abs(near.flank) > kLost)
      return;
    const ParentFit& parent = shapes_[k].parent(along_.side);
    const FaceArc face = faceAt(k, q);
    if (!face.valid())
      return;
    toe = near;
    toe.sigma = std::hypot(toe.sigma, changeBeyond(s));
    toe.energy = square(parent.scatter) * parent.correlated_cells;
    toe.q = q;
    toe.z = parent.line.at(q);
    toe.face = face;
    toe.evened = true;
  }

  /// Whether s lies between the means and an end of the scan that the bead runs on beyond: it does not end there.
  bool beforeScansEnd(double s) const
  {
    const double before = nodes_.front().s - along_.places.front(), behind = along_.places.back() - nodes_.back().s;
    return (s < nodes_.front().s && !along_.begins && before < kLeastReach + kStep) ||
           (s > nodes_.back().s && !along_.ends && behind < kLeastReach + kStep);
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
  std::vector<double> unrest_;  ///< of each toe [m]; NaN where those beside it are not known
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
