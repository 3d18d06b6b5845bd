#include <algorithm>
#include <filesystem>
#include <future>
#include <iostream>
#include <thread>

#include <Eigen/Geometry>

#include "tools/progress.h"
#include "tools/run_command.h"
#include "tools/scan_bag_writer.h"
#include "tools/staged_output.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/geometry/calibration_file.h"
#include "weld_profiler/simulation/simulated_scan.h"
#include "weld_profiler/simulation/truth_writer.h"

namespace weld_profiler
{
namespace
{
struct Options
{
  std::string scene;
  std::string preset;
  std::string out;
};

std::string presetList()
{
  std::string list;
  for (const std::string& name : presetNames())
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

void declare(CommandLine& command, Options& options)
{
  command.option(
      "scene FILE", options.scene,
      "YAML with what differs from a preset: part, weld, rig, motion, light; every scan's BAG.truth/scene.yaml "
      "is one, with all fields");
  command.option("preset NAME", options.preset, "a ready scene instead: " + presetList());
  command.option("out BAG", options.out, "the bag to write; the truth goes to BAG.truth/");
  command.required();
  command.example("simulate_scan --out weld.bag");
  command.example("simulate_scan --preset harsh --out harsh.bag");
  command.example("simulate_scan --scene my_weld.yaml --out my_weld.bag");
}

SceneParams chosenScene(const Options& options)
{
  if (!options.scene.empty() && !options.preset.empty())
    throw UsageError("--scene and --preset exclude each other; a scene file names its preset with `preset: NAME`");
  if (!options.scene.empty())
    return loadScene(options.scene);
  return scenePreset(options.preset.empty() ? presetNames().front() : options.preset);
}

std::vector<EncoderSample> encoderOf(const SimulatedScan& scan)
{
  std::vector<EncoderSample> samples;
  for (const SimulatedEncoderSample& sample : scan.encoder())
    samples.push_back({ sample.stamp, sample.position });
  return samples;
}

std::vector<PoseSample> posesOf(const SimulatedScan& scan)
{
  std::vector<PoseSample> samples;
  for (const SimulatedPose& pose : scan.poses())
  {
    const Eigen::Quaterniond turn(
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(pose.rotation.data()).eval());
    const auto& p = pose.translation;
    samples.push_back({ pose.stamp, turn.x(), turn.y(), turn.z(), turn.w(), p[0], p[1], p[2] });
  }
  return samples;
}

Frame renderFrame(const SimulatedScan& scan, int index, double exposure)
{
  Frame frame;
  scan.render(index, frame.pixels);
  frame.width = scan.width();
  frame.height = scan.height();
  frame.step = scan.step();
  frame.encoding = scan.encoding();
  frame.stamp = scan.stamp(index);
  frame.number = static_cast<std::uint64_t>(index);
  frame.exposure = exposure;
  return frame;
}

/// Renders on all cores, a batch at a time; frames are written in their order, so the bag does not depend on the cores.
void writeFrames(const SimulatedScan& scan, double exposure, ScanBagWriter& writer)
{
  const int cores = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
  Progress progress("rendering", static_cast<std::size_t>(scan.frameCount()));
  for (int begin = 0; begin < scan.frameCount(); begin += cores)
  {
    std::vector<std::future<Frame>> batch;
    for (int i = begin; i < std::min(begin + cores, scan.frameCount()); ++i)
      batch.push_back(std::async(std::launch::async, renderFrame, std::cref(scan), i, exposure));
    for (std::future<Frame>& frame : batch)
    {
      writer.writeFrame(frame.get());
      progress.step();
    }
  }
}

void writeTruthFolder(const SimulatedScan& scan, const std::string& directory)
{
  Progress progress("writing the truth", static_cast<std::size_t>(scan.frameCount()));
  writeTruth(scan, directory, [&](int /*done*/, int /*total*/) { progress.step(); });
  saveCalibration(scan.calibration(), directory + "/calibration.yaml");
}

/// A folder that holds an earlier truth is replaced, any other is none of this command's business.
std::string truthFolder(StagedOutput& output, const std::string& bag)
{
  const std::filesystem::path folder = bag + ".truth";
  if (std::filesystem::exists(folder) && !std::filesystem::exists(folder / "centres.csv"))
    throw InputError(folder.string() + ": exists and holds no truth of a scan; remove it or choose another --out");
  return output.directory(folder.string());
}

int simulate(const Options& options)
{
  const SceneParams scene = chosenScene(options);
  const SimulatedScan scan(scene);
  ScanBagNames names;
  names.joint = scan.calibration().stage.joint;

  StagedOutput output;
  const std::string truth = truthFolder(output, options.out);
  ScanBagWriter writer(output, options.out, names, scan.calibration().camera);
  writer.setEncoder(encoderOf(scan));
  writer.setPoses(posesOf(scan));
  writeFrames(scan, scene.exposure, writer);
  writer.close();
  writeTruthFolder(scan, truth);
  output.commit();
  return kGood;
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  weld_profiler::Options options;
  weld_profiler::CommandLine command(
      "simulate_scan",
      "Scans a simulated weld and writes what camera and encoder would say: a bag with image_raw, camera_info\n"
      "and joint_states under /profiler (and /tf for a sensor that a robot carries). Beside it BAG.truth/ with\n"
      "centres.csv, surface.ply, weld.csv, spots.csv, scene.yaml and calibration.yaml. The same scene gives the\n"
      "same bytes.");
  weld_profiler::declare(command, options);
  return weld_profiler::runCommand(command, argc, argv, [&] { return weld_profiler::simulate(options); });
}
