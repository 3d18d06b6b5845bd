#pragma once

#include <string>

namespace weld_profiler
{
// Every struct offers its fields to a visitor (core/yaml_fields.h), so a name stands in one place only. Lengths [m].
// Part coordinates: x to the right and y along the scan as in the scan frame, y = 0 where the scan begins, z = 0 on the
// plates' surface at the weld.

/// Two plates, left and right of the weld. A fillet's stand at angle_deg 90: each rises outward by 45 deg.
struct ScenePlates
{
  double x = 0.0;             ///< where the seam's middle lies across the field [m], +-0.1
  double height = 0.0;        ///< of the surface above the scan frame's origin [m], +-0.05
  double misalignment = 0.0;  ///< right plate above the left at the seam [m], +-0.01
  double angle_deg = 0.0;     ///< angle between the plates, > 0 = both rise outward [deg], +-120
  double tilt_deg = 0.0;      ///< of the pair about the seam, > 0 = the right plate rises more [deg], +-40

  template <class V>
  void visit(V&& v)
  {
    v("x", x), v("height", height), v("misalignment", misalignment), v("angle_deg", angle_deg);
    v("tilt_deg", tilt_deg);
  }
};

/// A weld bead: circular segment above the chord of its toes. Its kind says what the plates are: `butt` two plates,
/// maybe misaligned; `fillet` two plates that rise outward from the root, no misalignment; `bead_on_plate` one plate.
struct SceneWeld
{
  std::string kind = "butt";       ///< butt, fillet, bead_on_plate
  double width = 0.010;            ///< distance of the toes, level [m], 0 = no weld
  double reinforcement = 0.002;    ///< height of the crest above the chord, without ripples; < 0 = concave [m]
  double crest_offset = 0.0;       ///< of the crest to the right, as a share of half the width, +-0.3
  double start = 0.0;              ///< part y of its first end (before yaw) [m]
  double length = 0.050;           ///< [m]
  double end_length = 0.004;       ///< over which width and height rise at its ends [m]
  double tack_length = 0.0;        ///< of each of several short beads along the path, 0 = one bead [m]
  double tack_gap = 0.010;         ///< between them [m]
  double crater_start = 0.0;       ///< depth of the crater at a bead's first end [m]
  double crater_end = 0.0;         ///< at its last end [m]
  double crater_length = 0.004;    ///< deepest in the middle of it, which begins at the end [m]
  double yaw_deg = 0.0;            ///< of its middle's tangent from +y toward -x [deg], +-30
  double curvature = 0.0;          ///< of its path, > 0 = bends to the right [1/m], +-10
  double ripple_height = 0.0;      ///< crest to trough [m]
  double ripple_pitch = 0.0012;    ///< [m]
  double undercut_left = 0.0;      ///< depth, along z [m]
  double undercut_right = 0.0;     ///< depth, along z [m]
  double undercut_width = 0.0012;  ///< level [m]

  template <class V>
  void visit(V&& v)
  {
    v("kind", kind), v("width", width), v("reinforcement", reinforcement), v("crest_offset", crest_offset);
    v("start", start), v("length", length), v("end_length", end_length), v("tack_length", tack_length);
    v("tack_gap", tack_gap), v("crater_start", crater_start), v("crater_end", crater_end);
    v("crater_length", crater_length), v("yaw_deg", yaw_deg), v("curvature", curvature);
    v("ripple_height", ripple_height), v("ripple_pitch", ripple_pitch), v("undercut_left", undercut_left);
    v("undercut_right", undercut_right), v("undercut_width", undercut_width);
  }
};

/// A second bead on one of the plates, parallel to the first and as long, tacked where it is, without ripples.
struct SceneSecondBead
{
  double offset = 0.020;         ///< of its middle to the right of the first bead's path, level [m], +-0.05
  double width = 0.0;            ///< level [m], 0 = none
  double reinforcement = 0.001;  ///< above the plate, along z [m]

  template <class V>
  void visit(V&& v)
  {
    v("offset", offset), v("width", width), v("reinforcement", reinforcement);
  }
};

/// Pores open to the bead's surface, at seeded places: each a spherical cap's pit.
struct ScenePores
{
  int count = 0;                 ///< along the whole weld, 0..500; fewer where there is no room
  double diameter_min = 0.0005;  ///< [m]
  double diameter_max = 0.0015;  ///< [m]
  double depth = 0.3;            ///< over the diameter, 0.05..0.5

  template <class V>
  void visit(V&& v)
  {
    v("count", count), v("diameter_min", diameter_min), v("diameter_max", diameter_max), v("depth", depth);
  }
};

/// A block with vertical walls on the plates: a gauge step, a mark in a corner.
struct SceneBlock
{
  double height = 0.0;   ///< above the plate under it [m], 0 = no block
  double x = 0.0;        ///< part x of its middle [m]
  double y = 0.0;        ///< part y of its first edge [m]
  double width = 0.01;   ///< across [m]
  double length = 0.01;  ///< along y [m]

  template <class V>
  void visit(V&& v)
  {
    v("height", height), v("x", x), v("y", y), v("width", width), v("length", length);
  }
};

/// Balls of spatter, stuck on at seeded places.
struct SceneSpatter
{
  int count = 0;               ///< 0..2000
  double radius_min = 0.0002;  ///< [m]
  double radius_max = 0.0006;  ///< [m]

  template <class V>
  void visit(V&& v)
  {
    v("count", count), v("radius_min", radius_min), v("radius_max", radius_max);
  }
};
}  // namespace weld_profiler
