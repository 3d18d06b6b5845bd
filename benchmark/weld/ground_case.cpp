#include "weld/ground_case.h"

#include <algorithm>

#include "tools/simulated_cloud.h"
#include "weld_profiler/simulation/random_welds.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
constexpr double kFurther = 1.5e-3;  // that the scan after goes on at both ends [m]

SceneParams groundScene(const SceneParams& before, double rest)
{
  constexpr std::uint64_t kOther = 10000;
  SceneParams scene = before;
  scene.seed += kOther;
  scene.spatter.count = 0;
  scene.weld.ripple_height = 0.0;
  scene.weld.reinforcement = rest < 0.0 ? -rest * before.weld.reinforcement : std::min(rest, before.weld.reinforcement);
  scene.part_start -= kFurther;
  scene.scan_length += 2.0 * kFurther;
  return scene;
}

double meanY(const Profile& row)
{
  double sum = 0.0;
  for (const CloudPoint& point : row.points)
    sum += static_cast<double>(point.y);
  return sum / static_cast<double>(row.points.size());
}
}  // namespace

GroundCase::GroundCase(std::uint64_t seed, double rest)
  : before_scene_(randomWeldScene(seed)),
    after_scene_(groundScene(before_scene_, rest)),
    before_truth_(before_scene_),
    after_truth_(after_scene_)
{
  before = simulatedCloud(before_truth_);
  after = simulatedCloud(after_truth_);
  for (Profile& row : after.rows)
    for (CloudPoint& point : row.points)
      point.y -= static_cast<float>(kFurther);  // a cloud's y counts from where its scan began
  from_y_ = meanY(before.rows.front()), to_y_ = meanY(before.rows.back());
  integrate();
}

double GroundCase::surfaceBefore(double x, double y) const
{
  return before_truth_.surfaceHeight(x, y);
}

double GroundCase::surfaceAfter(double x, double y) const
{
  return after_truth_.surfaceHeight(x, y + kFurther);
}

double GroundCase::target(double x, double y) const
{
  return before_truth_.targetHeight(x, y);
}

void GroundCase::integrate()
{
  constexpr double kStep = 5e-5, kHalfField = 0.029;
  for (double y = from_y_ + 0.5 * kStep; y < to_y_; y += kStep)
  {
    for (double x = -kHalfField; x < kHalfField; x += kStep)
    {
      const double z = surfaceAfter(x, y);
      removed += (surfaceBefore(x, y) - z) * kStep * kStep;
      const TrueLabel label = before_truth_.surfaceLabel(x, y);
      if (label == TrueLabel::Bead || label == TrueLabel::Spatter)
        remaining += std::max(0.0, z - target(x, y)) * kStep * kStep;
    }
  }
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
