// What stays without noise: straight stripes in two renderings, rounded to 16 bit and to 8 bit.
#include <algorithm>
#include <cmath>
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

struct Systematic
{
  double largest = 0.0, largest_8bit = 0.0;
  ErrorSums all, all_8bit;
  std::string where;
};

Sample frameOf(double sigma, double degrees, int bit_depth, bool integrated)
{
  test_support::StripePicture scene = straightScene(sigma, degrees + 0.17, 3);
  scene.bit_depth = bit_depth;
  Sample sample{ scene, integrated ? renderIntegrated(scene) : render(scene), {} };
  for (int u = 0; u < scene.width; ++u)
    sample.expected.push_back(u < kMargin || u >= scene.width - kMargin ? Expected::Beyond : Expected::Centre);
  return sample;
}

void add(const ErrorSums& from, ErrorSums& to)
{
  to.count += from.count;
  to.sum += from.sum;
  to.squares += from.squares;
  to.largest = std::max(to.largest, from.largest);
}
}  // namespace

void compareSystematic(Context& context)
{
  context.report().table("systematic",
                         "noise-free straight stripes, sigma 1.5-5 px, slopes 0-60 deg, point samples and "
                         "integrated pixels: error across [mpx]");
  std::map<std::string, Systematic> results;
  for (const double sigma : { 1.5, 2.0, 3.0, 5.0 })
    for (const double degrees : { 0.0, 7.5, 15.0, 22.5, 30.0, 37.5, 45.0, 52.5, 59.8 })
      for (const bool integrated : { false, true })
        for (const int bits : { 16, 8 })
        {
          const Sample sample = frameOf(sigma, degrees, bits, integrated);
          for (const std::string& name : context.options().methods)
          {
            CandidateSettings settings;
            settings.stripe_sigma = sigma;
            const Score score = judge(*makeCandidate(name, settings), { sample });
            Systematic& result = results[name];
            add(score.measured, bits == 16 ? result.all : result.all_8bit);
            char place[64];
            std::snprintf(place, sizeof place, "sigma %.1f, %.1f deg%s", sigma, degrees,
                          integrated ? ", integrated" : "");
            if (bits == 16 && result.all.largest > result.largest)
            {
              result.largest = result.all.largest;
              result.where = place;
            }
            context.report().row({ { "method", name },
                                   { "sigma", sigma },
                                   { "degrees", degrees },
                                   { "integrated", integrated ? 1.0 : 0.0, 0 },
                                   { "bits", 1.0 * bits, 0 },
                                   { "rms_mpx", 1e3 * score.measured.rmse() },
                                   { "largest_mpx", 1e3 * score.measured.largest },
                                   { "outliers", static_cast<double>(score.outliers), 0 },
                                   { "missing", static_cast<double>(score.missing), 0 } },
                                 Report::Silent);
          }
        }
  for (const std::string& name : context.options().methods)
    context.report().row({ { "method", name },
                           { "16bit_rms", 1e3 * results[name].all.rmse() },
                           { "16bit_largest", 1e3 * results[name].all.largest },
                           { "8bit_rms", 1e3 * results[name].all_8bit.rmse() },
                           { "8bit_largest", 1e3 * results[name].all_8bit.largest },
                           { "largest_at", results[name].where } });
  const auto own = results.find(defaultMethod());
  if (own == results.end())
    return;
  context.report().accept({ "systematic error, noise-free, sigma 1.5-5, to 60 deg, largest (16 bit)",
                            1e3 * own->second.all.largest, 3.0, 1.0, false, "mpx", own->second.where });
  context.report().accept({ "  the same in 8 bit, whose rounding is a noise, RMS", 1e3 * own->second.all_8bit.rmse(),
                            3.0, 1.0, false, "mpx", "" });
}
}  // namespace comparison
}  // namespace weld_profiler
