#include "simulation/spots.h"

#include <algorithm>
#include <cmath>

#include "simulation/random.h"

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kBallFloor = 0.4;   // height of a ball's centre over the surface, in radii
constexpr double kPoreRegion = 0.9;  // pores keep within this share of the bead's width
constexpr double kPoreGap = 2e-4;    // at least, between two pores' rims [m]
constexpr int kTriesAPore = 20;
constexpr double kSlopeStep = 1e-5;  // [m]

/// Cosine of the bead's slope at a place.
double levelness(const Bead& bead, double x, double y)
{
  const auto z = [&](double dx, double dy) { return bead.height(bead.locate(x + dx, y + dy)); };
  const double dx = (z(kSlopeStep, 0.0) - z(-kSlopeStep, 0.0)) / (2.0 * kSlopeStep);
  const double dy = (z(0.0, kSlopeStep) - z(0.0, -kSlopeStep)) / (2.0 * kSlopeStep);
  return 1.0 / std::sqrt(1.0 + dx * dx + dy * dy);
}
}  // namespace

Spots::Spots(const SceneParams& scene, const Bead& bead, const CellGrid& grid,
             const std::function<bool(double, double)>& blocked)
  : grid_(grid), bead_(bead), balls_(grid.size()), pits_(scene.pores.count > 0 ? grid.size() : 0)
{
  placeBalls(scene, blocked);
  placePores(scene);
}

template <class Spot>
void Spots::enlist(const Spot& spot, double reach, std::vector<std::vector<Spot>>& lists) const
{
  for (double y = spot.y - reach; y < spot.y + reach + grid_.cell; y += grid_.cell)
    for (double x = spot.x - reach; x < spot.x + reach + grid_.cell; x += grid_.cell)
      if (grid_.index(x, y) >= 0)
        lists[static_cast<std::size_t>(grid_.index(x, y))].push_back(spot);
}

void Spots::placeBalls(const SceneParams& scene, const std::function<bool(double, double)>& blocked)
{
  Random random(mix(scene.seed, 0x5BA77E8));
  for (int i = 0; i < scene.spatter.count; ++i)
  {
    Ball ball{};
    ball.x = scene.plates.x + random.uniform(-0.03, 0.03);
    ball.y = scene.part_start + random.uniform(-0.002, grid_.scanned + 0.002);
    ball.radius = random.uniform(scene.spatter.radius_min, scene.spatter.radius_max);
    if (blocked(ball.x, ball.y))
      continue;
    const PathPoint place = bead_.locate(ball.x, ball.y);
    ball.z = bead_.height(place) + kBallFloor * ball.radius;
    enlist(ball, ball.radius, balls_);
    TrueSpot spot;
    spot.kind = TrueSpot::Kind::Spatter;
    spot.position = { { ball.x, ball.y, ball.z + ball.radius } };
    spot.s = place.s;
    spot.diameter = 2.0 * ball.radius;
    spot.height = ball.radius * (1.0 + kBallFloor * levelness(bead_, ball.x, ball.y));
    all_.push_back(spot);
  }
}

void Spots::placePores(const SceneParams& scene)
{
  Random random(mix(scene.seed, 0x90BE5));
  for (int i = 0; i < scene.pores.count; ++i)
  {
    const double diameter = random.uniform(scene.pores.diameter_min, scene.pores.diameter_max);
    for (int attempt = 0; attempt < kTriesAPore; ++attempt)
    {
      PathPoint place;
      place.s = random.uniform(0.0, scene.weld.length);
      const double room = kPoreRegion * bead_.halfWidth(place.s) - 0.5 * diameter;
      place.q = room * random.uniform(-1.0, 1.0);
      if (room > 0.0 && bead_.risen(place.s) && addPore(place, diameter, scene.pores.depth * diameter))
        break;
    }
  }
}

bool Spots::addPore(const PathPoint& place, double diameter, double depth)
{
  const Eigen::Vector2d middle = bead_.place(place);
  for (const TrueSpot& other : all_)
    if (other.kind == TrueSpot::Kind::Pore &&
        std::hypot(other.position[0] - middle.x(), other.position[1] - middle.y()) <
            0.5 * (diameter + other.diameter) + kPoreGap)
      return false;
  Pit pit{};
  pit.x = middle.x();
  pit.y = middle.y();
  pit.reach = 0.5 * diameter;
  pit.radius = 0.5 * (pit.reach * pit.reach + depth * depth) / depth;
  pit.drop = pit.radius - depth;
  enlist(pit, pit.reach, pits_);
  TrueSpot spot;
  spot.kind = TrueSpot::Kind::Pore;
  spot.position = { { pit.x, pit.y, bead_.height(place) - depth } };
  spot.s = place.s;
  spot.diameter = diameter;
  spot.height = -depth * levelness(bead_, pit.x, pit.y);
  all_.push_back(spot);
  return true;
}

double Spots::apply(int cell, double x, double y, double z) const
{
  if (cell < 0)
    return z;
  if (!pits_.empty())
    for (const Pit& pit : pits_[static_cast<std::size_t>(cell)])
    {
      const double squared = (x - pit.x) * (x - pit.x) + (y - pit.y) * (y - pit.y);
      if (squared < pit.reach * pit.reach)
        z -= std::sqrt(pit.radius * pit.radius - squared) - pit.drop;
    }
  for (const Ball& ball : balls_[static_cast<std::size_t>(cell)])
  {
    const double rest = ball.radius * ball.radius - (x - ball.x) * (x - ball.x) - (y - ball.y) * (y - ball.y);
    if (rest > 0.0)
      z = std::max(z, ball.z + std::sqrt(rest));
  }
  return z;
}
}  // namespace simulation
}  // namespace weld_profiler
