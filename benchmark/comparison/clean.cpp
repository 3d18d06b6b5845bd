// The grid of clean noise: every method against the truth and the bound.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "comparison/bound.h"
#include "comparison/context.h"
#include "comparison/reach.h"
#include "comparison/scenes.h"

namespace weld_profiler
{
namespace comparison
{
using test_support::StripePicture;

namespace
{
const double kSnrs[] = { 20.0, 50.0, 100.0 };
const double kSigmas[] = { 1.5, 2.0, 3.0, 5.0 };
const double kSlopes[] = { 0.0, 15.0, 30.0, 45.0, 60.0 };
constexpr double kOff = 0.17;  ///< off the whole degrees, so that every sub-pixel place occurs [deg]
constexpr int kSeeds = 36;     ///< frames of 300 judged columns
constexpr int kOwnSeeds =
    240;                     ///< of the default method, whose bar leaves 3 %: the worst of 60 cells is lifted by chance
constexpr int kMargin = 30;  ///< columns at the image's ends that are not judged

struct Cell
{
  double snr = 0.0, sigma = 0.0, degrees = 0.0;

  double slope() const { return std::tan((degrees + kOff) * kDegree); }
  std::string text() const
  {
    char line[64];
    std::snprintf(line, sizeof line, "SNR %g sigma %g %g deg", snr, sigma, degrees);
    return line;
  }
};

struct Ratios
{
  double of_column = 0.0, of_used = 0.0;
  double chance = 0.0;  ///< 1-sigma of either, relative: as many independent errors as centres / columns used
};

/// Peak and background leave five sigmas of the noise to both ends of the grey scale.
StripePicture sceneOf(const Cell& cell)
{
  StripePicture scene = straightScene(cell.sigma, cell.degrees + kOff, 0);
  scene.snr = cell.snr;
  scene.peak = 180.0;
  scene.background = 32.0;
  return scene;
}

class Grid
{
public:
  explicit Grid(Context& context) : context_(context) {}

  void run()
  {
    context_.report().table("clean",
                            "straight stripes in clean noise; RMSE across [mpx], ratio to the bound of one "
                            "column / of the columns used");
    for (const double sigma : kSigmas)
      for (const double degrees : kSlopes)
      {
        const Cell first{ kSnrs[0], sigma, degrees };
        const std::vector<double> light = lightOf(sceneOf(first));
        for (const double snr : kSnrs)
          runCell(Cell{ snr, sigma, degrees }, light);
      }
    printTables();
    printTold();
    accept();
  }

private:
  void runCell(const Cell& cell, const std::vector<double>& light)
  {
    StripePicture scene = sceneOf(cell);
    const Bound bound({ cell.sigma, cell.slope(), scene.peak, scene.background, cell.snr, scene.clip });
    std::map<std::string, Score> scores;
    CandidateSettings settings;
    settings.stripe_sigma = cell.sigma;
    std::map<std::string, std::unique_ptr<Candidate>> candidates;
    for (const std::string& name : context_.options().methods)
      candidates[name] = makeCandidate(name, settings);
    Stripe stripe;
    const int seeds = context_.seeds(kSeeds),
              own_seeds = candidates.count(context_.judged()) > 0 ? context_.seeds(kOwnSeeds) : 0;
    for (int seed = 0; seed < std::max(seeds, own_seeds); ++seed)
    {
      scene.seed = 7000U + 100U * static_cast<unsigned>(cell.snr) + static_cast<unsigned>(seed);
      Sample sample{ scene, render(scene, light), {} };
      for (int u = 0; u < scene.width; ++u)
        sample.expected.push_back(u < kMargin || u >= scene.width - kMargin ? Expected::Beyond : Expected::Centre);
      for (auto& [name, candidate] : candidates)
      {
        if (seed >= (name == context_.judged() ? own_seeds : seeds))
          continue;
        candidate->reset();
        candidate->process(sample.picture.raw(), stripe);
        scores[name].add(sample, stripe, *candidate);
      }
    }
    for (const std::string& name : context_.options().methods)
      keep(cell, bound, name, scores[name]);
  }

