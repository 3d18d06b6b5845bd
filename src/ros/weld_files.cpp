#include "weld_profiler/ros/weld_files.h"

#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <locale>
#include <regex>
#include <sstream>

#include "weld_profiler/core/atomic_file.h"
#include "weld_profiler/ros/origin.h"
#include "weld_profiler/ros/weld_record.h"
#include "weld_profiler/scan/labelled_scan.h"
#include "weld_profiler/weld/grinding_csv.h"
#include "weld_profiler/weld/mesh_ply.h"
#include "weld_profiler/weld/verdict_csv.h"
#include "weld_profiler/weld/weld_csv.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;
constexpr double kMillimetres = 1e3;

void writeText(const std::string& path, const std::function<void(std::ostream&)>& write)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  write(text);
  AtomicFile file(path);
  file.write(text.str());
  file.commit();
}

std::vector<WeldRecord> recordsOf(const WeldEvaluation& evaluation)
{
  std::vector<WeldRecord> records;
  const std::vector<WeldSection>& sections = evaluation.result.sections;
  for (std::size_t i = 0; i < sections.size(); ++i)
  {
    WeldRecord record;
    record.section = sections[i];
    if (i < evaluation.section_verdicts.size())
    {
      record.verdict = evaluation.section_verdicts[i].verdict;
      record.unverified = evaluation.section_verdicts[i].unverified;
    }
    records.push_back(record);
  }
  return records;
}

void writeSpots(const std::vector<WeldSpot>& spots, std::ostream& out)
{
  const auto field = [&out](double value)
  {
    out << ',';
    if (std::isfinite(value))
      out << kMillimetres * value;
  };
  out << "kind,s_mm,x_mm,y_mm,z_mm,diameter_mm,height_mm,sigma_diameter_mm,sigma_height_mm\n";
  for (const WeldSpot& spot : spots)
  {
    out << (spot.kind == WeldSpot::Kind::Pore ? "pore" : "spatter");
    for (const double value : { spot.s, spot.x, spot.y, spot.z, spot.diameter.value, spot.height.value,
                                spot.diameter.sigma, spot.height.sigma })
      field(value);
    out << '\n';
  }
}

/// What writeWeldFiles() and writeReport() leave.
void removeWeldFiles(const fs::path& directory)
{
  std::error_code ignored;  // who writes there next says what is wrong with the place
  for (const char* name : { "weld.json", "weld.csv", "verdict.csv", "spots.csv", "weld_points.pcd", "bead.ply",
                            "target.ply", "passes.csv", "report.html", "report.png" })
    if (!fs::is_directory(directory / name, ignored))
      fs::remove(directory / name, ignored);
}
}  // namespace

void removeStaleFiles(const std::string& directory, const FreshFiles& fresh)
{
  removeWeldFiles(directory);
  // clouds without it were not written with a weld: someone saved them
  if (!fresh.summary && !fs::exists(fs::path(directory) / "summary.json"))
    return;
  const std::regex cloud("scan(_([0-9]{1,6}))?(\\.(pcd|ply))?");
  std::vector<fs::path> stale;
  for (const auto& entry : fs::directory_iterator(directory))
  {
    if (entry.is_symlink())
      continue;  // what lies behind it is no part of this folder
    std::smatch match;
    const std::string name = entry.path().filename().string();
    const bool folder = entry.is_directory();
    if (!folder && !fresh.summary && name == "summary.json")
      stale.push_back(entry.path());
    if (!std::regex_match(name, match, cloud) || folder == match[3].matched || (folder && !match[1].matched))
      continue;
    const std::size_t number = match[2].matched ? std::stoul(match[2].str()) : 1;
    if (number > fresh.scans)
      stale.push_back(entry.path());
    else if (folder)
      removeWeldFiles(entry.path());
  }
  for (const fs::path& path : stale)
  {
    if (fs::is_directory(path))
      removeWeldFiles(path.string());
    if (!fs::is_directory(path) || fs::is_empty(path))
      fs::remove(path);
  }
}

std::vector<std::string> writeWeldFiles(const Scan& scan, const WeldEvaluation& evaluation,
                                        const WeldSettings& settings, const WeldRecordInfo& info,
                                        const std::string& directory)
{
  requireWeldId(info.weld_id);
  removeWeldFiles(directory);
  const Origin origin{ info.weld_id, scan.frame_id, info.calibration.hash, settingsText(settings) };
  const auto path = [&](const char* name) { return (fs::path(directory) / name).string(); };
  std::vector<std::string> files;
  const auto text = [&](const char* name, const std::function<void(std::ostream&)>& write)
  {
    files.push_back(path(name));
    writeText(files.back(), write);
  };
  text("weld.json", [&](std::ostream& out) { out << weldRecord(scan, evaluation, settings, info).text() << '\n'; });
  const auto table = [&](const char* name, const std::function<void(std::ostream&)>& write)
  {
    std::ostringstream csv;
    csv.imbue(std::locale::classic());
    write(csv);
    text(name, [&](std::ostream& out) { out << origin.inCsv(csv.str()); });
  };
  table("weld.csv", [&](std::ostream& out) { writeWeldCsv(recordsOf(evaluation), out); });
  table("verdict.csv", [&](std::ostream& out) { writeVerdictCsv(evaluation.verdict, out); });
  table("spots.csv", [&](std::ostream& out) { writeSpots(evaluation.result.spots, out); });
  const std::vector<std::string> comments = origin.comments();
  files.push_back(path("weld_points.pcd"));
  saveLabelledScan(scan, ScanLabels{ evaluation.result.labels, evaluation.result.removal }, files.back(), comments);
  const auto mesh = [&](const char* name, const TriangleMesh& surface)
  {
    if (!surface.empty())
      text(name, [&](std::ostream& out) { writePly(surface, out, comments); });
  };
  mesh("bead.ply", evaluation.plan.bead);
  mesh("target.ply", evaluation.plan.target);
  table("passes.csv", [&](std::ostream& out) { writePassesCsv(evaluation.plan, out); });
  return files;
}
}  // namespace weld_profiler
