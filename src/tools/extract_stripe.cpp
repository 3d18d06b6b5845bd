#include <filesystem>
#include <iostream>
#include <map>

#include <opencv2/imgcodecs.hpp>

#include "tools/params_file.h"
#include "tools/progress.h"
#include "tools/run_command.h"
#include "tools/staged_output.h"
#include "tools/stripe_csv.h"
#include "weld_profiler/camera/folder_source.h"
#include "weld_profiler/ros/stripe_worker.h"
#include "weld_profiler/stripe/overlay.h"
#include "weld_profiler/stripe/stripe_methods.h"
#include "weld_profiler/stripe/stripe_stage.h"

namespace weld_profiler
{
namespace
{
struct Options
{
  std::string method;
  std::string params;
  std::string direction;
  std::string channel;
  bool overlay = false;
  int overlay_scale = 1;
  std::string out;
  std::vector<std::string> images;
};

std::string methodList()
{
  std::string list;
  for (const std::string& name : stripeMethods())
    list.append(list.empty() ? "" : ", ").append(name);
  return list;
}

void declare(CommandLine& command, Options& options)
{
  command.option("method NAME", options.method, "how centres are found: " + methodList());
  command.option("params FILE", options.params,
                 "YAML with the parameters of stripe extraction, flat or in a section `stripe_centre:`; the options "
                 "here win over it");
  command.option("direction D", options.direction,
                 "auto (told from each image), u (the stripe runs along the rows) or v (along the columns)");
  command.option("channel C", options.channel, "of colour images: red, green, blue, max or luminance");
  command.flag("overlay", options.overlay, "also write DIR/<stem>.png: the image with what was found drawn on it");
  command.option("overlay-scale N", options.overlay_scale, "enlarges that picture, 1..16");
  command.option("out DIR", options.out, "where <stem>.csv goes, one for each image; created if needed");
  command.required();
  command.arguments("IMAGE...", options.images, "8 or 16 bit grey or colour images: png, jpg, bmp, tif, pgm");
  command.example("extract_stripe --out centres frame0001.png frame0002.png");
  command.example("extract_stripe --method svd --overlay --overlay-scale 4 --out centres frame0001.png");
  command.example("extract_stripe --direction v --channel red --out centres scan/*.jpg");
}

StripeParams stripeParams(const Options& options)
{
  StripeParams params;
  ParamsFile file(options.params);
  StripeWorkerParams live;  // what only the nodelet uses is known here too, so that one file serves both
  file.load("stripe_centre", params, live);
  file.refuseUnknown();
  for (const auto& [chosen, field] :
       { std::make_pair(&options.method, &params.method), std::make_pair(&options.direction, &params.direction),
         std::make_pair(&options.channel, &params.channel) })
    if (!chosen->empty())
      *field = *chosen;
  return params;
}

[[noreturn]] void refuseStem(const std::string& stem, const std::string& image, const std::string& earlier)
{
  throw InputError(image + ": its centres would go to " + stem + ".csv as those of " + earlier +
                   "; give the two in separate runs with another --out");
}

/// A file the user gave is never written over.
void refuseOverwriting(const Options& options)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  for (const std::string& image : options.images)
  {
    const fs::path overlay = fs::path(options.out) / fs::path(image).stem().concat(".png");
    for (const std::string& other : options.images)
    {
      if (options.overlay && fs::equivalent(overlay, other, ignored))
        throw InputError(overlay.string() + ": the overlay would replace this image; give another --out");
    }
  }
}

void refuseEqualStems(const std::vector<std::string>& images)
{
  std::map<std::string, std::string> seen;
  for (const std::string& image : images)
  {
    const std::string stem = std::filesystem::path(image).stem().string();
    const auto [earlier, added] = seen.emplace(stem, image);
    if (!added)
      refuseStem(stem, image, earlier->second);
  }
}

void writeOverlay(const Frame& frame, const Stripe& stripe, const Workspace& workspace, const std::string& path,
                  int scale)
{
  std::vector<unsigned char> png;
  cv::imencode(".png", drawStripe(frame.view(), stripe, workspace.initial, scale), png);
  writeFileWhole(path, std::string(png.begin(), png.end()));
}

/// @return the number of centres found.
std::size_t extractOne(const StripeStage& stage, const Options& options, const std::string& image)
{
  Frame frame;
  readImage(image, frame);
  Workspace workspace;  // a fresh one: the images need not be of one scan, and each answer stands alone
  workspace.keep_trace = options.overlay;
  Stripe stripe;
  stage.process(frame.view(), workspace, stripe);
  const std::string base = (std::filesystem::path(options.out) / std::filesystem::path(image).stem()).string();
  writeFileWhole(base + ".csv", stripeCsv(stripe));
  if (options.overlay)
    writeOverlay(frame, stripe, workspace, base + ".png", options.overlay_scale);
  return stripe.size();
}

/// What became of the images so far.
struct Extracted
{
  std::size_t images = 0;  ///< tried
  std::size_t centres = 0;
  bool all_read = true;
};

void extractNext(const StripeStage& stage, const Options& options, Progress& progress, Extracted& so_far)
{
  const std::string& image = options.images[so_far.images++];
  try
  {
    const std::size_t found = extractOne(stage, options, image);
    so_far.centres += found;
    if (found == 0)
      progress.say("extract_stripe: " + image + ": no stripe found; its csv holds the header only");
  }
  catch (const Error& error)
  {
    so_far.all_read = false;
    progress.say(std::string("extract_stripe: ") + error.what());
  }
  progress.step();
}

int extract(const Options& options)
{
  const StripeStage stage(stripeParams(options));
  requireRange("--overlay-scale", options.overlay_scale, 1, 16);
  refuseEqualStems(options.images);
  refuseOverwriting(options);
  makeOutputDirectory(options.out);
  const std::size_t count = options.images.size();
  Extracted so_far;
  try
  {
    Progress progress("extracting", count);
    while (so_far.images < count)
      extractNext(stage, options, progress, so_far);
  }
  catch (const Interrupted&)
  {
    throw Interrupted("the files of the first " + std::to_string(so_far.images) + " of " + std::to_string(count) +
                      " images stay in " + options.out + ", whole");
  }
  return !so_far.all_read ? kBadInput : so_far.centres == 0 ? kPoorResult : kGood;
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  weld_profiler::Options options;
  weld_profiler::CommandLine command(
      "extract_stripe",
      "Finds the sub-pixel centre line of the laser stripe in each image and writes it as\n"
      "DIR/<stem>.csv: u_px,v_px,normal_rad,intensity,width_px,sigma_px,flags,cell, a line a centre.\n"
      "Pixel centres lie at integers; flags: 1 interpolated, 2 saturated, 4 ambiguous.");
  weld_profiler::declare(command, options);
  return weld_profiler::runCommand(command, argc, argv, [&] { return weld_profiler::extract(options); });
}
