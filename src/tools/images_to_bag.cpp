#include <cmath>
#include <limits>

#include <yaml-cpp/yaml.h>

#include "tools/progress.h"
#include "tools/run_command.h"
#include "tools/scan_bag_writer.h"
#include "tools/staged_output.h"
#include "weld_profiler/camera/folder_source.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/geometry/calibration_file.h"

namespace weld_profiler
{
namespace
{
struct Options
{
  std::string images;
  double pitch_mm = std::numeric_limits<double>::quiet_NaN();
  double fps = std::numeric_limits<double>::quiet_NaN();
  std::string camera;
  std::string out;
  std::string name_space = "/profiler";
  std::string joint;
  double encoder_hz = 200.0;
  double start_time = 1000.0;
};

void declare(CommandLine& command, Options& options)
{
  command.option("images GLOB", options.images,
                 "a directory or a quoted glob; the images are taken in natural order (img2 before img10)");
  command.required();
  command.option("pitch-mm P", options.pitch_mm, "stage travel from one image to the next [mm]; negative = backwards");
  command.required();
  command.option("fps F", options.fps, "images a second that the bag pretends, (0, 10000]");
  command.required();
  command.option("camera FILE", options.camera,
                 "the camera that took them: a ROS camera YAML, or a calibration file (its joint and the joint's unit "
                 "are used, too)");
  command.required();
  command.option("out BAG", options.out, "the bag to write");
  command.required();
  command.option("namespace NS", options.name_space, "of the topics");
  command.option("joint NAME", options.joint, "joint in joint_states; default: the calibration file's, or stage_joint");
  command.option("encoder-hz R", options.encoder_hz, "encoder samples a second, 100..10000");
  command.option("start-time T", options.start_time, "stamp of the first image [s]");
  command.example("images_to_bag --images 'scan/*.png' --pitch-mm 1 --fps 10 --camera camera.yaml --out scan.bag");
  command.example("images_to_bag --images scan/ --pitch-mm 0.25 --fps 20 --camera calibration.yaml --out scan.bag");
}

void validate(const Options& options)
{
  if (!(std::abs(options.pitch_mm) >= 1e-6 && std::abs(options.pitch_mm) <= 1000.0))
    throw ConfigError("--pitch-mm is " + std::to_string(options.pitch_mm) + ", must be 1e-6..1000 mm, of either sign");
  if (!(options.fps > 0.0 && options.fps <= 10000.0))
    throw ConfigError("--fps is " + std::to_string(options.fps) + ", must be in (0, 10000]");
  requireRange("--encoder-hz", options.encoder_hz, 100.0, 10000.0, "Hz");
  requireRange("--start-time", options.start_time, 1.0, 4e9, "s");
  if (options.name_space.size() < 2 || options.name_space.front() != '/' || options.name_space.back() == '/')
    throw ConfigError("--namespace is '" + options.name_space + "', must be like /profiler");
}

/// A ROS camera YAML says no more than the camera; a calibration file also names the joint and its unit.
Calibration readCamera(const std::string& path)
{
  YAML::Node root;
  try
  {
    root = YAML::LoadFile(path);
  }
  catch (const YAML::BadFile&)
  {
    throw InputError(path + ": cannot be read; --camera takes a ROS camera YAML or a calibration file");
  }
  catch (const YAML::Exception& error)
  {
    throw ConfigError(path + ": line " + std::to_string(error.mark.line + 1) + " is not YAML: " + error.msg);
  }
  if (root.IsMap() && root["laser_plane"])
    return loadCalibration(path);
  Calibration calibration;
  calibration.camera = loadCameraFile(path);
  return calibration;
}

/// Constant speed through the images' positions: at a stamp of an image this is where a stepped stage stood, too.
std::vector<EncoderSample> impliedEncoder(const Options& options, std::size_t images, double metres_per_unit)
{
  constexpr double kMargin = 0.1;  // begins before the first image and ends after the last [s]
  const double duration = static_cast<double>(images - 1) / options.fps + 2.0 * kMargin;
  const auto count = static_cast<std::size_t>(std::ceil(duration * options.encoder_hz)) + 1;
  const double speed = options.pitch_mm * 1e-3 / metres_per_unit * options.fps;
  std::vector<EncoderSample> samples;
  samples.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Stamp since_start = fromSeconds(static_cast<double>(i) / options.encoder_hz - kMargin);
    samples.push_back({ fromSeconds(options.start_time) + since_start, speed * toSeconds(since_start) });
  }
  return samples;
}

int convert(const Options& options)
{
  validate(options);
  const Calibration calibration = readCamera(options.camera);
  const std::vector<std::string> files = listImages(options.images);
  ScanBagNames names;
  names.name_space = options.name_space;
  names.joint = options.joint.empty() ? calibration.stage.joint : options.joint;

  StagedOutput output;
  ScanBagWriter writer(output, options.out, names, calibration.camera);
  writer.setEncoder(impliedEncoder(options, files.size(), calibration.stage.metres_per_unit));
  Progress progress("writing images", files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    Frame frame;
    readImage(files[i], frame);
    if (frame.width != calibration.camera.image_width || frame.height != calibration.camera.image_height)
      throw InputError(files[i] + ": is " + std::to_string(frame.width) + "x" + std::to_string(frame.height) +
                       ", but the camera in " + options.camera + " is " +
                       std::to_string(calibration.camera.image_width) + "x" +
                       std::to_string(calibration.camera.image_height) + "; give the camera that took it");
    frame.number = i;
    frame.stamp = fromSeconds(options.start_time) + fromSeconds(static_cast<double>(i) / options.fps);
    writer.writeFrame(std::move(frame));
    progress.step();
  }
  writer.close();
  output.commit();
  return kGood;
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  weld_profiler::Options options;
  weld_profiler::CommandLine command(
      "images_to_bag",
      "Turns the images of a stepped or constant-speed scan into a bag: image_raw, camera_info and the\n"
      "joint_states of the encoder that the pitch implies, for scan_bag and for replay.\n"
      "All images must be readable and of the camera's size, else no bag is written.");
  weld_profiler::declare(command, options);
  return weld_profiler::runCommand(command, argc, argv, [&] { return weld_profiler::convert(options); });
}
