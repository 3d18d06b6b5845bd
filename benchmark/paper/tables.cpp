#include "tables.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <random>

#include "weld_profiler/stripe/stripe_stage.h"

namespace weld_profiler
{
namespace paper_tables
{
namespace
{
constexpr int kTimedFrames = 101;

std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string text(const char* format, ...)
{
  char buffer[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof(buffer), format, arguments);
  va_end(arguments);
  return buffer;
}

/// A row for each name, a column for each kind.
template <class Cell>
std::string tableRow(const std::string& name, const std::vector<Kind>& kinds, Cell&& cell)
{
  std::string row = "| " + name + " |";
  for (const Kind& kind : kinds)
    row += " " + cell(kind) + " |";
  return row + "\n";
}

std::string tableHead(const std::string& what, const std::vector<Kind>& kinds)
{
  std::string head = tableRow(what, kinds, [](const Kind& kind) { return kind.name; }) + "|---|";
  for (std::size_t i = 0; i < kinds.size(); ++i)
    head += "---|";
  return head + "\n";
}

/// A row of the paper's own figures.
std::string quoted(const std::string& name, std::initializer_list<const char*> values)
{
  std::string row = "| " + name + " |";
  for (const char* value : values)
    row += std::string(" ") + value + " |";
  return row + "\n";
}

Stripe extract(const Entry& entry, const KindFrame& frame)
{
  Workspace workspace;
  Stripe stripe;
  StripeStage(entry.params).process(frame.image, workspace, stripe);
  return stripe;
}

/// Eq. 12 of one coordinate: the standard deviation about the mean.
template <class Values>
double spread(const Values& values)
{
  double mean = 0.0;
  for (const double value : values)
    mean += value / static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values)
    squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

template <class Values>
std::string spreads(const Values& u, const Values& v)
{
  return u.size() < 2 ? "-" : text("%.4f, %.4f", spread(u), spread(v));
}

/// Eq. 12 of the truth itself, of what `change` leaves or makes of it.
template <class Change>
std::string spreadsOfTruth(const Kind& kind, Change&& change)
{
  std::vector<double> u, v;
  for (TruthCentre centre : kind.middle().truth)
    if (change(centre))
    {
      u.push_back(centre.u);
      v.push_back(centre.v);
    }
  return spreads(u, v);
}

double medianMilliseconds(const Entry& entry, const Kind& kind)
{
  const StripeStage stage(entry.params);
  Workspace workspace;
  Stripe stripe;
  std::vector<double> times;
  for (std::size_t i = 0; i < kTimedFrames; ++i)
  {
    const RawImage& image = kind.frames[i % kind.frames.size()].image;
    const auto begin = std::chrono::steady_clock::now();
    stage.process(image, workspace, stripe);
    times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

struct Score
{
  double squares = 0.0;
  std::size_t measured = 0, beyond = 0, cells = 0;

  void add(const Stripe& stripe, const std::vector<TruthCentre>& truth)
  {
    cells += truth.size();
    std::size_t i = 0;
    for (const TruthCentre& true_centre : truth)
    {
      while (i < stripe.size() && stripe.cell[i] < true_centre.cell)
        ++i;
      if (i == stripe.size() || stripe.cell[i] != true_centre.cell ||
          (stripe.flags[i] & stripe_flag::kInterpolated) != 0)
        continue;
      const double error = (stripe.u[i] - true_centre.u) * std::cos(true_centre.normal_angle) +
                           (stripe.v[i] - true_centre.v) * std::sin(true_centre.normal_angle);
      squares += error * error;
      ++measured;
      beyond += std::abs(error) > 1.0 ? 1 : 0;
    }
  }
};
}  // namespace

std::string spreadTable(const std::vector<Kind>& kinds, const std::vector<Entry>& entries)
{
  std::string table = tableHead("sigma_x, sigma_y [px]", kinds);
  for (const Entry& entry : entries)
    table += tableRow(entry.name, kinds,
                      [&](const Kind& kind)
                      {
                        const Stripe stripe = extract(entry, kind.middle());
                        return spreads(stripe.u, stripe.v);
                      });
  std::mt19937 random(1);
  std::normal_distribution<double> off;
  table += tableRow("the truth", kinds,
                    [](const Kind& kind) { return spreadsOfTruth(kind, [](TruthCentre&) { return true; }); });
  table += tableRow("the truth, every point off by 1 px RMS", kinds,
                    [&](const Kind& kind)
                    { return spreadsOfTruth(kind, [&](TruthCentre& c) { return c.v += off(random), true; }); });
  table +=
      tableRow("the truth, 100 columns lost at either edge", kinds,
               [](const Kind& kind)
               {
                 const int width = kind.middle().image.width;
                 return spreadsOfTruth(kind, [=](TruthCentre& c) { return c.cell >= 100 && c.cell < width - 100; });
               });
  table +=
      tableRow("a horizontal line, whatever the image shows", kinds,
               [](const Kind& kind) { return spreadsOfTruth(kind, [](TruthCentre& c) { return c.v = 0.0, true; }); });
  table +=
      quoted("the paper's Steger", { "419.5031, 8.8057", "377.3527, 7.0634", "391.7558, 7.4794", "378.2376, 8.0841" });
  table += quoted("the paper's gray centroid",
                  { "415.8365, 8.6983", "411.5613, 7.8676", "414.9933, 8.0887", "415.2557, 8.9220" });
  return table + quoted("the paper's approach",
                        { "415.8363, 8.7775", "406.0891, 7.7081", "406.0931, 7.7821", "401.8171, 8.5814" });
}

std::string timeTable(const std::vector<Kind>& kinds, const std::vector<Entry>& entries)
{
  std::string table = tableHead("ms a frame", kinds);
  for (const Entry& entry : entries)
    table +=
        tableRow(entry.name, kinds, [&](const Kind& kind) { return text("%.2f", medianMilliseconds(entry, kind)); });
  table += quoted("the paper's Steger", { "1835.3", "1883.1", "1899.9", "1912.4" });
  table += quoted("the paper's gray centroid", { "39.8", "35.5", "47.0", "41.7" });
  table += quoted("the paper's PCA", { "462.0", "574.0", "538.0", "568.8" });
  return table + quoted("the paper's approach", { "281.6", "411.6", "420.8", "428.9" });
}

std::string errorTable(const std::vector<Kind>& kinds, const std::vector<Entry>& entries)
{
  std::string table = tableHead("RMSE [mpx], beyond 1 px, missing", kinds);
  for (const Entry& entry : entries)
    table += tableRow(entry.name, kinds,
                      [&](const Kind& kind)
                      {
                        Score score;
                        for (const KindFrame& frame : kind.frames)
                          score.add(extract(entry, frame), frame.truth);
                        const auto all = static_cast<double>(score.cells);
                        const auto some = static_cast<double>(score.measured);
                        return text("%.1f, %.2f %%, %.2f %%", 1000.0 * std::sqrt(score.squares / some),
                                    100.0 * static_cast<double>(score.beyond) / all, 100.0 * (all - some) / all);
                      });
  return table;
}
}  // namespace paper_tables
}  // namespace weld_profiler
