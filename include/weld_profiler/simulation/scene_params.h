#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "weld_profiler/geometry/calibration.h"
#include "weld_profiler/simulation/scene_part.h"

namespace weld_profiler
{
/// Laser sheet, lens and how the surface scatters.
struct SceneLaser
{
  double sigma_px = 2.0;            ///< 1-sigma of the stripe across itself on the flat plate, lens included [px]
  double lens_sigma_px = 1.2;       ///< share of lens and pixel, the same in every direction [px], < sigma_px
  double peak = 180.0;              ///< stripe on the flat plate, above background [DN of 8 bit]; above 255 clips
  double standoff = 0.2;            ///< of the emitter from the surface [m]
  double shading = 1.0;             ///< 0 = brightness ignores the slope, 1 = Lambert's cosine
  double specular = 0.0;            ///< gloss: brightness added at mirror slope, times the peak
  double specular_width_deg = 6.0;  ///< 1-sigma of the gloss about the mirror slope [deg]
  double bead_reflectance = 1.0;    ///< of the bead relative to the plates
  double interreflection = 0.0;     ///< share of the light that the surface mirrors onto itself, 0 = off
  double ghost = 0.0;               ///< share in the filter's second image of the stripe, 0 = off
  double ghost_offset_px = 14.0;    ///< across the stripe [px]
  double glow = 0.0;                ///< share in the halo around the stripe, 0 = off
  double glow_sigma_px = 30.0;      ///< [px]

  template <class V>
  void visit(V&& v)
  {
    v("sigma_px", sigma_px), v("lens_sigma_px", lens_sigma_px), v("peak", peak), v("standoff", standoff);
    v("shading", shading), v("specular", specular), v("specular_width_deg", specular_width_deg);
    v("bead_reflectance", bead_reflectance), v("interreflection", interreflection), v("ghost", ghost);
    v("ghost_offset_px", ghost_offset_px), v("glow", glow), v("glow_sigma_px", glow_sigma_px);
  }
};

/// Speckle, fixed to the surface.
struct SceneSpeckle
{
  double contrast = 0.1;  ///< standard deviation over mean, 0 = off, at most 1
  double grain_px = 2.0;  ///< full width at half maximum of its autocovariance on the flat plate [px], 1..20

  template <class V>
  void visit(V&& v)
  {
    v("contrast", contrast), v("grain_px", grain_px);
  }
};

/// Noise and encoding. Shot noise follows from snr: see docs/simulation.md.
struct SceneSensor
{
  std::string encoding = "mono8";  ///< mono8, mono16, bayer_rggb8, bgr8
  bool noise = true;               ///< shot and read noise
  double snr = 50.0;               ///< stripe's peak over its standard deviation (shot, read, quantisation)
  double read_noise = 1.2;         ///< [DN of 8 bit]
  double black_level = 5.0;        ///< [DN of 8 bit]

  template <class V>
  void visit(V&& v)
  {
    v("encoding", encoding), v("noise", noise), v("snr", snr), v("read_noise", read_noise);
    v("black_level", black_level);
  }
};

/// Light that is not the laser's. Levels as the camera would see them without the filter [DN of 8 bit].
struct SceneLight
{
  bool filter = true;                 ///< the band-pass filter is on the lens
  double ambient = 0.0;               ///< room light on the part
  double ambient_transmission = 0.1;  ///< share of it that passes the filter
  double arc = 0.0;                   ///< a welding arc beside the field, at its brightest spot
  double arc_transmission = 0.04;     ///< share of it that passes the filter
  double flash_share = 0.0;           ///< share of frames that an arc flash hits, seeded
  double flash = 3000.0;              ///< level of a flash
  int sparks = 0;                     ///< flying sparks in a frame

  template <class V>
  void visit(V&& v)
  {
    v("filter", filter), v("ambient", ambient), v("ambient_transmission", ambient_transmission), v("arc", arc);
    v("arc_transmission", arc_transmission), v("flash_share", flash_share), v("flash", flash), v("sparks", sparks);
  }
};

/// One scene: part, rig, motion, light. The defaults are the preset `realistic`.
struct SceneParams
{
  std::uint64_t seed = 1;

