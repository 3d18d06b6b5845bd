#include "row_beads.h"

#include <algorithm>

#include "bare_plate.h"
#include "row_outline.h"
#include "row_parents.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kEnoughParent = 0.012;  // of a parent in view: more says no more [m]
constexpr double kWallCost = 4e-3;       // a wall at a toe speaks against a bead like so much less of a parent [m]
constexpr double kWidthCost = 0.1;       // and so does its width
constexpr double kWider = 1.2;           // across an oblique bead a row is wider
constexpr int kFewestBare = 2;           // nodes of a plate's short piece that are of nothing else
constexpr double kAboveShare = 0.6;      // of a bead's nodes lie above its reference

/// One row in work.
class RowSearch
{
public:
  RowSearch(const ScanGrid& grid, int row, const WeldParams& params)
    : row_(row),
      params_(params),
      outline_(grid, row),
      parents_(rowParents(outline_.nodes(), outline_.noise(), outline_.seen(), params))
  {
    for (const StraightRun& parent : parents_)
    {
      left_of_bead_.push_back(clearLine(outline_.nodes(), parent, -1, params.parent_length));
      right_of_bead_.push_back(clearLine(outline_.nodes(), parent, 1, params.parent_length));
    }
    std::vector<PlateLine> plates;
    for (std::size_t i = 0; i < parents_.size(); ++i)
    {
      plates.push_back(PlateLine{ parents_[i].end - 1, 1, left_of_bead_[i] });
      plates.push_back(PlateLine{ parents_[i].first, -1, right_of_bead_[i] });
    }
    for (const PlateLine& plate : plates)
      for (const StraightRun& piece : barePlate(outline_, plate, params))
        insert(piece);
  }

  RowFindings operator()()
  {
    RowFindings findings;
    findings.straight = !parents_.empty();
    std::vector<Contender> contenders;
    for (std::size_t i = 0; i < parents_.size(); ++i)
      for (std::size_t j = i + 1; j < parents_.size(); ++j)
        between(i, j, contenders, findings);
    settle(contenders, findings);
    if (!parents_.empty())
    {
      beyond(parents_.back(), 1, findings);
      beyond(parents_.front(), -1, findings);
    }
    return findings;
  }

private:
  /// A bead between two parents, and how much speaks for them.
  struct Contender
  {
    RowBead bead;
    double score = 0.0;
  };

  /// Takes a piece among the parents that is none of them yet; a face's last node may lie along the plate.
  void insert(StraightRun piece)
  {
    std::size_t at = 0;
    while (at < parents_.size() && parents_[at].first < piece.first)
      ++at;
    piece.first = at > 0 ? std::max(piece.first, parents_[at - 1].end) : piece.first;
    piece.end = at < parents_.size() ? std::min(piece.end, parents_[at].first) : piece.end;
    if (piece.end - piece.first < kFewestBare)
      return;
    piece.x_from = outline_.node(piece.first).x, piece.x_to = outline_.node(piece.end - 1).x;
    const auto place = static_cast<std::ptrdiff_t>(at);
    parents_.insert(parents_.begin() + place, piece);
    left_of_bead_.insert(left_of_bead_.begin() + place, piece.line);
    right_of_bead_.insert(right_of_bead_.begin() + place, piece.line);
  }

  /// Length of the runs from begin to end that lie along a line: spatter cuts a parent in pieces.
  double lengthAlong(const Line& line, std::size_t begin, std::size_t end) const
  {
    double length = 0.0;
    for (std::size_t k = begin; k < end; ++k)
    {
      const StraightRun& run = parents_[k];
      const double middle = 0.5 * (run.x_from + run.x_to);
      if (std::abs(line.above(middle, run.line.at(middle))) < 2.0 * params_.flatness)
        length += run.length();
    }
    return length;
  }

  /// The best of what lies in one place.
  static void settle(std::vector<Contender>& contenders, RowFindings& findings)
  {
    std::stable_sort(contenders.begin(), contenders.end(),
                     [](const Contender& a, const Contender& b) { return a.score > b.score; });
    for (const Contender& one : contenders)
    {
      const bool taken = std::any_of(findings.beads.begin(), findings.beads.end(),
                                     [&one](const RowBead& bead)
                                     { return one.bead.x_left < bead.x_right && bead.x_left < one.bead.x_right; });
      if (!taken)
        findings.beads.push_back(one.bead);
    }
  }

  /// Straight pieces in a bead are parts of its face: they lie above its reference.
  bool facesAbove(std::size_t i, std::size_t j, const RowBead& bead) const
  {
    for (std::size_t k = i + 1; k < j; ++k)
    {
      const double middle = 0.5 * (parents_[k].x_from + parents_[k].x_to);
      if (middle < bead.x_left || middle > bead.x_right)
        continue;
      const auto above = [&](double share)
      {
        const double x = parents_[k].x_from + share * parents_[k].length();
        return parents_[k].line.at(x) - reference(bead, x);
      };
      // a flat face comes down to its toes; a plate lies along the reference all the way
      if (!(above(0.5) > 2.0 * outline_.seen() && above(0.25) > 0.0 && above(0.75) > 0.0))
        return false;
    }
    return true;
  }

