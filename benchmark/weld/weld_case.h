#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace weld_profiler
{
namespace weld_accuracy
{
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The sizes of a section that are compared. SI.
enum Size
{
  Width,
  Reinforcement,
  HeightLeft,
  HeightRight,
  UndercutLeft,
  UndercutRight,
  Misalignment,
  ToeAngleLeft,
  ToeAngleRight,
  Angle,
  Area,
  IncompleteFill,
  LegLeft,
  LegRight,
  Throat,
  kSizes
};
extern const std::array<const char*, kSizes> kSizeNames;

/// What was measured of one size, and what is true. NaN = not measured, or there is no truth.
struct Deviation
{
  double value = kNaN, sigma = kNaN, truth = kNaN;

  double error() const { return value - truth; }
  bool known() const { return error() == error() && sigma == sigma; }
};

/// Which sections the bars hold for.
enum class Stature
{
  Low,        ///< below the threshold: reinforcement under 0.5 mm or a flank under 20 deg
  LowFillet,  ///< a fillet with flanks of 20 deg and more whose face rises less than 0.5 mm above its chord
  High        ///< at the threshold or above
};

/// One measured section beside the true one through the same place.
struct SectionCase
{
  double s = kNaN;  ///< along the true path [m]
  Stature stature = Stature::Low;
  std::array<Deviation, kSizes> sizes;
  std::string verdict;       ///< of WeldJudge; empty = none, or it waits for what was not measured
  std::string true_verdict;  ///< of the true sizes, after this folder's own reading of the limits
  double clearance = 0.0;    ///< from the truth to the nearest limit, in sigmas; 0 = a size that decides is missing

  /// The truth lies so far from every limit that a verdict is due.
  bool clear() const { return clearance > 4.0; }
  bool hasBead() const { return sizes[Width].sigma == sizes[Width].sigma; }
};

/// How many true sections there are of each stature, and how many of them were measured.
struct Shares
{
  std::array<int, 3> inside{};        ///< with their toes and the plates beside them in the scan
  std::array<int, 3> inside_found{};  ///< ... measured
  std::array<int, 3> toes{};          ///< with their toes in the scan
  std::array<int, 3> toes_found{};
};

/// Volumes [m^3], and the length of weld that they are of [m].
struct Volumes
{
  double measured = kNaN, truth = kNaN, length = kNaN;
  double removal = kNaN, true_removal = kNaN;
  double unknown_removal = kNaN;  ///< true removal at points for which the map has no value; counted in the truth
};

/// Balls of spatter and pores of one range of diameters.
struct SpotClass
{
  int inside = 0;                       ///< that lie wholly in the scan
  int found = 0;                        ///< ... told
  double diameter = 0.0, height = 0.0;  ///< sums of the told ones' |errors| [m]
};
constexpr std::array<double, 3> kSpotClasses = { 0.0, 0.3e-3, 0.5e-3 };  ///< diameters from which on [m]

struct Spots
{
  std::array<SpotClass, 3> classes;
  int false_spatter = 0, false_pores = 0;  ///< told where there is none
};

/// Milliseconds of processor time.
struct Times
{
  double measure = kNaN;   ///< of the whole scan
  double row_mean = kNaN;  ///< of one provisional section
  double row_worst = kNaN;
};

/// All that one weld tells.
struct WeldCase
{
  std::uint64_t seed = 0;
  std::string kind, measured_kind;
  double width = kNaN, reinforcement = kNaN;  ///< true, in the middle of the scan [m]
  double thickness = kNaN;                    ///< after which it was judged [m]
  bool judge_toe_angle = false;
  int rows = 0, cells = 0;
  Shares shares;
  Volumes volumes;
  Times times;
  Spots spots;
  std::array<std::array<long, 5>, 5> labels{};  ///< points by true and by measured label
  std::vector<SectionCase> sections;
};

/// Calls visit(name, value) for all plain numbers of a case.
template <class Case, class Visit>
void visitNumbers(Case& weld, Visit&& visit)
{
  visit("width", weld.width), visit("reinforcement", weld.reinforcement), visit("thickness", weld.thickness);
  visit("judge_toe_angle", weld.judge_toe_angle), visit("rows", weld.rows), visit("cells", weld.cells);
  visit("volume", weld.volumes.measured), visit("true_volume", weld.volumes.truth);
  visit("length", weld.volumes.length), visit("removal", weld.volumes.removal);
  visit("true_removal", weld.volumes.true_removal), visit("unknown_removal", weld.volumes.unknown_removal);
  visit("measure_ms", weld.times.measure), visit("row_mean_ms", weld.times.row_mean);
  visit("row_worst_ms", weld.times.row_worst);
  for (auto& spots : weld.spots.classes)
  {
    visit("spots", spots.inside), visit("spots_found", spots.found);
    visit("spots_diameter", spots.diameter), visit("spots_height", spots.height);
  }
  visit("false_spatter", weld.spots.false_spatter), visit("false_pores", weld.spots.false_pores);
  for (auto* counts : { &weld.shares.inside, &weld.shares.inside_found, &weld.shares.toes, &weld.shares.toes_found })
  {
    for (auto& count : *counts)
      visit("sections", count);
  }
  for (auto& row : weld.labels)
  {
    for (auto& count : row)
      visit("points", count);
  }
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
