// What stays without noise: straight stripes in two renderings, rounded to 16 bit and to 8 bit.
#include <cmath>
#include <cstdio>
#include <map>

#include "comparison/context.h"
#include "comparison/scenes.h"
#include "support/integrate_stripe.h"

namespace weld_profiler
{
namespace comparison
{
namespace
{
constexpr int kMargin = 30;  ///< columns at the image's ends that are not judged

struct Frame
{
  double sigma, degrees;
  bool integrated;
  int bits;

  std::string text() const
  {
    char line[64];
    std::snprintf(line, sizeof line, "sigma %.1f, %.1f deg%s", sigma, degrees, integrated ? ", integrated" : "");
    return line;
  }
};

/// Of one method and one depth of grey levels, over all frames.
struct Systematic
{
  double squares = 0.0, largest = 0.0;
  std::size_t points = 0, missing = 0;
  std::string where;

  void add(const Frame& frame, const Score& score)
  {
    squares += score.squares;
    points += score.points;
    missing += score.missing;
    if (score.largest <= largest)
      return;
    largest = score.largest;
    where = frame.text();
  }
  double rms() const { return std::sqrt(squares / static_cast<double>(points)); }
};

using Results = std::map<std::string, std::map<int, Systematic>>;  // by method and bits

Sample sampleOf(const Frame& frame)
{
  test_support::StripePicture scene = straightScene(frame.sigma, frame.degrees + 0.17, 3);
  scene.bit_depth = frame.bits;
  Sample sample{ scene, frame.integrated ? renderIntegrated(scene) : render(scene), {} };
  for (int u = 0; u < scene.width; ++u)
    sample.expected.push_back(u < kMargin || u >= scene.width - kMargin ? Expected::Beyond : Expected::Centre);
  return sample;
}

void measure(Context& context, const Frame& frame, Results& results)
{
  const Sample sample = sampleOf(frame);
  CandidateSettings settings;
  settings.stripe_sigma = frame.sigma;
  for (const std::string& name : context.options().methods)
  {
    const Score score = judge(*makeCandidate(name, settings), { sample });
    results[name][frame.bits].add(frame, score);
    context.report().row({ { "method", name },
                           { "sigma", frame.sigma },
                           { "degrees", frame.degrees },
                           { "integrated", frame.integrated ? 1.0 : 0.0, 0 },
                           { "bits", 1.0 * frame.bits, 0 },
                           { "rms_mpx", 1e3 * score.rmse() },
                           { "largest_mpx", 1e3 * score.largest },
                           { "missing", static_cast<double>(score.missing), 0 } },
                         Report::Silent);
  }
}
}  // namespace

void compareSystematic(Context& context)
{
  Report& report = context.report();
  report.table("systematic",
               "noise-free straight stripes, sigma 1.5-5 px, slopes 0-60 deg, point samples and integrated pixels: "
               "error across [mpx]");
  Results results;
  for (const double sigma : { 1.5, 2.0, 3.0, 5.0 })
    for (const double degrees : { 0.0, 7.5, 15.0, 22.5, 30.0, 37.5, 45.0, 52.5, 59.8 })
      for (const bool integrated : { false, true })
        for (const int bits : { 16, 8 })
          measure(context, Frame{ sigma, degrees, integrated, bits }, results);
  for (const std::string& name : context.options().methods)
    report.row({ { "method", name },
                 { "16bit_rms", 1e3 * results[name][16].rms() },
                 { "16bit_largest", 1e3 * results[name][16].largest },
                 { "8bit_rms", 1e3 * results[name][8].rms() },
                 { "8bit_largest", 1e3 * results[name][8].largest },
                 { "missing", static_cast<double>(results[name][16].missing + results[name][8].missing), 0 },
                 { "largest_at", results[name][16].where } });
  const auto own = results.find(context.judged());
  if (own == results.end())
    return;
  report.accept({ "systematic error, noise-free, sigma 1.5-5, to 60 deg, largest (16 bit)",
                  1e3 * own->second[16].largest, 3.0, 1.0, false, "mpx", own->second[16].where });
  report.accept({ "  the same in 8 bit, whose rounding is a noise, RMS", 1e3 * own->second[8].rms(), 3.0, 1.0, false,
                  "mpx", "" });
}
}  // namespace comparison
}  // namespace weld_profiler
