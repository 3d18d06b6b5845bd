// The paper's Tables 1 and 2 on simulated stripes of the four kinds of its Fig. 8, and what the truth says of them.
//   paper_tables SCENE.yaml [PAGE.md FIGURE.png]    prints the tables; or writes them between the marks of a page and
//                                                   draws the stripes
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "paper/tables.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/stripe/overlay.h"
#include "weld_profiler/stripe/stripe_stage.h"

namespace weld_profiler
{
namespace paper_tables
{
namespace
{
/// The middle half of the four stripes below one another, with what `entry` found.
cv::Mat picture(const std::vector<Kind>& kinds, const Entry& entry)
{
  constexpr int kScale = 2;
  constexpr int kMargin = 28;
  std::vector<cv::Mat> strips;
  for (const Kind& kind : kinds)
  {
    const KindFrame& frame = kind.middle();
    Workspace workspace;
    workspace.keep_trace = true;
    Stripe stripe;
    StripeStage(entry.params).process(frame.image, workspace, stripe);
    const cv::Range columns(frame.image.width / 4, frame.image.width * 3 / 4);
    double highest = frame.image.height;
    double lowest = 0.0;
    for (const TruthCentre& centre : frame.truth)
      if (centre.cell >= columns.start && centre.cell < columns.end)
        highest = std::min(highest, centre.v), lowest = std::max(lowest, centre.v);
    const cv::Range rows(std::max(0, static_cast<int>(highest) - kMargin),
                         std::min(frame.image.height, static_cast<int>(lowest) + kMargin));
    const cv::Mat drawn = drawStripe(frame.image, stripe, workspace.initial, kScale);
    cv::Mat strip = drawn({ kScale * rows.start, kScale * rows.end }, { kScale * columns.start, kScale * columns.end });
    cv::putText(strip, kind.name, { 10, 30 }, cv::FONT_HERSHEY_SIMPLEX, 0.9, { 0, 220, 255 }, 2, cv::LINE_AA);
    strip.row(strip.rows - 1).setTo(cv::Scalar(96, 96, 96));
    strips.push_back(strip);
  }
  cv::Mat all;
  cv::vconcat(strips, all);
  return all;
}

/// Puts a table between its marks of a page.
void replaceBetweenMarks(std::string& page, const std::string& name, const std::string& table)
{
  const std::string begin = "<!-- " + name + ": begin -->\n";
  const std::size_t from = page.find(begin);
  const std::size_t to = page.find("<!-- " + name + ": end -->");
  if (from == std::string::npos || to == std::string::npos || to < from)
    throw InputError("the page has no marks '" + name + ": begin' and '" + name + ": end' to write between");
  page.replace(from + begin.size(), to - from - begin.size(), "\n" + table + "\n");
}

void writePage(const std::string& path, const std::vector<std::pair<const char*, std::string>>& tables)
{
  std::ifstream in(path);
  if (!in)
    throw InputError(path + " cannot be read");
  std::stringstream content;
  content << in.rdbuf();
  std::string page = content.str();
  for (const auto& [name, table] : tables)
    replaceBetweenMarks(page, name, table);
  if (!(std::ofstream(path) << page))
    throw InputError(path + " cannot be written");
}

int run(int argc, char** argv)
{
  if (argc != 2 && argc != 4)
  {
    std::fprintf(stderr, "usage: paper_tables SCENE.yaml [PAGE.md FIGURE.png]\n");
    return 2;
  }
  cv::setNumThreads(1);
  const std::vector<Kind> kinds = renderKinds(argv[1]);
  const std::vector<Entry> methods = entries();
  const std::vector<std::pair<const char*, std::string>> tables = { { "spread", spreadTable(kinds, methods) },
                                                                    { "time", timeTable(kinds, methods) },
                                                                    { "error", errorTable(kinds, methods) } };
  for (const auto& [name, table] : tables)
    std::printf("%s\n\n%s\n", name, table.c_str());
  if (argc == 2)
    return 0;
  writePage(argv[2], tables);
  const auto svd =
      std::find_if(methods.begin(), methods.end(), [](const Entry& entry) { return entry.params.method == "svd"; });
  if (!cv::imwrite(argv[3], picture(kinds, *svd), { cv::IMWRITE_PNG_COMPRESSION, 9 }))
    throw InputError(std::string(argv[3]) + " cannot be written");
  return 0;
}
}  // namespace
}  // namespace paper_tables
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  try
  {
    return weld_profiler::paper_tables::run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