  /// A piece between two parents that lies along one of them is that plate seen again: there is no one bead.
  bool plateBetween(std::size_t i, std::size_t j, const RowBead& bead) const
  {
    for (std::size_t k = i + 1; k < j; ++k)
    {
      const StraightRun& run = parents_[k];
      if (run.x_from < bead.x_left || run.x_to > bead.x_right)
        continue;
      for (const Line* plate : { &bead.left, &bead.right })
      {
        const double first = plate->above(run.x_from, run.line.at(run.x_from));
        const double last = plate->above(run.x_to, run.line.at(run.x_to));
        if (std::max(std::abs(first), std::abs(last)) < params_.flatness)
          return true;
      }
    }
    return false;
  }

  void between(std::size_t i, std::size_t j, std::vector<Contender>& contenders, RowFindings& findings) const
  {
    const StraightRun& left = parents_[i];
    const StraightRun& right = parents_[j];
    RowBead bead;
    bead.row = row_;
    bead.left = left_of_bead_[i];
    bead.right = right_of_bead_[j];
    const int first = outline_.firstOff((left.first + left.end) / 2, right.first, bead.left, params_.min_width);
    const int last = outline_.firstOff((right.first + right.end) / 2, left.end - 1, bead.right, params_.min_width);
    findings.sunken = findings.sunken || (j == i + 1 && liesBelow(left, right));
    if (first > last)
      return;
    outline_.setToes(first, last, bead);
    const RowBead widest = bead;
    const int top = outline_.highest(first, last, bead);
    const int from = outline_.footOf(top, first, bead.left, bead), to = outline_.footOf(top, last, bead.right, bead);
    outline_.setToes(from, to, bead);
    // beside the higher plate a low face ends below its parent's line: the chord of the nodes off the parents is lower
    if (!isBead(from, to, bead) || plateBetween(i, j, widest) || !(facesAbove(i, j, bead) || facesAbove(i, j, widest)))
      return;
    const int walls = (outline_.wall(bead.x_left) ? 1 : 0) + (outline_.wall(bead.x_right) ? 1 : 0);
    findings.block = findings.block || walls == 2;
    if (walls == 2)
      return;
    const double support = std::min(lengthAlong(bead.left, 0, left.bare ? parents_.size() : i + 1), kEnoughParent) +
                           std::min(lengthAlong(bead.right, right.bare ? 0 : j, parents_.size()), kEnoughParent);
    contenders.push_back(Contender{ bead, support - walls * kWallCost - kWidthCost * (bead.x_right - bead.x_left) });
  }

  bool isBead(int first, int last, RowBead& bead) const
  {
    const double width = bead.x_right - bead.x_left;
    if (!(width >= params_.min_width && width <= kWider * params_.max_width) || last - first < 2)
      return false;
    const double above = outline_.sumUp(first, last, bead);
    return bead.height > std::max(params_.min_height, outline_.seen()) && bead.area > 0.0 && above > kAboveShare;
  }

  /// A bead that runs out of view beyond the last (side 1) or first (-1) parent.
  void beyond(const StraightRun& parent, int side, RowFindings& findings) const
  {
    const int end = side > 0 ? outline_.size() : -1;
    const int first = outline_.firstOff((parent.first + parent.end) / 2, end, parent.line, params_.min_width);
    if (first == end)
      return;
    const int last = end - side;
    RowBead bead;
    bead.row = row_;
    (side > 0 ? bead.left : bead.right) = parent.line;
    bead.x_left = outline_.node(std::min(first, last)).x;
    bead.x_right = outline_.node(std::max(first, last)).x;
    if (isBead(std::min(first, last), std::max(first, last), bead) &&
        !outline_.wall(side > 0 ? bead.x_left : bead.x_right))
      findings.beads.push_back(bead);
  }

  bool liesBelow(const StraightRun& left, const StraightRun& right) const
  {
    int below = 0;
    for (int i = left.end; i < right.first; ++i)
      below += left.line.above(outline_.node(i).x, outline_.node(i).z) < -params_.min_height - outline_.seen() &&
                       right.line.above(outline_.node(i).x, outline_.node(i).z) < -params_.min_height - outline_.seen()
                   ? 1
                   : 0;
    return right.x_from - left.x_to >= params_.min_width && 3 * below > 2 * (right.first - left.end);
  }

  int row_;
  const WeldParams& params_;
  RowOutline outline_;
  std::vector<StraightRun> parents_;
  std::vector<Line> left_of_bead_, right_of_bead_;  ///< each parent's line clear of a bead on that side
};
}  // namespace

RowFindings findRowBeads(const ScanGrid& grid, int row, const WeldParams& params)
{
  return RowSearch(grid, row, params)();
}
}  // namespace weld
}  // namespace weld_profiler
