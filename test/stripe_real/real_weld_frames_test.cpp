#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

#include "weld_profiler/camera/folder_source.h"
#include "weld_profiler/stripe/stripe_methods.h"
#include "weld_profiler/stripe/stripe_stage.h"

// Six frames of a weld-seam sensor on bare metal against the stripe as marked by hand (test/data/real/*.csv, vertices
// of polylines in pixels, good to 1-2 px). The images are not part of the package: docs/real-data.md says where they
// are from.

namespace weld_profiler
{
namespace
{
constexpr double kTolerancePx = 3.0;  // the marks' own error, plus half a flank of a 13 px wide stripe
constexpr std::array<const char*, 6> kFrames{ { "test100", "test102", "test103", "test105", "test105_4", "test107" } };

struct Vertex
{
  double u = 0.0, v = 0.0;
};
using Polyline = std::vector<Vertex>;

std::vector<Polyline> readMarks(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "piece,u_px,v_px") << path;
  std::vector<Polyline> pieces;
  while (std::getline(file, line))
  {
    std::istringstream fields(line);
    std::size_t piece = 0;
    Vertex vertex;
    char comma = 0;
    fields >> piece >> comma >> vertex.u >> comma >> vertex.v;
    EXPECT_TRUE(fields) << path << ": " << line;
    pieces.resize(std::max(pieces.size(), piece + 1));
    pieces[piece].push_back(vertex);
  }
  return pieces;
}

/// Marked row of each column; a column that two pieces share has two.
std::multimap<int, double> markedRows(const std::vector<Polyline>& pieces)
{
  std::multimap<int, double> rows;
  for (const Polyline& piece : pieces)
    for (std::size_t i = 0; i + 1 < piece.size(); ++i)
    {
      const Vertex& a = piece[i];
      const Vertex& b = piece[i + 1];
      const bool last = i + 2 == piece.size();
      for (int u = static_cast<int>(std::ceil(a.u)); u < b.u || (last && u <= b.u); ++u)
        rows.emplace(u, a.v + (b.v - a.v) * (u - a.u) / (b.u - a.u));
    }
  return rows;
}

struct Score
{
  int marked = 0;        ///< columns in which the stripe was marked
  int found = 0;         ///< of them with a centre within the tolerance
  int interpolated = 0;  ///< of the found ones: filled across a gap
  int wrong = 0;         ///< of them with a centre further off

  double share() const { return marked == 0 ? 0.0 : static_cast<double>(found) / marked; }
  void operator+=(const Score& other)
  {
    marked += other.marked;
    found += other.found;
    interpolated += other.interpolated;
    wrong += other.wrong;
  }
};

Score judge(const Stripe& stripe, const std::multimap<int, double>& marks)
{
  std::map<int, std::size_t> point_of;
  for (std::size_t i = 0; i < stripe.size(); ++i)
    point_of[stripe.cell[i]] = i;
  Score score;
  for (auto cell = marks.begin(); cell != marks.end(); cell = marks.upper_bound(cell->first))
  {
    ++score.marked;
    const auto point = point_of.find(cell->first);
    if (point == point_of.end())
      continue;
    double distance = INFINITY;
    const auto range = marks.equal_range(cell->first);
    for (auto mark = range.first; mark != range.second; ++mark)
      distance = std::min(distance, std::abs(stripe.v[point->second] - mark->second));
    const bool hit = distance <= kTolerancePx;
    score.found += hit ? 1 : 0;
    score.wrong += hit ? 0 : 1;
    score.interpolated += hit && (stripe.flags[point->second] & stripe_flag::kInterpolated) != 0 ? 1 : 0;
  }
  return score;
}

class RealWeldFrames : public ::testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    const char* folder = std::getenv("WELD_PROFILER_REAL_DATA");
    if (folder == nullptr || *folder == '\0')
      GTEST_SKIP() << "WELD_PROFILER_REAL_DATA is not set, the real weld frames are not judged; docs/real-data.md says "
                      "where the images come from";
    folder_ = std::string(folder) + "/weld-joints/";
  }

  Score judgeFrame(const std::string& method, const std::string& stem) const
  {
    StripeParams params;
    params.method = method;
    const StripeStage stage(params);
    Frame frame;
    readImage(folder_ + stem + ".png", frame);
    Workspace workspace;
    Stripe stripe;
    stage.process(frame.view(), workspace, stripe);
    EXPECT_EQ(stripe.direction, Direction::AlongU) << stem << ": told from the image";
    const auto marks = markedRows(readMarks("test/data/real/" + stem + ".csv"));
    EXPECT_GT(marks.size(), 1000u) << stem;
    return judge(stripe, marks);
  }

  std::string folder_;
};

TEST_P(RealWeldFrames, FindsTheMarkedStripe)
{
  Score total;
  std::cout << std::fixed << std::setprecision(1);
  for (const char* stem : kFrames)
  {
    const Score score = judgeFrame(GetParam(), stem);
    std::cout << GetParam() << " " << stem << ": " << 100.0 * score.share() << " % of " << score.marked
              << " marked columns within " << kTolerancePx << " px (" << score.interpolated << " interpolated), "
              << score.wrong << " further off\n";
    total += score;
  }
  std::cout << GetParam() << " all: " << 100.0 * total.share() << " %, " << total.wrong << " further off" << std::endl;
  ASSERT_GT(total.marked, 8000) << "the loop above judged something";
  // measured 99.4 % for the default method; what is missing lies in the dark step of test103
  EXPECT_GE(total.share(), GetParam() == StripeParams().method ? 0.98 : 0.90);
  EXPECT_LE(total.wrong, total.marked / 50);
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, RealWeldFrames, ::testing::ValuesIn(stripeMethods()),
                         [](const auto& info) { return info.param; });
}  // namespace
}  // namespace weld_profiler
