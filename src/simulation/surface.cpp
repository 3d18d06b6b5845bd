#include "simulation/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/random.h"

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kCell = 0.001;          // of the grid of ceilings and buckets [m]
constexpr double kHalfField = 0.05;      // the grid reaches this far from the seam and beyond the scan [m]
constexpr double kProbe = 0.0001;        // spacing of the heights that make a ceiling [m]
constexpr double kCeilingMargin = 5e-5;  // for what lies between probes: 45 degrees over half a probe [m]
constexpr double kSlopeStep = 2e-6;      // [m]
constexpr double kBallFloor = 0.4;       // height of a ball's centre over the surface, in radii
}  // namespace

Surface::Surface(const SceneParams& scene, double y_offset, double length)
  : bead_(scene.plates, scene.weld), bead_reflectance_(scene.laser.bead_reflectance), y_offset_(y_offset)
{
  for (const SceneBlock& block : { scene.gauge, scene.marker })
    if (block.height > 0.0)
      blocks_.push_back(block);
  grid_x_ = scene.plates.x - kHalfField;
  grid_y_ = scene.part_start - 0.2 * kHalfField;
  columns_ = static_cast<int>(2.0 * kHalfField / kCell);
  rows_ = static_cast<int>((length + 0.4 * kHalfField) / kCell) + 1;
  buckets_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  placeBalls(scene, length);
  findCeilings();
}

const SceneBlock* Surface::blockAt(double x, double part_y) const
{
  for (const SceneBlock& block : blocks_)
    if (std::abs(x - block.x) < 0.5 * block.width && part_y >= block.y && part_y < block.y + block.length)
      return &block;
  return nullptr;
}

int Surface::cellIndex(double x, double part_y) const
{
  const double column = (x - grid_x_) / kCell;
  const double row = (part_y - grid_y_) / kCell;
  if (!(column >= 0.0 && column < columns_ && row >= 0.0 && row < rows_))
    return -1;
  return static_cast<int>(row) * columns_ + static_cast<int>(column);
}

double Surface::smooth(double x, double part_y, const SceneBlock* block) const
{
  const PathPoint point = bead_.locate(x, part_y);
  if (block != nullptr)
    return bead_.plateHeight(point) + block->height;
  double z = bead_.height(point);
  const int bucket = cellIndex(x, part_y);
  if (bucket < 0)
    return z;
  for (const Ball& ball : buckets_[static_cast<std::size_t>(bucket)])
  {
    const double rest = ball.radius * ball.radius - (x - ball.x) * (x - ball.x) - (part_y - ball.y) * (part_y - ball.y);
    if (rest > 0.0)
      z = std::max(z, ball.z + std::sqrt(rest));
  }
  return z;
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

void Surface::placeBalls(const SceneParams& scene, double length)
{
  Random random(mix(scene.seed, 0x5BA77E8));
  for (int i = 0; i < scene.spatter.count; ++i)
  {
    Ball ball{};
    ball.x = scene.plates.x + random.uniform(-0.03, 0.03);
    ball.y = scene.part_start + random.uniform(-0.002, length + 0.002);
    ball.radius = random.uniform(scene.spatter.radius_min, scene.spatter.radius_max);
    if (blockAt(ball.x, ball.y) != nullptr)
      continue;
    ball.z = bead_.height(bead_.locate(ball.x, ball.y)) + kBallFloor * ball.radius;
    for (double y = ball.y - ball.radius; y < ball.y + ball.radius + kCell; y += kCell)
      for (double x = ball.x - ball.radius; x < ball.x + ball.radius + kCell; x += kCell)
        if (cellIndex(x, y) >= 0)
          buckets_[static_cast<std::size_t>(cellIndex(x, y))].push_back(ball);
  }
}

void Surface::probe(double x, double part_y)
{
  const double z = height(x, part_y + y_offset_);
  highest_ = std::max(highest_, z + kCeilingMargin);
  lowest_ = std::min(lowest_, z);
  const int cell = cellIndex(x, part_y);
  if (cell >= 0)
    ceilings_[static_cast<std::size_t>(cell)] =
        std::max(ceilings_[static_cast<std::size_t>(cell)], static_cast<float>(z + kCeilingMargin));
}

void Surface::findCeilings()
{
  highest_ = -std::numeric_limits<double>::infinity();
  lowest_ = std::numeric_limits<double>::infinity();
  ceilings_.assign(buckets_.size(), -std::numeric_limits<float>::infinity());
  const auto probeBox = [this](double x, double y, double width, double length)
  {
    const int columns = static_cast<int>(std::ceil(width / kProbe));
    const int rows = static_cast<int>(std::ceil(length / kProbe));
    for (int row = 0; row <= rows; ++row)
      for (int column = 0; column <= columns; ++column)
        probe(x + width * column / columns, y + length * row / rows);
  };
  probeBox(grid_x_, grid_y_, columns_ * kCell, rows_ * kCell);
  constexpr double kInside = 1e-9;  // a block's edge is probed just inside it, where it may be alone in its cell
  for (const SceneBlock& block : blocks_)
    probeBox(block.x - 0.5 * block.width + kInside, block.y + kInside, block.width - 2.0 * kInside,
             block.length - 2.0 * kInside);
  widenCeilings();
}

/// Each cell takes the highest of its neighbours, so that a ray above it is clear for a whole cell around.
void Surface::widenCeilings()
{
  const std::vector<float> own = ceilings_;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
      for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y)
        for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x)
        {
          float& top = ceilings_[cellAt(column, row)];
          top = std::max(top, own[cellAt(x, y)]);
        }
}

double Surface::ceiling(double x, double y) const
{
  const int cell = cellIndex(x, y - y_offset_);
  return cell < 0 ? highest_ : static_cast<double>(ceilings_[static_cast<std::size_t>(cell)]);
}

double Surface::firstHit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double step) const
{
  constexpr double kReach = 0.03;      // what is farther away is neither shadow nor mirror [m]
  constexpr double kClearance = 1e-7;  // a ray may graze the surface it starts on [m]
  const double stride = direction.z() > 0.0 ? kCell / std::max(direction.head<2>().norm(), 0.02) : step;
  double distance = step;
  while (distance < kReach)
  {
    const Eigen::Vector3d point = from + distance * direction;
    if (point.z() > highest_ && direction.z() >= 0.0)
      return -1.0;
    if (point.z() > ceiling(point.x(), point.y()))
    {
      distance += std::max(step, stride);
      continue;
    }
    if (height(point.x(), point.y()) > point.z() + kClearance)
      return distance;
    distance += step;
  }
  return -1.0;
}
}  // namespace simulation
}  // namespace weld_profiler
