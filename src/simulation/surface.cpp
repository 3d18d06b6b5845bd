#include "simulation/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kCell = 0.001;          // of the grid of spots and ceilings [m]
constexpr double kFineCell = 0.0002;     // of the finer ceilings [m]
constexpr double kHalfField = 0.05;      // the grid reaches this far from the seam and beyond the scan [m]
constexpr double kProbe = 0.0001;        // spacing of the heights that make a ceiling [m]
constexpr double kCeilingMargin = 5e-5;  // for what lies between probes: 45 degrees, or the plate, over half one [m]
constexpr double kSlopeStep = 2e-6;      // [m]

std::vector<SceneBlock> standing(const SceneParams& scene)
{
  std::vector<SceneBlock> blocks;
  for (const SceneBlock& block : { scene.gauge, scene.marker })
    if (block.height > 0.0)
      blocks.push_back(block);
  return blocks;
}

CellGrid gridAround(const SceneParams& scene, double length, double cell)
{
  CellGrid grid;
  grid.x = scene.plates.x - kHalfField;
  grid.y = scene.part_start - 0.2 * kHalfField;
  grid.cell = cell;
  grid.columns = static_cast<int>(2.0 * kHalfField / cell);
  grid.rows = static_cast<int>((length + 0.4 * kHalfField) / cell) + 1;
  grid.scanned = length;
  return grid;
}
}  // namespace

Surface::Surface(const SceneParams& scene, double y_offset, double length)
  : bead_(scene.plates, scene.weld, scene.second_bead),
    bead_reflectance_(scene.laser.bead_reflectance),
    y_offset_(y_offset),
    blocks_(standing(scene)),
    grid_(gridAround(scene, length, kCell)),
    ceilings_(grid_),
    fine_ceilings_(gridAround(scene, length, kFineCell)),
    spots_(scene, bead_, grid_, [this](double x, double y) { return blockAt(x, y) != nullptr; })
{
  findCeilings();
}

const SceneBlock* Surface::blockAt(double x, double part_y) const
{
  for (const SceneBlock& block : blocks_)
    if (std::abs(x - block.x) < 0.5 * block.width && part_y >= block.y && part_y < block.y + block.length)
      return &block;
  return nullptr;
}

double Surface::smooth(double x, double part_y, const SceneBlock* block) const
{
  const PathPoint point = bead_.locate(x, part_y);
  if (block != nullptr)
    return bead_.plateHeight(point) + block->height;
  return spots_.apply(grid_.index(x, part_y), x, part_y, bead_.height(point));
}

double Surface::height(double x, double y) const
{
  const double part_y = y - y_offset_;
  return smooth(x, part_y, blocks_.empty() ? nullptr : blockAt(x, part_y));
}

Eigen::Vector2d Surface::slope(double x, double y) const
{
  const double part_y = y - y_offset_;
  const SceneBlock* block = blocks_.empty() ? nullptr : blockAt(x, part_y);
  return Eigen::Vector2d(smooth(x + kSlopeStep, part_y, block) - smooth(x - kSlopeStep, part_y, block),
                         smooth(x, part_y + kSlopeStep, block) - smooth(x, part_y - kSlopeStep, block)) /
         (2.0 * kSlopeStep);
}

double Surface::reflectance(double x, double y) const
{
  if (bead_reflectance_ == 1.0)
    return 1.0;
  const PathPoint point = bead_.locate(x, y - y_offset_);
  return std::abs(point.q) < bead_.halfWidth(point.s) ? bead_reflectance_ : 1.0;
}

TrueLabel Surface::label(double x, double y) const
{
  const double part_y = y - y_offset_;
  if (blockAt(x, part_y) != nullptr)
    return TrueLabel::Unknown;
  const PathPoint point = bead_.locate(x, part_y);
  const double z = bead_.height(point);
  if (spots_.apply(grid_.index(x, part_y), x, part_y, z) > z)
    return TrueLabel::Spatter;
  const Zone zone = bead_.zone(point);
  if (zone == Zone::Plate)
    return TrueLabel::Base;
  return zone == Zone::Bead ? TrueLabel::Bead : TrueLabel::Undercut;
}

double Surface::target(double x, double y, double rest) const
{
  return bead_.target(bead_.locate(x, y - y_offset_), rest);
}

std::vector<TrueSpot> Surface::spots() const
{
  std::vector<TrueSpot> result = spots_.all();
  for (TrueSpot& spot : result)
    spot.position[1] += y_offset_;
  return result;
}

void Surface::probe(double x, double part_y)
{
  const double z = height(x, part_y + y_offset_);
  const double margin = kCeilingMargin * std::max(1.0, bead_.steepest());
  highest_ = std::max(highest_, z + margin);
  lowest_ = std::min(lowest_, z);
  ceilings_.raise(x, part_y, z + margin);
  fine_ceilings_.raise(x, part_y, z + margin);
}

void Surface::findCeilings()
{
  highest_ = -std::numeric_limits<double>::infinity();
  lowest_ = std::numeric_limits<double>::infinity();
  const auto probeBox = [this](double x, double y, double width, double length)
  {
    const int columns = static_cast<int>(std::ceil(width / kProbe));
    const int rows = static_cast<int>(std::ceil(length / kProbe));
    for (int row = 0; row <= rows; ++row)
      for (int column = 0; column <= columns; ++column)
        probe(x + width * column / columns, y + length * row / rows);
  };
  probeBox(grid_.x, grid_.y, grid_.columns * kCell, grid_.rows * kCell);
  constexpr double kInside = 1e-9;  // a block's edge is probed just inside it, where it may be alone in its cell
  for (const SceneBlock& block : blocks_)
    probeBox(block.x - 0.5 * block.width + kInside, block.y + kInside, block.width - 2.0 * kInside,
             block.length - 2.0 * kInside);
  ceilings_.widen();
  fine_ceilings_.widen();
}

double Surface::firstHit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double step) const
{
  constexpr double kReach = 0.03;  // what is farther away is neither shadow nor mirror [m]
  constexpr double kSteepRay = 0.5;
  constexpr double kClearance = 1e-7;  // a ray may graze the surface it starts on [m]
  const double level = std::max(direction.head<2>().norm(), 0.02);
  const double stride = direction.z() > 0.0 ? kCell / level : step;
  // steep rays outrun what lies between the probes of the fine ceilings; others are followed step by step
  const bool steep = direction.z() >= kSteepRay;
  double clear = 0.0;  // no surface is met before this distance
  double distance = step;
  while (distance < kReach)
  {
    const Eigen::Vector3d point = from + distance * direction;
    if (point.z() > highest_ && direction.z() >= 0.0)
      return -1.0;
    const double part_y = point.y() - y_offset_;
    if (point.z() > ceilings_.at(point.x(), part_y, highest_))
    {
      distance += std::max(step, stride);
      continue;
    }
    if (distance >= clear)
    {
      if (steep && point.z() > fine_ceilings_.at(point.x(), part_y, highest_))
        clear = distance + kFineCell / level;
      else if (height(point.x(), point.y()) > point.z() + kClearance)
        return distance;
    }
    distance += step;
  }
  return -1.0;
}
}  // namespace simulation
}  // namespace weld_profiler
