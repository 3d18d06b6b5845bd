#pragma once

#include <string>
#include <vector>

#include "comparison/report.h"
#include "comparison/score.h"

namespace weld_profiler
{
namespace comparison
{
struct Options
{
  std::vector<std::string> methods;  ///< contestants, in the order printed
  std::vector<std::string> only;     ///< names of parts and scenes; empty = all
  bool quick = false;                ///< fewer seeds
  std::string judged;                ///< the method that the acceptance lines are about
  std::string json;                  ///< file written; empty = none
};

/// What the parts of the comparison share.
class Context
{
public:
  explicit Context(Options options) : options_(std::move(options)) {}

  bool wants(const std::string& part) const;
  const Options& options() const { return options_; }
  const std::string& judged() const { return options_.judged; }
  int seeds(int full) const { return options_.quick ? std::max(2, full / 6) : full; }
  Report& report() { return report_; }

  /// Keeps error over told sigma of a noisy scene for the honesty table.
  void noteHonesty(const std::string& scene, const std::string& method, const Score& score);
  /// Prints that table, and the default method's two acceptance lines.
  void reportHonesty();

private:
  struct Honesty
  {
    std::string scene, method;
    double measured, interpolated;
  };
  void reportHonestyOf(const std::string& method);

  Options options_;
  Report report_;
  std::vector<Honesty> honesty_;
};

/// The parts: each fills tables and acceptance lines.
void compareClean(Context& context);       ///< the grid of noise, width and slope against the bound
void compareSystematic(Context& context);  ///< errors that stay without noise
void compareScenes(Context& context);      ///< bead, reflectance, saturation, ghosts, ...
void compareSpeckle(Context& context);     ///< against Steger with five kernels
void compareNotch(Context& context);       ///< how much of a notch is kept
void compareRepair(Context& context);      ///< gaps by length
void compareTimes(Context& context);
void compareSizes(Context& context);  ///< the default method's time against the image's size
}  // namespace comparison
}  // namespace weld_profiler
