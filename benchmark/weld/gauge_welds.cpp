#include "weld/gauge_welds.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include "tools/simulated_cloud.h"
#include "weld/spread.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
using comparison::Report;
constexpr double kMm = 1e-3;
constexpr double kPlain = 3e-3;    // of plate before the weld begins and behind its end [m]
constexpr double kEvery = 5e-3;    // between readings [m]
constexpr double kReading = 1e-4;  // a gauge is read to this, and this wrong at most [m]

/// A weld and the height that a gauge reads of it.
struct GaugeWeld
{
  const char* name;
  const char* height_name;
  SceneParams scene;
  double WeldTruth::*true_height;
  Quantity WeldSection::*height;
};

SceneParams sceneOf(std::uint64_t seed, const char* kind)
{
  SceneParams scene = scenePreset("realistic");
  scene.seed = seed;
  scene.weld.kind = kind;
  scene.weld.length = 50.0 * kMm;
  scene.weld.start = kPlain;
  scene.scan_length = scene.weld.length + 2.0 * kPlain;
  scene.speed = 0.2 * kMm * scene.frame_rate;
  scene.weld.ripple_pitch = 1.5 * kMm;
  scene.weld.ripple_height = 0.08 * kMm;
  return scene;
}

std::vector<GaugeWeld> gaugeWelds()
{
  GaugeWeld butt{ "butt", "reinforcement", sceneOf(501, "butt"), &WeldTruth::reinforcement,
                  &WeldSection::reinforcement };
  butt.scene.plates.misalignment = 0.3 * kMm;
  butt.scene.weld.width = 11.0 * kMm;
  butt.scene.weld.reinforcement = 1.8 * kMm;
  butt.scene.weld.undercut_left = 0.25 * kMm;
  GaugeWeld fillet{ "fillet", "throat", sceneOf(502, "fillet"), &WeldTruth::throat, &WeldSection::throat };
  fillet.scene.plates.angle_deg = 88.0;
  fillet.scene.plates.height = -13.0 * kMm;
  fillet.scene.weld.width = 9.0 * kMm;
  fillet.scene.weld.reinforcement = 0.7 * kMm;
  GaugeWeld bead{ "bead on plate, yawed 8 deg", "reinforcement", sceneOf(503, "bead_on_plate"),
                  &WeldTruth::reinforcement, &WeldSection::reinforcement };
  bead.scene.weld.width = 7.5 * kMm;
  bead.scene.weld.reinforcement = 2.2 * kMm;
  bead.scene.weld.yaw_deg = 8.0;
  bead.scene.weld.crest_offset = 0.1;
  return { butt, fillet, bead };
}

double rounded(double value)
{
  return std::round(value / kReading) * kReading;
}

comparison::Field millimetres(const char* key, double metres)
{
  return { key, 1e3 * metres, 3 };
}

void reportReadings(const GaugeWeld& weld, const SimulatedScan& simulated, Report& report)
{
  std::mt19937_64 random(weld.scene.seed);  // its numbers are the standard's; a distribution's are not
  const auto reading = [&random](double truth)
  { return rounded(truth + kReading * (2.0 * static_cast<double>(random() >> 11) * 0x1p-53 - 1.0)); };
  double next = 0.5 * kEvery;
  for (const WeldTruth& truth : simulated.weldSections())
  {
    report.row({ { "weld", weld.name },
                 { "source", "truth" },
                 millimetres("s_mm", truth.s),
                 millimetres("width_mm", truth.width),
                 millimetres("height_mm", truth.*weld.true_height) },
               Report::Silent);
    if (truth.s < next)
      continue;
    next += kEvery;
    const double width = reading(truth.width);
    report.row({ { "weld", weld.name },
                 { "source", "gauge" },
                 millimetres("s_mm", truth.s),
                 millimetres("width_mm", width),
                 millimetres("height_mm", reading(truth.*weld.true_height)) },
               Report::Silent);
  }
}

void reportSections(const GaugeWeld& weld, const SimulatedScan& simulated, Report& report)
{
  const WeldResult result = WeldMeasurer().measure(simulatedCloud(simulated));
  std::vector<double> widths, heights;
  for (const WeldSection& section : result.sections)
  {
    if (!section.width.measured())
      continue;
    const std::optional<WeldTruth> truth =
        simulated.weldSection(0.5 * (section.toe_left.x.value + section.toe_right.x.value),
                              0.5 * (section.toe_left.y.value + section.toe_right.y.value));
    if (!truth)
      continue;
    const Quantity& height = section.*weld.height;
    widths.push_back(std::abs(section.width.value - truth->width));
    if (height.measured())
      heights.push_back(std::abs(height.value - (*truth).*weld.true_height));
    report.row({ { "weld", weld.name },
                 { "source", "scan" },
                 millimetres("s_mm", truth->s),
                 millimetres("width_mm", section.width.value),
                 millimetres("width_sigma_mm", section.width.sigma),
                 millimetres("height_mm", height.value),
                 millimetres("height_sigma_mm", height.sigma),
                 { "height", weld.height_name } },
               Report::Silent);
  }
  report.row({ { "weld", weld.name },
               { "source", "summary" },
               { "kind", name(result.kind) },
               { "sections", static_cast<double>(widths.size()), 0 },
               millimetres("width 95 %", quantile(widths, 0.95)),
               millimetres("height 95 %", quantile(heights, 0.95)) });
}
}  // namespace

void reportGaugeWelds(Report& report)
{
  report.table("gauge", "three welds of 50 mm against gauge readings; |error| of the scan against the truth [mm]");
  for (const GaugeWeld& weld : gaugeWelds())
  {
    const SimulatedScan simulated(weld.scene);
    reportReadings(weld, simulated, report);
    reportSections(weld, simulated, report);
  }
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
