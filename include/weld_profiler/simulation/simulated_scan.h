#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "weld_profiler/core/stamp.h"
#include "weld_profiler/core/stripe.h"
#include "weld_profiler/geometry/calibration.h"
#include "weld_profiler/simulation/scene_params.h"
#include "weld_profiler/simulation/weld_truth.h"

namespace weld_profiler
{
/// What is true of one cell of one frame, at the middle of its exposure.
struct TruthCentre
{
  std::uint16_t cell = 0;
  double u = 0.0, v = 0.0;           ///< true centre of the stripe in this column (row) [px], raw
  double normal_angle = 0.0;         ///< as StripePoint::normal_angle [rad]
  double x = 0.0, y = 0.0, z = 0.0;  ///< the surface point, in the cloud's frame [m]
  bool visible = true;  ///< lit by the laser and seen by the camera, inside the image, no second sheet in front
};

/// One encoder sample: what a JointState would say.
struct SimulatedEncoderSample
{
  Stamp stamp = 0;
  double position = 0.0;  ///< joint position, in the joint's units
};

/// Camera pose in the fixed frame, for motion through tf: p_fixed = rotation * p_camera + translation.
struct SimulatedPose
{
  Stamp stamp = 0;
  std::array<double, 9> rotation{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 } };  ///< row major
  std::array<double, 3> translation{};                              ///< [m]
};

/// One scan of one scene, as a digital twin of the rig: images, encoder, truth. Deterministic for a scene (seed
/// included). Shares no code with stripe and geometry: it projects and distorts with its own. Const methods are thread
/// safe.
class SimulatedScan
{
public:
  /// @throws ConfigError naming field, value and range.
  explicit SimulatedScan(const SceneParams& scene);
  ~SimulatedScan();

  int frameCount() const;
  Stamp stamp(int frame) const;             ///< middle of the exposure; the scan's first frame is at scene.start_time
  double stagePosition(Stamp stamp) const;  ///< true position [m]

  int width() const;  ///< of the image [px]
  int height() const;
  std::string encoding() const;  ///< mono8, mono16, bayer_rggb8 or bgr8
  std::size_t step() const;

  /// Renders a frame. @param pixels resized to step() * height(). @throws PreconditionError unless the scan has it.
  void render(int frame, std::vector<std::uint8_t>& pixels) const;

  /// True centre line of a frame: one entry for each cell that the laser sheet's image crosses, rising cells.
  std::vector<TruthCentre> truth(int frame) const;

  std::vector<SimulatedEncoderSample> encoder() const;  ///< from before the first frame to after the last
  std::vector<SimulatedPose> poses() const;             ///< with scene.motion tf; else empty
  const Calibration& calibration() const;               ///< the true one
  Direction direction() const;                          ///< along which the stripe runs
  const SceneParams& scene() const;

  /// True surface as a height over the cloud's x and y [m].
  double surfaceHeight(double x, double y) const;
  /// What the scan passes over, in the cloud's frame: x from, x to, y from, y to [m].
  std::array<double, 4> extent() const;
  /// True dimensions of the bead, one section for each frame whose sheet crosses the weld, rising frames.
  std::vector<WeldTruth> weldSections() const;
  /// The same for the section through a point of the cloud's frame; row and stage are those of the nearest frame.
  /// @return none where there is no bead.
  std::optional<WeldTruth> weldSection(double x, double y) const;
  /// Volume between the bead's face and the chords of its toes from one s to another, 0 = the weld's first end [m^3].
  /// Where the face is lower it counts negative; spatter, pores, blocks and the second bead do not count.
  double weldVolume(double from_s, double to_s) const;
  /// What the point of the surface belongs to.
  TrueLabel surfaceLabel(double x, double y) const;
  /// The target of grinding, as a height over the cloud's x and y: inside the bead the chord of its toes and a rest
  /// above it along its normal, outside the parent plates [m].
  double targetHeight(double x, double y, double rest = 0.0) const;
  /// What must come off, along z: true surface, spatter and pores included, above that target; >= 0, NaN on a block
  /// [m].
  double removalHeight(double x, double y, double rest = 0.0) const;
  TrueRipples ripples() const;
  /// Spatter and pores, in the order in which they were placed.
  std::vector<TrueSpot> spots() const;

private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};
}  // namespace weld_profiler
