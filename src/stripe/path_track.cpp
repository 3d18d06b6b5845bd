#include "path_track.h"

#include <algorithm>
#include <cmath>

#include "medians.h"
#include "multiversion.h"

namespace weld_profiler
{
namespace
{
constexpr int kOverhang = 8;       // columns that a piece is laid beyond its last node's group
constexpr float kSteepest = 2.0F;  // rows a column that a line is laid on with

}  // namespace

/// A group's profile is wider than a column's where the stripe is oblique.
void PathTrack::takeSmear(std::size_t begin, std::size_t end)
{
  for (std::size_t i = begin; i < end; ++i)
  {
    const GroupProfile& a = nodes_[i > begin ? i - 1 : i];
    const GroupProfile& b = nodes_[i + 1 < end ? i + 1 : i];
    const float rise = b.u > a.u ? kGroup * (b.v - a.v) / (b.u - a.u) : 0.0F;
    const float square = nodes_[i].sigma * nodes_[i].sigma;
    evened_[i] = std::sqrt(std::max(square - rise * rise / 12.0F, 0.25F * square));
  }
  for (std::size_t i = begin; i < end; ++i)
    nodes_[i].sigma = std::max(GroupProfile::kNarrowest, evened_[i]);
}

/// Background that noise alone could make slope is taken for level: its slope would move every centre around.
void PathTrack::dropUnsureGradients(std::size_t begin, std::size_t end, float noise)
{
  // Two medians of three sums of eight columns; a median of five and a mean of nine leave a sixth of their variance.
  constexpr float kVariance = 2.0F / (kGroup * 3.0F * 0.7F) / 6.0F;
  constexpr float kSurely = 6.0F;
  for (std::size_t i = begin; i < end; ++i)
  {
    const float chance = kVariance * noise * noise / std::max(1.0F, nodes_[i].span * nodes_[i].span);
    const float square = std::max(1e-12F, nodes_[i].gradient * nodes_[i].gradient);
    nodes_[i].gradient *= std::max(0.0F, 1.0F - kSurely * chance / square);
  }
}

/// Running mean of nine neighbours.
void PathTrack::smooth(std::size_t begin, std::size_t end, float GroupProfile::*field)
{
  constexpr std::size_t kSide = 4;
  for (std::size_t i = begin; i < end; ++i)
  {
    const std::size_t side = std::min({ kSide, i - begin, end - 1 - i });
    float sum = 0.0F;
    for (std::size_t j = i - side; j <= i + side; ++j)
      sum += nodes_[j].*field;
    evened_[i] = sum / static_cast<float>(2 * side + 1);
  }
  for (std::size_t i = begin; i < end; ++i)
    nodes_[i].*field = evened_[i];
}

/// Median of five neighbours.
void PathTrack::evenOut(std::size_t begin, std::size_t end, float GroupProfile::*field)
{
  for (std::size_t i = begin; i < end; ++i)
  {
    const auto at = [&](std::ptrdiff_t off)
    {
      const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(i) + off;
      return nodes_[static_cast<std::size_t>(
                 std::clamp(j, static_cast<std::ptrdiff_t>(begin), static_cast<std::ptrdiff_t>(end) - 1))].*
             field;
    };
    evened_[i] = median5({ at(-2), at(-1), at(0), at(1), at(2) });
  }
  for (std::size_t i = begin; i < end; ++i)
    nodes_[i].*field = evened_[i];
}

namespace
{
/// Values that change evenly along some columns.
struct Line
{
  struct Value
  {
    float start, change;
  };
  int slot, count;
  float first;  ///< columns from where the values start to the first
  Value v, sigma, background, gradient;
  float ambiguous;
};

void draw(const Line& line, ColumnTrack& track)
{
  float* v = track.v.data() + line.slot;
  float* sigma = track.sigma.data() + line.slot;
  float* background = track.background.data() + line.slot;
  float* gradient = track.gradient.data() + line.slot;
  float* ambiguous = track.ambiguous.data() + line.slot;
  WELD_PROFILER_APART
  for (int k = 0; k < line.count; ++k)
  {
    const float along = line.first + static_cast<float>(k);
    v[k] = line.v.start + along * line.v.change;
    sigma[k] = line.sigma.start + along * line.sigma.change;
    background[k] = line.background.start + along * line.background.change;
    gradient[k] = line.gradient.start + along * line.gradient.change;
    ambiguous[k] = line.ambiguous;
  }
}
}  // namespace

void PathTrack::layPiece(std::size_t begin, std::size_t end, int columns, ColumnTrack& track) const
{
  constexpr float kReach = 0.5F * kGroup + kOverhang;
  ColumnTrack::Piece piece;
  piece.cell = std::max(0, static_cast<int>(nodes_[begin].u - kReach + 1.0F));
  const int stop = std::min(columns, static_cast<int>(nodes_[end - 1].u + kReach) + 1);
  piece.count = stop - piece.cell;
  piece.slot = (track.pieces.empty() ? 0 : track.pieces.back().slot + track.pieces.back().count) + ColumnTrack::kGuard;
  track.pieces.push_back(piece);
  // Straight from node to node; beyond the ends the line goes on, and all else stays what it is there.
  const auto segment = [&](int from, int until, const GroupProfile& a, const GroupProfile& b)
  {
    const float scale = b.u > a.u ? 1.0F / (b.u - a.u) : 0.0F;
    const bool between = static_cast<float>(from) >= a.u && static_cast<float>(until - 1) <= b.u;
    const float share = between ? scale : 0.0F;
    const GroupProfile& near = static_cast<float>(from) >= b.u ? b : a;
    Line line{};
    line.slot = piece.slot + from - piece.cell;
    line.count = until - from;
    line.first = static_cast<float>(from) - near.u;
    line.v = { near.v, between ? (b.v - a.v) * scale : std::clamp((b.v - a.v) * scale, -kSteepest, kSteepest) };
    line.sigma = { near.sigma, share * (b.sigma - a.sigma) };
    line.background = { near.background, share * (b.background - a.background) };
    line.gradient = { near.gradient, share * (b.gradient - a.gradient) };
    line.ambiguous = std::max(a.ambiguous, b.ambiguous);
    draw(line, track);
  };
  const auto columnFrom = [&](float u) { return std::clamp(static_cast<int>(std::ceil(u)), piece.cell, stop); };
  const std::size_t second = std::min(begin + 1, end - 1);
  const std::size_t before_last = std::max(begin + 1, end - 1) - 1;
  segment(piece.cell, columnFrom(nodes_[begin].u), nodes_[begin], nodes_[second]);
  for (std::size_t i = begin; i + 1 < end; ++i)
    segment(columnFrom(nodes_[i].u), columnFrom(nodes_[i + 1].u), nodes_[i], nodes_[i + 1]);
  segment(columnFrom(nodes_[end - 1].u), stop, nodes_[before_last], nodes_[end - 1]);
}

void ColumnTrack::layOn(const Piece& piece)
{
  constexpr int kEnd = 8;
  const auto first = static_cast<std::size_t>(piece.slot);
  const std::size_t last = first + static_cast<std::size_t>(piece.count) - 1;
  const auto end = static_cast<std::size_t>(std::min(kEnd, piece.count) - 1);
  const float rise = (v[first + end] - v[first]) / static_cast<float>(end);
  const float fall = (v[last] - v[last - end]) / static_cast<float>(end);
  for (std::size_t i = 1; i <= kGuard / 2; ++i)
  {
    v[first - i] = v[first] - rise * static_cast<float>(i);
    v[last + i] = v[last] + fall * static_cast<float>(i);
  }
}

void PathTrack::lay(const GroupSums& sums, const std::vector<PathNode>& nodes, float noise, ColumnTrack& track)
{
  const int columns = sums.columns();
  track.columns = columns;
  nodes_.clear();
  for (const PathNode& node : nodes)
    nodes_.push_back(measureGroup(sums, node));
  evened_.resize(nodes_.size());
  track.pieces.clear();
  // Pieces overlap by their overhangs and have guards: no more slots than this.
  std::size_t pieces = 0;
  for (const GroupProfile& node : nodes_)
    pieces += node.starts_piece ? 1 : 0;
  track.resize(static_cast<std::size_t>(columns) + (pieces + 1) * (2 * ColumnTrack::kGuard + 2 * (kOverhang + kGroup)));
  for (std::size_t begin = 0, end = 0; begin < nodes_.size(); begin = end)
  {
    for (end = begin + 1; end < nodes_.size() && !nodes_[end].starts_piece;)
      ++end;
    takeSmear(begin, end);
    evenOut(begin, end, &GroupProfile::sigma);
    evenOut(begin, end, &GroupProfile::background);
    evenOut(begin, end, &GroupProfile::gradient);
    smooth(begin, end, &GroupProfile::background);
    smooth(begin, end, &GroupProfile::gradient);
    dropUnsureGradients(begin, end, noise);
    layPiece(begin, end, columns, track);
    track.layOn(track.pieces.back());
  }
}
}  // namespace weld_profiler
