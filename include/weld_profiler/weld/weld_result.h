#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weld_profiler/weld/weld_section.h"
#include "weld_profiler/weld/weld_spot.h"

namespace weld_profiler
{
/// What a point of the scan belongs to. Values as the field `label` of weld_points.
enum class WeldLabel : std::uint8_t
{
  Unknown = 0,
  Base = 1,
  Bead = 2,
  Undercut = 3,
  Spatter = 4
};

/// How well a scan agrees with a kind of weld: 0 = not at all, 1 = as well as can be.
struct KindScore
{
  WeldKind kind = WeldKind::None;
  double score = 0.0;
};

/// A point of the weld's path: the middle between the toes, seen from above.
struct WeldPathPoint
{
  double s = 0.0;           ///< along the path from the bead's end at the least y [m]
  double x = 0.0, y = 0.0;  ///< in the cloud's frame [m]
  double yaw = 0.0;         ///< against the scan axis y, from +y toward -x [rad]
};

/// A bead that was seen beside the one that was measured.
struct OtherBead
{
  double x = 0.0, y_from = 0.0, y_to = 0.0;  ///< middle across, extent along, in the cloud's frame [m]
  double width = 0.0, height = 0.0;          ///< as seen in the rows, roughly [m]
};

/// One quantity along the weld, over the sections where it was measured.
struct SectionStatistics
{
  const char* name = "";  ///< width, reinforcement, ...: the field of WeldSection
  int count = 0;
  Quantity mean;           ///< with the uncertainty of the mean
  double deviation = 0.0;  ///< standard deviation along the weld
  double least = 0.0, largest = 0.0;
};

/// All that was measured of one scan. Maps are organised as the scan: a row a row of it, a column a cell.
struct WeldResult
{
  WeldKind kind = WeldKind::None;
  std::vector<KindScore> scores;      ///< one a known kind, falling
  std::string reason;                 ///< why there is no weld, or what could not be measured; empty = nothing to say
  std::vector<WeldSection> sections;  ///< rising s
  std::vector<WeldSpot> spots;
  /// Pits in the face that may be pores or not: they touch a toe, a ball of spatter, an end of the bead or what was not
  /// measured, are no pore's shape, or no more than the outliers of the scan make. Sigma of the diameter: half of it, for
  /// as much of it may be hidden.
  std::vector<WeldSpot> hollows;
  std::vector<WeldPathPoint> path;  ///< one a section
  std::vector<OtherBead> other_beads;

  /// Of the bead along its path, as far as the scan shows it, from the first section with a bead to the last and half a
  /// step more at either end, as the volumes; sigma = a step [m].
  Quantity length;
  double measured_share = 0.0;  ///< of the sections, with a width
  Quantity volume;              ///< between face and chord, over the measured sections [m^3]
  Quantity removal_volume;      ///< above the target, without spatter, over the measured sections [m^3]
  double volume_length = 0.0;   ///< of weld that both volumes are of [m]
  Quantity ripple_pitch;        ///< NaN = no ripples beyond doubt [m]
  Quantity ripple_height;       ///< crest to trough [m]
  std::vector<SectionStatistics> statistics;

  std::uint32_t rows = 0, cells = 0;
  std::vector<std::uint8_t> labels;  ///< rows x cells, WeldLabel
  std::vector<float> removal;        ///< rows x cells, height above the target, >= 0, NaN unknown [m]
  std::vector<float> target;         ///< rows x cells, z of the target surface at the point, NaN unknown [m]

  UnseenPores unseen_pores;
  bool runs_out = false;  ///< of the scan, at either end: the weld may be longer than was seen

  bool hasWeld() const { return kind != WeldKind::None; }
};
}  // namespace weld_profiler