  // time
  double start_time = 1000.0;  ///< stamp of the first frame [s]
  double frame_rate = 20.0;    ///< [1/s]
  int frame_count = 0;         ///< 0 = as many as scan_length needs at `speed`
  double scan_length = 0.050;  ///< [m]
  double exposure = 0.005;     ///< [s]
  bool motion_blur = true;

  // motion
  std::string motion = "stage";  ///< stage, or tf: the sensor's pose in a fixed frame moves and turns
  bool part_moves = false;       ///< the part moves along `stage.axis` under a fixed sensor: the true axis is -axis
  double start_position = 0.0;   ///< of the stage at the first frame [m]
  double part_start = 0.0;       ///< part y over which the scan begins [m]
  double speed = 0.005;          ///< mean, < 0 = the stage's position falls [m/s]
  double speed_variation = 0.0;  ///< amplitude over mean, 0..0.95
  double speed_period = 2.0;     ///< of the variation [s]
  double tf_rotation_deg = 6.0;  ///< with tf: the sensor's turn over the whole scan [deg]
  std::array<double, 3> tf_axis{ { 0.5, 0.5, 0.7 } };  ///< with tf: about which, scan frame
  double pose_rate = 250.0;                            ///< with tf: poses a second [1/s]

  // encoder
  double encoder_rate = 500.0;      ///< [1/s]
  double encoder_resolution = 0.0;  ///< positions are rounded to multiples of it [m], 0 = exact

  double rig_roll_deg = 0.0;  ///< camera turned about its optical axis; 90 lets the stripe run along v [deg]

  ScenePlates plates;
  SceneWeld weld;
  SceneBlock gauge;   ///< a step of known height
  SceneBlock marker;  ///< makes the part chiral
  SceneSpatter spatter;
  ScenePores pores;
  SceneSecondBead second_bead;
  SceneLaser laser;
  SceneSpeckle speckle;
  SceneSensor sensor;
  SceneLight light;
  Calibration
      calibration;  ///< YAML: `camera`, `laser_plane`, `stage`, as in a calibration file; before roll and part_moves

  template <class V>
  void visit(V&& v)
  {
    v("seed", seed), v("start_time", start_time), v("frame_rate", frame_rate), v("frame_count", frame_count);
    v("scan_length", scan_length), v("exposure", exposure), v("motion_blur", motion_blur), v("motion", motion);
    v("part_moves", part_moves), v("start_position", start_position), v("part_start", part_start), v("speed", speed);
    v("speed_variation", speed_variation), v("speed_period", speed_period), v("tf_rotation_deg", tf_rotation_deg);
    v("tf_axis", tf_axis), v("pose_rate", pose_rate), v("encoder_rate", encoder_rate);
    v("encoder_resolution", encoder_resolution), v("rig_roll_deg", rig_roll_deg);
  }

  /// Calls v(name, struct) for each section but the calibration's.
  template <class V>
  void visitSections(V&& v)
  {
    v("plates", plates), v("weld", weld), v("gauge", gauge), v("marker", marker), v("spatter", spatter);
    v("pores", pores), v("second_bead", second_bead);
    v("laser", laser), v("speckle", speckle), v("sensor", sensor), v("light", light);
  }

  /// @throws ConfigError naming field, value and range.
  void validate() const;
};

/// Known presets: realistic, harsh.
const std::vector<std::string>& presetNames();

/// @throws ConfigError naming the known presets.
SceneParams scenePreset(const std::string& name);

/// Reads a scene file. It starts from `preset: NAME` (default realistic) and sets what it names; an unknown key is an
/// error. The result is validated.
/// @throws InputError (cannot be read) or ConfigError (content), naming file, key and remedy.
SceneParams loadScene(const std::string& path);

/// Writes every field of a scene, so that loadScene() gives it back. @throws InputError naming the path.
void saveScene(const SceneParams& scene, const std::string& path);
}  // namespace weld_profiler
