#include "face_window.h"

#include <algorithm>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kShareOfWidth = 0.4;  // the face at a toe is at most this share of the weld
constexpr double kLeastWindow = 3e-4;  // [m]
}  // namespace

double faceReach(double width, const WeldParams& params)
{
  return std::max(params.edge_blur + kLeastWindow, std::min(params.face_length, kShareOfWidth * width));
}

std::vector<FacePoint> faceWindow(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& toe, double reach,
                                  const WeldParams& params)
{
  std::vector<FacePoint> chosen;
  for (const Eigen::Vector2d& point : points)
  {
    if (point.x() < toe.x() || point.x() > toe.x() + reach)
      continue;
    const double distance = (point - toe).norm();
    if (distance < params.edge_blur || distance > reach)
      continue;
    chosen.push_back(FacePoint{ point, 1.0 - 0.8 * square(distance / reach) });
  }
  // no guess across a gap: the face must be seen near the toe
  if (chosen.size() < 6 || (chosen.front().place - toe).norm() > params.edge_blur + params.max_gap)
    chosen.clear();
  return chosen;
}
}  // namespace weld
}  // namespace weld_profiler
