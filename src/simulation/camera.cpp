#include "simulation/camera.h"

namespace weld_profiler
{
namespace simulation
{
namespace
{
/// plumb_bob (Brown 1966, as in sensor_msgs/CameraInfo): k1 k2 p1 p2 k3.
Eigen::Vector2d distort(const Eigen::Vector2d& ideal, const std::array<double, 5>& k)
{
  const double x = ideal.x();
  const double y = ideal.y();
  const double r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
  return { x * radial + 2.0 * k[2] * x * y + k[3] * (r2 + 2.0 * x * x),
           y * radial + k[2] * (r2 + 2.0 * y * y) + 2.0 * k[3] * x * y };
}
}  // namespace

Camera::Camera(const CameraCalibration& calibration)
  : calibration_(calibration),
    width_(calibration.roi_width > 0 ? calibration.roi_width : calibration.image_width),
    height_(calibration.roi_height > 0 ? calibration.roi_height : calibration.image_height)
{
}

Eigen::Vector2d Camera::project(const Eigen::Vector3d& point) const
{
  const Eigen::Vector2d bent = distort(point.head<2>() / point.z(), calibration_.distortion);
  return { calibration_.fx * bent.x() + calibration_.cx - calibration_.roi_x,
           calibration_.fy * bent.y() + calibration_.cy - calibration_.roi_y };
}

Eigen::Vector3d Camera::ray(const Eigen::Vector2d& pixel) const
{
  const Eigen::Vector2d bent((pixel.x() + calibration_.roi_x - calibration_.cx) / calibration_.fx,
                             (pixel.y() + calibration_.roi_y - calibration_.cy) / calibration_.fy);
  constexpr int kIterations = 50;  // contracts by the distortion's slope (well under 0.5) each time
  Eigen::Vector2d ideal = bent;
  for (int i = 0; i < kIterations; ++i)
    ideal += bent - distort(ideal, calibration_.distortion);
  return { ideal.x(), ideal.y(), 1.0 };
}
}  // namespace simulation
}  // namespace weld_profiler
