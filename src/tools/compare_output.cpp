#include "tools/compare_output.h"

#include <cmath>
#include <filesystem>
#include <locale>
#include <sstream>
#include <vector>

#include "tools/run_command.h"
#include "tools/staged_output.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/origin.h"
#include "weld_profiler/scan/float_maps.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;

JsonObject json(const Quantity& quantity)
{
  JsonObject object;
  return object.add("value", quantity.value).add("sigma", quantity.sigma);
}

std::vector<double> numbers(const Eigen::Vector3d& vector)
{
  return { vector.x(), vector.y(), vector.z() };
}

JsonObject alignedOf(const ScanAlignment& aligned)
{
  const Eigen::Matrix<double, 6, 1> sigma = aligned.covariance.diagonal().cwiseSqrt();
  std::vector<double> rows;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      rows.push_back(aligned.before_T_after(row, column));
  JsonObject told;
  told.add("across", aligned.across_told)
      .add("along", aligned.along_told)
      .add("turn", aligned.turn_told)
      .add("by_toes", aligned.by_toes)
      .add("by_undercuts", aligned.by_undercuts);
  JsonObject object;
  object.add("shift", numbers(aligned.shift))
      .add("shift_sigma", numbers(sigma.head<3>()))
      .add("rotation", numbers(aligned.rotation))
      .add("rotation_sigma", numbers(sigma.tail<3>()))
      .add("residual", aligned.residual)
      .add("about", numbers(aligned.about))
      .add("before_T_after", rows)
      .add("told", told);
  return object;
}

std::vector<JsonObject> spotsOf(const ScanComparison& comparison)
{
  std::vector<JsonObject> spots;
  for (const OverGroundSpot& spot : comparison.over_ground)
  {
    JsonObject object;
    object.add("x", spot.x).add("y", spot.y).add("s", spot.s).add("depth", json(spot.depth)).add("area", spot.area);
    spots.push_back(object);
  }
  return spots;
}

std::vector<std::string> notesOf(const CompareRecord& record)
{
  std::vector<std::string> notes = record.comparison.notes;
  const std::string &before = record.before.calibration.hash, &after = record.after.calibration.hash;
  if (!before.empty() && !after.empty() && before != after)
    notes.push_back("the scans were made with different calibrations (" + before + ", " + after + ")");
  return notes;
}

/// z before, NaN where the scan has a hole; x and y as well.
struct Places
{
  explicit Places(const Scan& scan)
    : x(scan.rows.size() * scan.cells, std::numeric_limits<float>::quiet_NaN()), y(x), z(x)
  {
    for (std::size_t row = 0; row < scan.rows.size(); ++row)
    {
      for (const CloudPoint& point : scan.rows[row].points)
      {
        const std::size_t i = row * scan.cells + point.cell;
        x[i] = point.x, y[i] = point.y, z[i] = point.z;
      }
    }
  }
  std::vector<float> x, y, z;
};

Origin originOf(const CompareRecord& record)
{
  return Origin{ record.weld_id, record.before.scan.frame_id, record.before.calibration.hash,
                 yamlOf(record.params) + yamlOf(record.measuring) };
}
}  // namespace

JsonObject compareJson(const CompareRecord& record)
{
  const ScanComparison& comparison = record.comparison;
  JsonObject settings, calibration;
  CompareParams params = record.params;
  WeldParams measuring = record.measuring;
  params.visit(detail::ToJson{ settings });
  measuring.visit(detail::ToJson{ settings });
  calibration.add("file", record.before.calibration.file).add("hash", record.before.calibration.hash);
  JsonObject object;
  object.add("id", record.weld_id)
      .add("software", software())
      .add("before", record.before.path)
      .add("after", record.after.path)
      .add("kind", name(comparison.kind))
      .add("reason", "")
      .add("aligned", alignedOf(comparison.aligned))
      .add("removed_volume", json(comparison.removed_volume))
      .add("remaining_volume", json(comparison.remaining_volume))
      .add("over_ground", spotsOf(comparison))
      .add("over_ground_limit", record.params.over_ground_limit)
      .add("measured_share", comparison.measured_share)
      .add("notes", notesOf(record))
      .add("settings", settings)
      .add("calibration", calibration);
  return object;
}

void writeComparison(const CompareRecord& record, bool report, const std::string& directory)
{
  makeOutputDirectory(directory);
  StagedOutput staged;  // never committed: the folder is swept away, its files are moved out before
  const fs::path target(directory), work(staged.directory((target / "comparison").string()));
  fs::create_directory(work);
  writeSummary(compareJson(record), (work / "compare.json").string());
  const ScanComparison& comparison = record.comparison;
  const Places places(record.before.scan);
  saveFloatMaps({ { "x", places.x },
                  { "y", places.y },
                  { "z", places.z },
                  { "after", comparison.after },
                  { "removed", comparison.removed },
                  { "remaining", comparison.remaining },
                  { "spot", comparison.spot } },
                comparison.cells, (work / "difference.pcd").string(), originOf(record).comments());
  if (report)
    runInterruptible([&] { writeCompareReport(work.string(), directory); });
  throwIfInterrupted();
  std::vector<std::string> names = { "compare.json", "difference.pcd", "report.html", "report.png" };
  std::error_code error;
  for (const std::string& name : names)
    if (fs::is_directory(target / name, error))
      throw InputError((target / name).string() + ": cannot be written: it is a directory, remove it");
  for (const std::string& name : names)
  {
    error.clear();
    if (fs::exists(work / name))
      fs::rename(work / name, target / name, error);
    else
      fs::remove(target / name, error);
    if (error)
      throw InputError((target / name).string() + ": cannot be written: " + error.message());
  }
}

std::string outcome(const ScanComparison& comparison)
{
  constexpr double kCubicMm = 1e9;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  const auto volume = [&text](const char* what, const Quantity& quantity)
  {
    text << what;
    if (quantity.measured())
      text << kCubicMm * quantity.value << " mm^3 (1 sigma " << kCubicMm * quantity.sigma << ")";
    else
      text << "not measured";
  };
  volume("removed ", comparison.removed_volume);
  volume(", remaining ", comparison.remaining_volume);
  const std::size_t spots = comparison.over_ground.size();
  text << ", ";
  if (spots == 0)
    text << "not over-ground";
  else
    text << spots << (spots == 1 ? " over-ground place, " : " over-ground places, the deepest ")
         << 1e3 * comparison.over_ground.front().depth.value << " mm below the target";
  text << "; " << 100.0 * comparison.measured_share << " % of the weld compared";
  return text.str();
}
}  // namespace weld_profiler
