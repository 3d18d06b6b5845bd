// What is kept of a notch, and what a repair makes of gaps.
#include <algorithm>
#include <cmath>

#include "comparison/context.h"
#include "comparison/scenes.h"
#include "support/integrate_stripe.h"

namespace weld_profiler
{
namespace comparison
{
using test_support::StripePicture;

namespace
{
constexpr double kDepth = 3.0, kWidth = 4.0;  ///< of a notch [px]; the width is a Gaussian's sigma
constexpr double kPitch = 60.0, kFirst = 45.0;
constexpr int kNotches = 12;

double middleOf(int notch)
{
  return kFirst + kPitch * notch + 0.31 * notch;  // every sub-pixel place
}

/// Notches and bumps in turn on a line that hardly slopes.
StripePicture notchScene(double snr, unsigned seed)
{
  StripePicture scene;
  scene.width = static_cast<int>(kPitch * kNotches + 40.0);
  scene.height = 100;
  scene.snr = snr;
  scene.seed = 4000 + seed;
  const double row = 40.0 + 0.137 * seed;
  scene.row = [=](double u)
  {
    double v = row + 0.02 * u;
    for (int i = 0; i < kNotches; ++i)
      v += (i % 2 == 0 ? kDepth : -kDepth) * std::exp(-0.5 * std::pow((u - middleOf(i)) / kWidth, 2.0));
    return v;
  };
  return scene;
}

/// Measured row at a column that need not be whole: a line through the centres either side.
double rowAt(const Stripe& stripe, double u)
{
  for (std::size_t i = 1; i < stripe.size(); ++i)
    if (stripe.u[i - 1] <= u && stripe.u[i] > u)
    {
      const double part = (u - stripe.u[i - 1]) / (stripe.u[i] - stripe.u[i - 1]);
      return stripe.v[i - 1] + part * (stripe.v[i] - stripe.v[i - 1]);
    }
  return std::nan("");
}

struct Kept
{
  double sum = 0.0;
  int count = 0, lost = 0;
  double percent() const { return 100.0 * sum / count; }
};

void addKept(const StripePicture& scene, const Stripe& stripe, Kept& kept)
{
  for (int i = 0; i < kNotches; ++i)
  {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    const double measured = rowAt(stripe, middleOf(i));
    if (!std::isfinite(measured))
    {
      ++kept.lost;
      continue;
    }
    const double base = scene.row(middleOf(i)) - sign * kDepth;
    kept.sum += sign * (measured - base) / kDepth;
    ++kept.count;
  }
}

Kept keptBy(const std::string& name, double snr, int seeds, bool integrated)
{
  const std::unique_ptr<Candidate> candidate = makeCandidate(name);
  Kept kept;
  Stripe stripe;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    const StripePicture scene = notchScene(snr, static_cast<unsigned>(seed));
    const test_support::Picture picture = integrated ? renderIntegrated(scene) : render(scene);
    candidate->reset();
    candidate->process(picture.raw(), stripe);
    addKept(scene, stripe, kept);
  }
  return kept;
}
}  // namespace

void compareNotch(Context& context)
{
  Report& report = context.report();
  report.table("notch", "share of the depth of a notch of sigma 4 px and depth 3 px that is kept [%]");
  for (const std::string& name : context.options().methods)
  {
    const Kept clean = keptBy(name, 0.0, 2, false), drawn_again = keptBy(name, 0.0, 2, true);
    const Kept noisy = keptBy(name, 50.0, context.seeds(18), false);
    report.row({ { "method", name },
                 { "no_noise", clean.percent() },
                 { "integrated", drawn_again.percent() },
                 { "snr_50", noisy.percent() },
                 { "lost", static_cast<double>(clean.lost + drawn_again.lost + noisy.lost), 0 } });
    if (name == context.judged())
      report.accept({ "notch of sigma 4 px and depth 3 px: share of its depth kept, least",
                      std::min({ clean.percent(), drawn_again.percent(), noisy.percent() }), 93.0, 97.0, true, "%",
                      "noise-free in two renderings, SNR 50" });
  }
}

void compareRepair(Context& context)
{
  Report& report = context.report();
  report.table("repair",
               "breaks in the bead, SNR 50, every 86 columns: RMSE of the filled [mpx], share filled, "
               "error / told sigma");
  for (const int gap : { 2, 5, 10, 20, 40 })
  {
    std::vector<Sample> samples;
    for (int seed = 1; seed <= context.seeds(24); ++seed)
    {
      const std::vector<Break> breaks = { { 55, gap }, { 141, gap }, { 227, gap }, { 313, gap } };
      samples.push_back(brokenBead(breaks, static_cast<unsigned>(seed)));
    }
    for (const std::string& name : context.options().methods)
    {
      const Score score = judge(*makeCandidate(name), samples);
      context.noteHonesty("gap of " + std::to_string(gap), name, score);
      report.row(
          { { "gap", 1.0 * gap, 0 },
            { "method", name },
            { "filled_mpx", 1e3 * score.interpolated.rmse(), 1 },
            { "filled%",
              100.0 * static_cast<double>(score.filled) / static_cast<double>(std::max<std::size_t>(score.breaks, 1)),
              1 },
            { "filled_hon", score.interpolated.honesty() },
            { "measured_mpx", 1e3 * score.measured.rmse(), 1 },
            { "measured_hon", score.measured.honesty() },
            { "made_up", static_cast<double>(score.made_up), 0 } });
    }
  }
}
}  // namespace comparison
}  // namespace weld_profiler
