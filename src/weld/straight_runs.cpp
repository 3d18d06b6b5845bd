#include "straight_runs.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kNodeLength = 3e-4;     // [m]
constexpr int kFirstNodes = 3;           // of the pieces that merging begins with
constexpr double kLongestDirt = 1.6e-3;  // what lies on a plate (spatter) and is passed over [m]
constexpr double kLooser = 1.5;          // tolerance for pieces with something between them

/// Sums of a straight line's regression.
struct Sums
{
  double n = 0.0, x = 0.0, z = 0.0, xx = 0.0, xz = 0.0, zz = 0.0;

  void add(double px, double pz)
  {
    n += 1.0, x += px, z += pz;
    xx += px * px, xz += px * pz, zz += pz * pz;
  }

  Sums operator+(const Sums& other) const
  {
    return Sums{ n + other.n, x + other.x, z + other.z, xx + other.xx, xz + other.xz, zz + other.zz };
  }

  double spread() const { return xx - x * x / n; }

  Line line() const
  {
    const double slope = spread() > 0.0 ? (xz - x * z / n) / spread() : 0.0;
    return Line{ (z - slope * x) / n, slope };
  }

  /// Root mean square distance from the line.
  double scatter() const
  {
    const Line fitted = line();
    const double rest = zz - z * z / n - square(fitted.slope) * spread();
    return std::sqrt(std::max(0.0, rest) / (n * (1.0 + square(fitted.slope))));
  }
};

struct Piece
{
  int first, end;
  Sums sums;
  double with_next = 0.0;  ///< scatter of this piece and the next about one line
};

void lookAhead(std::vector<Piece>& pieces, std::size_t i)
{
  if (i + 1 < pieces.size())
    pieces[i].with_next = (pieces[i].sums + pieces[i + 1].sums).scatter();
}

/// Joins the two neighbours that lie straightest; false when none do.
bool mergeBest(double tolerance, std::vector<Piece>& pieces)
{
  double best = tolerance;
  std::size_t at = pieces.size();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
  {
    if (!(pieces[i].with_next < best))
      continue;
    best = pieces[i].with_next;
    at = i;
  }
  if (at == pieces.size())
    return false;
  pieces[at].sums = pieces[at].sums + pieces[at + 1].sums;
  pieces[at].end = pieces[at + 1].end;
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(at) + 1);
  lookAhead(pieces, at);
  if (at > 0)
    lookAhead(pieces, at - 1);
  return true;
}

/// Joins pieces of one straight line that something short parts.
void mergeAcrossDirt(const std::vector<Node>& nodes, double tolerance, std::vector<Piece>& pieces)
{
  const auto x = [&nodes](int i) { return nodes[static_cast<std::size_t>(i)].x; };
  for (std::size_t i = 0; i + 2 < pieces.size(); ++i)
  {
    for (std::size_t j = i + 2; j < pieces.size(); ++j)
    {
      if (x(pieces[j].first) - x(pieces[i].end - 1) > kLongestDirt)
        break;
      if (pieces[i].end - pieces[i].first < 2 * kFirstNodes || pieces[j].end - pieces[j].first < 2 * kFirstNodes)
        continue;
      const Sums both = pieces[i].sums + pieces[j].sums;
      if (!(both.scatter() < kLooser * tolerance))
        continue;
      pieces[i].sums = both;
      pieces[i].end = pieces[j].end;
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   pieces.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      j = i + 1;
    }
  }
}
}  // namespace

std::vector<Node> rowNodes(const ScanGrid& grid, int row)
{
  const int step = std::max(1, static_cast<int>(std::lround(kNodeLength / grid.spacing)));
  std::vector<Node> nodes;
  nodes.reserve(static_cast<std::size_t>(grid.cells / step) + 1);
  for (int cell = 0; cell < grid.cells; cell += step)
  {
    Node node;
    int count = 0;
    for (int c = cell; c < std::min(grid.cells, cell + step); ++c)
    {
      const std::size_t i = grid.at(row, c);
      if (!std::isfinite(grid.z[i]))
        continue;
      node.x += grid.x[i], node.z += grid.z[i];
      ++count;
    }
    if (count == 0)
      continue;
    node.x /= count, node.z /= count;
    node.cell = cell;
    nodes.push_back(node);
  }
  return nodes;
}

double nodeNoise(const std::vector<Node>& nodes)
{
  std::vector<double> bends;
  for (std::size_t i = 2; i < nodes.size(); ++i)
    bends.push_back(nodes[i].z - 2.0 * nodes[i - 1].z + nodes[i - 2].z);
  const double sigma = robustSigma(std::move(bends)) / std::sqrt(6.0);
  return std::isfinite(sigma) ? sigma : 0.0;
}

std::vector<StraightRun> straightRuns(const std::vector<Node>& nodes, double tolerance)
{
  std::vector<Piece> pieces;
  const int count = static_cast<int>(nodes.size());
  const double middle = nodes.empty() ? 0.0 : nodes[nodes.size() / 2].x;  // keeps the sums small
  for (int first = 0; first < count; first += kFirstNodes)
  {
    Piece piece{ first, std::min(count, first + kFirstNodes), Sums(), 0.0 };
    for (int i = piece.first; i < piece.end; ++i)
      piece.sums.add(nodes[static_cast<std::size_t>(i)].x - middle, nodes[static_cast<std::size_t>(i)].z);
    pieces.push_back(piece);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    lookAhead(pieces, i);
  while (mergeBest(tolerance, pieces))
  {
  }
  mergeAcrossDirt(nodes, tolerance, pieces);
  std::vector<StraightRun> runs;
  for (const Piece& piece : pieces)
  {
    Line line = piece.sums.line();
    line.height -= line.slope * middle;
    runs.push_back(StraightRun{ piece.first, piece.end, nodes[static_cast<std::size_t>(piece.first)].x,
                                nodes[static_cast<std::size_t>(piece.end) - 1].x, line });
  }
  return runs;
}
}  // namespace weld
}  // namespace weld_profiler
