#pragma once

#include "weld_profiler/core/profile.h"
#include "weld_profiler/core/stripe.h"
#include "weld_profiler/geometry/calibration.h"
#include "weld_profiler/geometry/camera_model.h"

namespace weld_profiler
{
/// Cuts the viewing ray of each stripe centre with the laser plane. Immutable, thread safe.
class Triangulator
{
public:
  /// @throws ConfigError as validateCalibration.
  explicit Triangulator(const Calibration& calibration);

  /// @param stripe   centres in raw pixels of the calibrated image.
  /// @param profile  points in the camera optical frame [m], same order; stamp and frame are left as they are. A centre
  ///                 whose ray does not meet the plane in front of the camera (within 1000 m), or whose numbers are not
  ///                 finite, is left out. `spread` carries stripe.sigma along the stripe's normal through the
  ///                 triangulation (first order); its sign means nothing.
  /// @throws PreconditionError when the stripe's arrays differ in length, or its cells do not rise or leave the image.
  void triangulate(const Stripe& stripe, SensorProfile& profile) const;

  const Calibration& calibration() const { return calibration_; }
  const CameraModel& camera() const { return camera_; }

private:
  bool triangulatePoint(const StripePoint& centre, SensorPoint& point) const;

  Calibration calibration_;
  CameraModel camera_;
  Eigen::Vector3d normal_;
  double distance_ = 0.0;
};
}  // namespace weld_profiler
