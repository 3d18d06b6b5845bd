// The scenes beyond straight stripes in clean noise.
#include <algorithm>
#include <cmath>
#include <map>

#include "comparison/context.h"
#include "comparison/scenes.h"

namespace weld_profiler
{
namespace comparison
{
namespace
{
void acceptScene(Context& context, const SceneSet& scene, const Score& score)
{
  Report& report = context.report();
  const double rmse = 1e3 * score.rmse();
  if (scene.name == "bead")
    report.accept({ "bead with 45 deg flanks, SNR 50: RMSE", rmse, 15.0, 11.0, false, "mpx", "" });
  if (scene.name == "reflectance")
    report.accept({ "reflectance 40 %, period 20 px, at 45 deg, SNR 50: RMSE", rmse, 15.0, 10.0, false, "mpx", "" });
  if (scene.name == "ghosts")
  {
    report.accept({ "second reflection + glow + 60 spatters: points more than 1 px off", score.outlierPercent(), 1.0,
                    0.2, false, "%", "" });
    report.accept(
        { "second reflection + glow + 60 spatters: missing", score.missingPercent(), 1.0, 0.2, false, "%", "" });
  }
}

/// A constant offset of a lopsided profile is a matter of definition.
void takeOffsetOff(Score& score)
{
  ErrorSums& sums = score.measured;
  const double kept = sums.spread() / sums.rmse();
  sums.in_sigmas *= kept * kept;
  sums.squares *= kept * kept;
  score.squares = sums.squares;
}

void runScene(Context& context, const SceneSet& scene, const std::string& method)
{
  CandidateSettings settings;
  settings.stripe_sigma = scene.stripe_sigma;
  Score score = judge(*makeCandidate(method, settings), scene.samples);
  const double bias = score.measured.bias();
  if (!scene.centre_defined)
    takeOffsetOff(score);
  if (scene.noise)
    context.noteHonesty(scene.name, method, score);
  const auto points = static_cast<double>(std::max<std::size_t>(score.points, 1));
  context.report().row({ { "scene", scene.name },
                         { "method", method },
                         { "rmse_mpx", 1e3 * score.rmse(), 1 },
                         { "within_1px", 1e3 * score.measured.rmse(), 1 },
                         { "bias", 1e3 * bias, 1 },
                         { "outliers%", score.outlierPercent(), 2 },
                         { "missing%", score.missingPercent(), 2 },
                         { "made_up", static_cast<double>(score.made_up), 0 },
                         { "honesty", scene.noise ? score.measured.honesty() : std::nan("") },
                         { "filled_mpx", 1e3 * score.interpolated.rmse(), 1 },
                         { "filled_hon", score.interpolated.honesty() },
                         { "saturated%", 100.0 * static_cast<double>(score.saturated) / points, 1 },
                         { "ambiguous%", 100.0 * static_cast<double>(score.ambiguous) / points, 1 } });
  if (method == context.judged())
    acceptScene(context, scene, score);
}

/// One line a column of the bead, for the figure.
void traceBead(Context& context, const std::string& name, const Sample& sample)
{
  Stripe stripe;
  makeCandidate(name)->process(sample.picture.raw(), stripe);
  for (std::size_t i = 0; i < stripe.size(); ++i)
    context.report().row({ { "method", name },
                           { "u", static_cast<double>(stripe.u[i]) },
                           { "row", sample.truth.row(stripe.u[i]) },
                           { "error_mpx", 1e3 * distanceAcross(sample.truth, stripe.u[i], stripe.v[i]) } },
                         Report::Silent);
}
}  // namespace

void compareScenes(Context& context)
{
  Report& report = context.report();
  report.table("scenes",
               "harder scenes; RMSE of all centres across the stripe [mpx], error / told sigma, the filled apart");
  for (const std::string& name : sceneNames())
    if (context.wants(name) || context.wants("scenes"))
    {
      const SceneSet scene = makeScene(name, context.seeds(24));
      for (const std::string& method : context.options().methods)
        runScene(context, scene, method);
    }
  if (!context.wants("bead") && !context.wants("scenes"))
    return;
  report.table("bead_trace", "error along one bead, SNR 50 (written to the file)");
  const Sample bead = sampleOf(beadScene(50.0, 1));
  for (const std::string& method : context.options().methods)
    if (method == context.judged() || method == "steger" || method == "squared_centroid" || method == "svd")
      traceBead(context, method, bead);
}

void compareSpeckle(Context& context)
{
  Report& report = context.report();
  report.table("speckle",
               "the bead under speckle of contrast 0.2, grain 2 px FWHM, SNR 50: against Steger's five kernels");
  const SceneSet scene = makeScene("speckle", context.seeds(48));
  double best = 1e9;
  std::string best_name;
  const auto measure = [&](const std::string& name, bool rival)
  {
    const Score score = judge(*makeCandidate(name), scene.samples);
    const double rmse = 1e3 * score.rmse();
    report.row({ { "method", name },
                 { "rmse_mpx", rmse, 1 },
                 { "outliers%", score.outlierPercent() },
                 { "missing%", score.missingPercent() },
                 { "honesty", score.measured.honesty() } });
    if (rival && rmse < best && score.missingPercent() < 5.0)
    {
      best = rmse;
      best_name = name;
    }
    return rmse;
  };
  for (const char* method : { "steger", "opencv_steger" })
    for (const double factor : { 1.0, 1.155, 1.5, 2.0, 3.0 })
    {
      char name[64];
      std::snprintf(name, sizeof name, "%s@%.2f", method, factor * scene.stripe_sigma);
      measure(name, true);
    }
  const double own = measure(context.judged(), false);
  report.accept(
      { "bead, speckle 0.2: RMSE / best Steger of five kernels", own / best, 0.8, 0.65, false, "x",
        std::to_string(own).substr(0, 5) + " mpx against " + std::to_string(best).substr(0, 5) + " of " + best_name });
}
}  // namespace comparison
}  // namespace weld_profiler
