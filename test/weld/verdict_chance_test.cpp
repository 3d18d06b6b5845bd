// Monte Carlo: the truth is known, the measurement has noise of the sigma that it states.
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "weld/sections.h"
#include "weld_profiler/weld/verdict.h"

using namespace weld_profiler;

namespace
{
constexpr double kMostWrong = 0.025;  // of the decided

struct Count
{
  int all = 0;
  int decided = 0;
  int wrong = 0;
  int clear = 0;            ///< the truth lies more than 4 sigma from every limit
  int clear_undecided = 0;  ///< ... and yet

  void add(const std::string& measured, const std::string& truth, bool is_clear)
  {
    ++all;
    decided += measured != "undecided" ? 1 : 0;
    wrong += measured != "undecided" && measured != truth ? 1 : 0;
    clear += is_clear ? 1 : 0;
    clear_undecided += is_clear && measured == "undecided" ? 1 : 0;
  }

  void report(const char* what) const
  {
    std::printf("%s: %d judged, %d decided, %d wrong (%.2f %%); %d clear, of them %d undecided (%.2f %%)\n", what, all,
                decided, wrong, 100.0 * wrong / decided, clear, clear_undecided, 100.0 * clear_undecided / clear);
  }
};

std::vector<Quantity WeldSection::*> judgedFields()
{
  return { &WeldSection::width, &WeldSection::reinforcement, &WeldSection::undercut_left, &WeldSection::undercut_right,
           &WeldSection::misalignment };
}

WeldSection exact(WeldSection section)
{
  for (Quantity WeldSection::*field : judgedFields())
    (section.*field).sigma = 0.0;
  return section;
}

/// Whether the truth lies more than 4 sigma from every limit that is judged.
bool isClear(const WeldJudge& judge, WeldKind kind, const WeldSection& truth)
{
  for (const Judgement& judgement : judge.judge(kind, truth).judgements)
    for (const Comparison& comparison : judgement.levels)
    {
      if (judgement.decides && std::abs(comparison.margin.value) <= 4.0 * comparison.margin.sigma)
        return false;
    }
  return true;
}

/// Sizes all over the limits of a plate of 5 mm.
WeldSection randomTruth(std::mt19937& random)
{
  const auto between = [&random](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  WeldSection section = goodSection();
  section.width = { between(4e-3, 20e-3), 30e-6 };
  section.reinforcement = { between(0.0, 5e-3), 10e-6 };
  section.undercut_left = { between(0.0, 0.6e-3), 15e-6 };
  section.undercut_right = { between(0.0, 0.6e-3), 15e-6 };
  section.misalignment = { between(0.0, 1e-3), 10e-6 };
  section.height_left = section.height_right = {};
  return section;
}

WeldSection measured(const WeldSection& truth, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  WeldSection section = truth;
  for (Quantity WeldSection::*field : judgedFields())
  {
    Quantity& quantity = section.*field;
    quantity.value = std::abs(quantity.value + quantity.sigma * normal(random));  // none of them is below zero
  }
  return section;
}

/// A weld of 50 mm whose undercut is the same all along, measured with noise, part of it common to all sections.
std::vector<WeldSection> measuredWeld(double depth, double common_share, std::mt19937& random)
{
  const double sigma = 15e-6;
  std::normal_distribution<double> normal;
  const double common = std::sqrt(common_share) * normal(random);
  std::vector<WeldSection> sections = goodWeld(0.05);
  for (WeldSection& section : sections)
  {
    const double noise = common + std::sqrt(1.0 - common_share) * normal(random);
    section.undercut_left = { std::abs(depth + sigma * noise), sigma };
  }
  return sections;
}
}  // namespace

TEST(VerdictByChance, OfSectionsIsRarelyWrongAndDecidedWhereItIsClear)
{
  std::mt19937 random(5817);
  const WeldJudge judge(plate(5.0));
  Count count;
  for (int i = 0; i < 20000; ++i)
  {
    const WeldSection truth = randomTruth(random);
    const std::string right = judge.judge(WeldKind::Butt, exact(truth)).verdict;
    count.add(judge.judge(WeldKind::Butt, measured(truth, random)).verdict, right,
              isClear(judge, WeldKind::Butt, truth));
  }
  count.report("sections");
  ASSERT_GT(count.decided, 10000);
  ASSERT_GT(count.clear, 5000);
  EXPECT_LE(count.wrong, kMostWrong * count.decided);
  // 4 sigma off, noise of more than 2 sigma is needed: 2.3 % at the very edge, far less beyond it
  EXPECT_LE(count.clear_undecided, 0.002 * count.clear);
}

TEST(VerdictByChance, OfSectionsNearALimitIsRarelyWrong)
{
  // the hard case: all truths within 4 sigma of a limit. At the limit itself 2.3 % are decided wrongly.
  std::mt19937 random(502);
  const WeldJudge judge(VerdictParams{});
  int wrong = 0;
  const int count = 20000;
  for (int i = 0; i < count; ++i)
  {
    WeldSection truth = randomTruth(random);
    const double off = std::uniform_real_distribution<double>(-4.0, 4.0)(random);
    truth.reinforcement.value = 1e-3 + 0.10 * truth.width.value + off * 10e-6;
    const std::string right = judge.judge(WeldKind::Butt, exact(truth)).verdict;
    const std::string verdict = judge.judge(WeldKind::Butt, measured(truth, random)).verdict;
    wrong += verdict != "undecided" && verdict != right ? 1 : 0;
  }
  std::printf("near a limit: %.2f %% of all wrong\n", 100.0 * wrong / count);
  EXPECT_LE(wrong, kMostWrong * count);
}

TEST(VerdictByChance, OfWeldsIsRarelyWrongWhateverItsSectionsShare)
{
  const WeldJudge judge(plate(5.0));  // limits of undercut: 0.25, 0.5, 1.0 mm
  for (const double common_share : { 0.0, 0.5, 1.0 })
  {
    std::mt19937 random(5011);
    Count count;
    for (int i = 0; i < 1500; ++i)
    {
      const double depth = std::uniform_real_distribution<double>(0.1e-3, 1.2e-3)(random);
      const std::string right = depth <= 0.25e-3 ? "B" : (depth <= 0.5e-3 ? "C" : (depth <= 1e-3 ? "D" : "fail"));
      const std::vector<WeldSection> sections = measuredWeld(depth, common_share, random);
      double distance = 1.0;
      for (const double limit : { 0.25e-3, 0.5e-3, 1e-3 })
        distance = std::min(distance, std::abs(depth - limit));
      WeldToJudge weld;
      weld.kind = WeldKind::Fillet;
      weld.sections = &sections;
      count.add(judge.judge(weld).verdict, right, distance > 4.0 * 15e-6);
    }
    count.report(("welds, common share " + std::to_string(common_share)).c_str());
    ASSERT_GT(count.decided, 500);
    ASSERT_GT(count.clear, 500);
    EXPECT_LE(count.wrong, kMostWrong * count.decided);
    EXPECT_LE(count.clear_undecided, 0.01 * count.clear) << "a fourth of them lies within 8 sigma";
  }
}

TEST(VerdictByChance, OfWeldsAtALimitFailsNoMoreOftenThanASectionWould)
{
  // the largest of 200 sections lies 2.75 sigma above the truth; medians and the rule for many places hold the error
  std::mt19937 random(25);
  VerdictParams params = plate(5.0);
  for (const double min_length : { 1e-3, 0.0 })
  {
    params.min_length = min_length;
    const WeldJudge judge(params);
    int failed = 0;
    const int count = 1000;
    for (int i = 0; i < count; ++i)
    {
      const std::vector<WeldSection> sections = measuredWeld(1e-3, 0.0, random);
      WeldToJudge weld;
      weld.kind = WeldKind::Fillet;
      weld.sections = &sections;
      failed += judge.judge(weld).verdict == "fail" ? 1 : 0;
    }
    std::printf("at a limit, medians over %.0f mm: %.1f %% failed\n", min_length * 1e3, 100.0 * failed / count);
    EXPECT_LE(failed, 0.0375 * count) << "2.3 % and three standard deviations of a count of 1000";
  }
}
