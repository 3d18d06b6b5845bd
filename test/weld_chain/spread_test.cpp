#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/temporary_folder.h"
#include "weld/case_file.h"
#include "weld/spread.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
WeldCase someCase()
{
  WeldCase weld;
  weld.seed = 7;
  weld.kind = "butt", weld.measured_kind = "none";
  weld.width = 0.01;
  weld.rows = 100;
  weld.labels[2][1] = 30, weld.labels[2][2] = 90, weld.labels[1][2] = 10;
  SectionCase section;
  section.s = 0.003;
  section.stature = Stature::High;
  section.sizes[Width] = Deviation{ 0.01, 1e-5, 0.0102 };
  section.true_verdict = "B";
  weld.sections = { section, section };
  return weld;
}

std::string contentOf(const std::string& path)
{
  std::ifstream file(path);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

TEST(WeldCaseFile, GivesBackWhatWasSaved)
{
  const TemporaryFolder folder;
  saveCase(someCase(), folder.file("weld.txt"), "build1");
  const auto read = loadCase(folder.file("weld.txt"), "build1");
  ASSERT_TRUE(read);
  saveCase(*read, folder.file("again.txt"), "build1");
  EXPECT_EQ(contentOf(folder.file("weld.txt")), contentOf(folder.file("again.txt")));
  ASSERT_EQ(read->sections.size(), 2u);
  EXPECT_EQ(read->sections[1].true_verdict, "B");
  EXPECT_TRUE(read->sections[1].hasBead());
  EXPECT_FALSE(read->sections[1].sizes[Throat].known());
  EXPECT_EQ(read->labels[2][2], 90);
}

TEST(WeldCaseFile, OfAnotherBuildOrCutShortIsNone)
{
  const TemporaryFolder folder;
  EXPECT_FALSE(loadCase(folder.file("none.txt"), "build1"));
  saveCase(someCase(), folder.file("weld.txt"), "build1");
  EXPECT_FALSE(loadCase(folder.file("weld.txt"), "build2"));
  const std::string whole = contentOf(folder.file("weld.txt"));
  for (const double share : { 0.1, 0.5, 0.9, 0.995 })
  {
    std::ofstream(folder.file("cut.txt")) << whole.substr(0, static_cast<std::size_t>(share * whole.size()));
    EXPECT_FALSE(loadCase(folder.file("cut.txt"), "build1")) << share;
  }
}

TEST(WeldStatistics, SpreadIsThatOfTheErrors)
{
  std::vector<Sample> samples;
  for (int i = -50; i <= 50; ++i)
    samples.push_back({ 1, { 5.0 + 0.01 * i + 0.1, 0.2, 5.0 } });
  samples.push_back({ 1, { kNaN, kNaN, 5.0 } });
  const Spread spread = spreadOf(samples, false);
  EXPECT_EQ(spread.count, 101u);
  EXPECT_NEAR(spread.known, 101.0 / 102.0, 1e-12);
  EXPECT_NEAR(spread.median, 0.1, 1e-12);
  EXPECT_NEAR(spread.largest, 0.6, 1e-12);
  EXPECT_NEAR(spread.plain, 0.2915 / 0.2, 0.001) << "uniform over +-0.5: 0.2915, the offset is not in it";
  EXPECT_GT(spread.robust, spread.plain) << "the offset is";
}

TEST(WeldStatistics, WhatIsFoldedAtZeroTellsNothingOfItsSigmaThere)
{
  const std::vector<Sample> samples = { { 1, { 0.02, 0.01, 0.0 } }, { 1, { 0.5, 0.01, 0.49 } } };
  EXPECT_EQ(spreadOf(samples, true).honest_count, 1u);
  EXPECT_EQ(spreadOf(samples, true).count, 2u);
}

TEST(WeldStatistics, IntersectionOverUnionCountsBothMistakes)
{
  EXPECT_NEAR(intersectionOverUnion(someCase().labels, 2), 90.0 / 130.0, 1e-12);
  EXPECT_FALSE(intersectionOverUnion(someCase().labels, 4) == 0.0) << "nothing there, nothing said: no number";
}

TEST(WeldStatistics, AllowanceIsAPercentOrFiveMicrometresOfHeight)
{
  WeldCase weld = someCase();
  weld.volumes.length = 0.02;
  EXPECT_NEAR(overAllowance(weld, 1.02e-6, 1.0e-6), 2.0, 1e-9);
  EXPECT_NEAR(overAllowance(weld, 1e-9, 0.0), 1.0, 1e-9) << "5 um x 10 mm x 20 mm";
}
}  // namespace
}  // namespace weld_accuracy
}  // namespace weld_profiler
