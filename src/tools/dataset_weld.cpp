#include "tools/dataset_weld.h"

#include <array>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include "tools/simulated_cloud.h"
#include "weld_profiler/scan/labelled_scan.h"
#include "weld_profiler/simulation/random_welds.h"

namespace weld_profiler
{
namespace
{
constexpr double kDegrees = 180.0 / 3.141592653589793;
constexpr double kMm = 1e3;

/// The true label and removal of every point, and how many points have each label.
struct TrueMaps
{
  std::vector<std::uint8_t> labels;
  std::vector<float> removal;
  std::array<std::size_t, 5> counts{};
};

TrueMaps trueMaps(const SimulatedScan& simulated, const Scan& scan)
{
  TrueMaps maps;
  const std::size_t cells = scan.cells;
  maps.labels.assign(scan.rows.size() * cells, 0);
  maps.removal.assign(scan.rows.size() * cells, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t row = 0; row < scan.rows.size(); ++row)
  {
    for (const CloudPoint& point : scan.rows[row].points)
    {
      const auto label = static_cast<std::uint8_t>(simulated.surfaceLabel(point.x, point.y));
      maps.labels[row * cells + point.cell] = label;
      maps.removal[row * cells + point.cell] = static_cast<float>(simulated.removalHeight(point.x, point.y));
      ++maps.counts.at(label);
    }
  }
  return maps;
}

class Line
{
public:
  Line() { text_.imbue(std::locale::classic()), text_.precision(6); }

  Line& operator<<(const std::string& word)
  {
    text_ << separator_ << word;
    separator_ = ",";
    return *this;
  }
  Line& operator<<(double value)
  {
    text_ << separator_;
    if (std::isfinite(value))
      text_ << value;
    separator_ = ",";
    return *this;
  }

  std::string text() const { return text_.str(); }

private:
  std::ostringstream text_;
  const char* separator_ = "";
};

/// The dimensions of the section in the middle of the scan; a weld is the same all along but for ripples.
void addDimensions(const SimulatedScan& simulated, Line& line)
{
  const std::vector<WeldTruth> sections = simulated.weldSections();
  const WeldTruth truth = sections.empty() ? WeldTruth() : sections[sections.size() / 2];
  for (const double length :
       { truth.width, truth.reinforcement, truth.undercut_left, truth.undercut_right, truth.misalignment,
         truth.incomplete_fill, truth.leg_left, truth.leg_right, truth.throat })
    line << length * kMm;
  for (const double angle : { truth.angle, truth.toe_angle_left, truth.toe_angle_right, truth.yaw })
    line << angle * kDegrees;
  line << truth.area * kMm * kMm << simulated.scene().weld.curvature;
  const TrueRipples ripples = simulated.ripples();
  line << ripples.pitch * kMm << ripples.height * kMm << static_cast<double>(simulated.spots().size());
}
}  // namespace

const std::vector<std::string>& datasetColumns()
{
  static const std::vector<std::string> columns = { "file",
                                                    "split",
                                                    "kind",
                                                    "scene_seed",
                                                    "rows",
                                                    "cells",
                                                    "points",
                                                    "unknown",
                                                    "base",
                                                    "bead",
                                                    "undercut",
                                                    "spatter",
                                                    "width_mm",
                                                    "reinforcement_mm",
                                                    "undercut_left_mm",
                                                    "undercut_right_mm",
                                                    "misalignment_mm",
                                                    "incomplete_fill_mm",
                                                    "leg_left_mm",
                                                    "leg_right_mm",
                                                    "throat_mm",
                                                    "angle_deg",
                                                    "toe_angle_left_deg",
                                                    "toe_angle_right_deg",
                                                    "yaw_deg",
                                                    "area_mm2",
                                                    "curvature_per_m",
                                                    "ripple_pitch_mm",
                                                    "ripple_height_mm",
                                                    "spots" };
  return columns;
}

std::string writeDatasetCloud(const DatasetEntry& entry, const std::string& path)
{
  const SimulatedScan simulated(randomWeldScene(entry.scene_seed));
  const Scan scan = simulatedCloud(simulated);
  const TrueMaps maps = trueMaps(simulated, scan);
  std::size_t points = 0;
  for (const Profile& row : scan.rows)
    points += row.points.size();
  saveLabelledScan(scan, ScanLabels{ maps.labels, maps.removal }, path);
  Line line;
  line << entry.file << entry.split << simulated.scene().weld.kind << std::to_string(entry.scene_seed);
  for (const std::size_t count : { scan.rows.size(), static_cast<std::size_t>(scan.cells), points })
    line << std::to_string(count);
  for (const std::size_t count : maps.counts)
    line << std::to_string(count);
  addDimensions(simulated, line);
  return line.text();
}
}  // namespace weld_profiler