  void keep(const Cell& cell, const Bound& bound, const std::string& name, const Score& score)
  {
    // The bound of each centre's own columns; the mean square of them is what the mean square error is held against.
    double squares = 0.0, columns = 0.0;
    for (int told : score.columns_told)
    {
      if (told == 0)
        told = columnsUsed(name, cell.sigma, cell.degrees + kOff);
      columns += told;
      squares += std::pow(bound.ofColumns(told), 2.0);
    }
    const auto count = static_cast<double>(score.columns_told.size());
    const double used = std::sqrt(squares / count), column = bound.ofColumns(1);
    if (name == context_.judged() && cell.snr == kSnrs[2] && !score.columns_told.empty() &&
        score.columns_told.front() > 0)
      told_.push_back(Told{ cell, columns / count, columnsByDisturbing(name, cell.sigma, cell.degrees + kOff) });
    const double rmse = score.measured.rmse();
    const Ratios ratios{ rmse / column, rmse / used, 1.0 / std::sqrt(2.0 * count * count / columns) };
    results_[name].emplace_back(cell, ratios);
    rmse_[name].push_back(1e3 * rmse);
    context_.noteHonesty("clean " + cell.text(), name, score);
    context_.report().row({ { "method", name },
                            { "snr", cell.snr },
                            { "sigma", cell.sigma },
                            { "degrees", cell.degrees },
                            { "rmse_mpx", 1e3 * rmse },
                            { "bias_mpx", 1e3 * score.measured.bias() },
                            { "bound_of_column_mpx", 1e3 * column },
                            { "bound_of_used_mpx", 1e3 * used },
                            { "columns", columns / count },
                            { "ratio_column", ratios.of_column },
                            { "ratio_used", ratios.of_used },
                            { "chance", ratios.chance },
                            { "honesty", score.measured.honesty() },
                            { "outliers_percent", score.outlierPercent() },
                            { "missing_percent", score.missingPercent() } },
                          Report::Silent);
  }

  void printTables()
  {
    for (const std::string& name : context_.options().methods)
    {
      std::printf("\n%s: RMSE [mpx] (ratio to the bound of one column, of the columns used)\n", name.c_str());
      std::printf("%-18s", "");
      for (const double degrees : kSlopes)
        std::printf(" %10.0f deg        ", degrees);
      std::printf("\n");
      for (const double snr : kSnrs)
        for (const double sigma : kSigmas)
        {
          std::printf("SNR %3.0f sigma %3.1f ", snr, sigma);
          for (std::size_t i = 0; i < results_[name].size(); ++i)
          {
            const auto& [cell, ratios] = results_[name][i];
            if (cell.snr == snr && cell.sigma == sigma)
              std::printf(std::isfinite(ratios.of_used) ? " %7.2f (%5.2f %5.2f)" : "       -               ",
                          rmse_[name][i], ratios.of_column, ratios.of_used);
          }
          std::printf("\n");
        }
    }
  }

  void accept()
  {
    const std::string method = context_.judged();
    if (results_.count(method) == 0)
      return;
    const auto worst = [&](double Ratios::*ratio)
    {
      return *std::max_element(results_[method].begin(), results_[method].end(),
                               [=](const auto& a, const auto& b) { return a.second.*ratio < b.second.*ratio; });
    };
    const auto used = worst(&Ratios::of_used), column = worst(&Ratios::of_column);
    const auto detail = [&](const std::pair<Cell, Ratios>& cell, double Ratios::*ratio)
    {
      std::vector<double> all;
      for (const auto& result : results_[method])
        all.push_back(result.second.*ratio);
      std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
      char text[128];
      std::snprintf(text, sizeof text, "%s +-%.1f %%; median of the grid %.3f", cell.first.text().c_str(),
                    100.0 * cell.second.chance, all[all.size() / 2]);
      return std::string(text);
    };
    context_.report().accept({ "clean noise: RMSE / bound of the columns used, worst of the grid", used.second.of_used,
                               1.10, 1.03, false, "x", detail(used, &Ratios::of_used) });
    context_.report().accept({ "clean noise: RMSE / bound of one column, worst of the grid", column.second.of_column,
                               0.75, 0.5, false, "x", detail(column, &Ratios::of_column) });
  }

  struct Told
  {
    Cell cell;
    double told;
    int disturbed;
  };

  /// Whether the default method uses no more columns than it tells.
  void printTold()
  {
    if (told_.empty())
      return;
    context_.report().table("columns", "columns the default method tells, SNR 100, and those that move its centre");
    for (const Told& line : told_)
      context_.report().row(
          { { "cell", line.cell.text() }, { "told", line.told, 1 }, { "disturbed", 1.0 * line.disturbed, 0 } });
  }

  Context& context_;
  std::vector<Told> told_;
  std::map<std::string, std::vector<std::pair<Cell, Ratios>>> results_;
  std::map<std::string, std::vector<double>> rmse_;
};
}  // namespace

void compareClean(Context& context)
{
  Grid(context).run();
}
}  // namespace comparison
}  // namespace weld_profiler
