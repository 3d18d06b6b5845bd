#include <filesystem>
#include <iostream>

#include "tools/bag_scan.h"
#include "tools/params_file.h"
#include "tools/run_command.h"
#include "tools/staged_output.h"
#include "tools/weld_output.h"
#include "weld_profiler/core/checksum.h"
#include "weld_profiler/ros/calibration_url.h"
#include "weld_profiler/ros/origin.h"
#include "weld_profiler/ros/scan_server.h"
#include "weld_profiler/ros/stripe_worker.h"
#include "weld_profiler/ros/weld_server.h"
#include "weld_profiler/scan/export.h"
#include "weld_profiler/scan/summary.h"

namespace weld_profiler
{
namespace
{
struct Options
{
  std::string calibration;
  std::string params;
  std::string name_space;
  std::string motion;
  std::string fixed_frame;
  double max_drop = 0.05;
  std::string weld_id;
  bool no_weld = false;
  bool no_report = false;
  std::string out;
  std::vector<std::string> bags;
};

void declare(CommandLine& command, Options& options)
{
  command.option("calibration FILE", options.calibration, "camera, laser plane and stage axis of the rig");
  command.required();
  command.option("params FILE", options.params,
                 "YAML with the parameters of stripe_centre, triangulation and weld_measurement, in sections of these "
                 "names or flat");
  command.option("namespace NS", options.name_space, "of image_raw in the bag; needed when there is more than one");
  command.option("motion M", options.motion, "stage (joint_states) or tf (the sensor's pose from /tf)");
  command.option("fixed-frame F", options.fixed_frame, "frame of the cloud with --motion tf");
  command.option("max-drop FRACTION", options.max_drop,
                 "share of frames that may be dropped or unplaced before the exit status is 3, 0..1");
  command.option("weld-id ID", options.weld_id, "name of the weld, for its files and the report");
  command.flag("no-weld", options.no_weld, "write the scan alone: measure no weld");
  command.flag("no-report", options.no_report, "write no report.html and report.png");
  command.option("out DIR", options.out, "where the files go; created if needed");
  command.required();
  command.arguments("BAG", options.bags, "a bag with image_raw, camera_info and joint_states (or /tf)");
  command.example("scan_bag --calibration calibration.yaml --out scan1 weld.bag");
  command.example("scan_bag --calibration weld.bag.truth/calibration.yaml --params tuned.yaml --out scan2 weld.bag");
}

BagScanParams bagScanParams(const Options& options, WeldServerParams& weld)
{
  if (options.bags.size() != 1)
    throw UsageError("one BAG at a time, " + std::to_string(options.bags.size()) + " were given");
  BagScanParams params;
  params.bag = options.bags.front();
  params.name_space = options.name_space;
  params.calibration = loadCalibrationFrom(options.calibration);
  ParamsFile file(options.params);
  StripeWorkerParams live;  // what only the nodelets use is known here too, so that one file serves both
  ScanServerParams server;
  file.load("stripe_centre", params.stripe, live);
  file.load("triangulation", server);
  file.load("weld_measurement", weld);
  file.refuseUnknown();
  params.chain = server.chain;
  if (!options.motion.empty())
    params.chain.motion = options.motion;
  if (!options.fixed_frame.empty())
    params.chain.fixed_frame = options.fixed_frame;
  params.stripe.validate();
  params.chain.validate();
  weld.validate();
  return params;
}

Origin originOf(const Scan& scan, Origin origin)
{
  origin.frame_id = scan.frame_id;
  return origin;
}

/// scan.pcd for the first scan of the bag, scan_2.pcd for the second (after a reversal or max_rows), ...
void writeScans(const BagScanResult& result, const Origin& origin, const std::filesystem::path& directory,
                StagedOutput& output)
{
  for (std::size_t i = 0; i < result.scans.size(); ++i)
  {
    const std::string stem = i == 0 ? "scan" : "scan_" + std::to_string(i + 1);
    for (const char* format : { "pcd", "ply" })
      saveScan(result.scans[i], output.file((directory / stem).string().append(".").append(format)), format,
               originOf(result.scans[i], origin).comments());
  }
}

std::size_t pointCount(const BagScanResult& result)
{
  std::size_t points = 0;
  for (const Scan& scan : result.scans)
  {
    for (const Profile& row : scan.rows)
      points += row.points.size();
  }
  return points;
}

JsonObject summaryOf(const BagScanResult& result, const BagScanParams& params, const WeldRecordInfo& info)
{
  JsonObject calibration, settings;
  calibration.add("file", info.calibration.file).add("hash", info.calibration.hash).add("date", info.calibration.date);
  settings.add("stripe_centre", jsonOf(params.stripe)).add("triangulation", jsonOf(params.chain));
  JsonObject json = summary(result.balance);
  json.add("frames_missing_in_bag", result.frame_gaps);
  json.add("scans", static_cast<std::uint64_t>(result.scans.size()));
  return json.add("software", software())
      .add("id", info.weld_id)
      .add("calibration", calibration)
      .add("settings", settings)
      .add("settings_hash", checksum(yamlOf(params.stripe) + yamlOf(params.chain)));
}

void writeSummaryFile(const JsonObject& json, const std::filesystem::path& directory, StagedOutput& output)
{
  writeSummary(json, output.file((directory / "summary.json").string()));
}

/// Says on standard error what became of the bag. @return the exit status.
int report(const BagScanResult& result, const Options& options)
{
  const std::string name = "scan_bag: " + options.bags.front() + ": ";
  const FrameBalance& balance = result.balance;
  const std::uint64_t lost = balance.droppedTotal() + balance.unplacedTotal();
  std::cerr << name << balance.frames_in << " frames: " << balance.rows << " rows, " << balance.no_stripe
            << " without a stripe, " << balance.skipped << " skipped by the trigger, " << balance.unplacedTotal()
            << " unplaced, " << balance.droppedTotal() << " dropped\n";
  if (result.scans.size() > 1)
    std::cerr << name << result.scans.size()
              << " scans (the stage turned round, time ran backwards, the width changed, or "
              << "max_rows): scan.pcd, scan_2.pcd, ...\n";
  if (balance.rows == 0)
    std::cerr << name << "no frame became a row, see summary.json for where they went\n";
  else if (pointCount(result) == 0)
    std::cerr << name << "every point lies outside the window min_x..max_z, widen it\n";
  const bool many_lost = static_cast<double>(lost) > options.max_drop * static_cast<double>(balance.frames_in);
  return pointCount(result) == 0 || many_lost ? kPoorResult : kGood;
}

WeldTask weldTask(const Options& options, const WeldSettings& settings)
{
  return WeldTask{ WeldEvaluator(settings),
                   { options.weld_id, calibrationRecord(resolveUrl(options.calibration)) },
                   !options.no_report,
                   options.out };
}

int scan(const Options& options)
{
  requireRange("--max-drop", options.max_drop, 0.0, 1.0);
  requireWeldId(options.weld_id);
  WeldServerParams weld;
  const BagScanParams params = bagScanParams(options, weld);
  const WeldTask task = weldTask(options, weld.settings);  // reads what it needs before the bag is read
  const BagScanResult result = scanBag(params);
  makeOutputDirectory(options.out);
  StagedOutput output;
  const std::string settings = yamlOf(params.stripe) + yamlOf(params.chain);
  writeScans(result, Origin{ options.weld_id, "", task.info.calibration.hash, settings }, options.out, output);
  writeSummaryFile(summaryOf(result, params, task.info), options.out, output);
  output.commit();
  removeStaleFiles(options.out, FreshFiles{ result.scans.size(), true });
  if (!options.no_weld)
    measureWelds(result.scans, task);
  return report(result, options);
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  weld_profiler::Options options;
  weld_profiler::CommandLine command(
      "scan_bag",
      "Turns a recorded scan into an organised point cloud: the live chain over a bag, every message, without a ROS\n"
      "master. The same bag and parameters give the same bytes. Leaves scan.pcd (organised, the fields of "
      "scan_points),\n"
      "scan.ply, summary.json (where every frame went) and what was measured of the weld: weld.json, weld.csv,\n"
      "verdict.csv, spots.csv, weld_points.pcd, the hand-over to grinding and the report. A second scan of the bag "
      "has\n"
      "a folder scan_2 for that in DIR.");
  weld_profiler::declare(command, options);
  return weld_profiler::runCommand(command, argc, argv, [&] { return weld_profiler::scan(options); });
}
