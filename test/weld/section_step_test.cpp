#include <gtest/gtest.h>

#include "weld/ideal_scan.h"
#include "weld_profiler/weld/grinding.h"
#include "weld_profiler/weld/weld_measurer.h"

using namespace weld_profiler;

TEST(SectionStep, TakesSectionsAStepApart)
{
  WeldParams params;
  params.section_step = 0.001;
  const WeldResult result = WeldMeasurer(params).measure(IdealScanner()(IdealWeld()));
  EXPECT_EQ(result.sections.size(), 12u) << "12 mm, rows 0.2 mm apart";
}

TEST(SectionStep, KnowsTheWeldsDirectionHoweverFarApartSectionsAreAskedFor)
{
  for (const double step : { 0.005, 0.01 })
  {
    WeldParams params;
    params.section_step = step;
    const WeldResult result = WeldMeasurer(params).measure(IdealScanner()(IdealWeld()));
    ASSERT_EQ(result.sections.size(), step > 0.006 ? 2u : 3u);
    EXPECT_EQ(result.reason, "");
    for (const WeldSection& section : result.sections)
    {
      EXPECT_NEAR(section.yaw, 0.0, 0.003) << step;
      EXPECT_NEAR(section.width.value, 0.008, 4.0 * section.width.sigma) << step;
    }
  }
}

TEST(SectionStep, SaysThatOneSectionFitsWhereTheStepIsLongerThanTheWeld)
{
  WeldParams params;
  params.section_step = 0.1;
  const Scan scan = IdealScanner()(IdealWeld());
  const WeldResult result = WeldMeasurer(params).measure(scan);
  ASSERT_EQ(result.sections.size(), 1u);
  EXPECT_TRUE(result.sections.front().hasBead()) << "the one section is measured";
  EXPECT_NEAR(result.sections.front().width.value, 0.008, 4.0 * result.sections.front().width.sigma);
  EXPECT_EQ(result.reason.rfind("section_step 100 mm is more than the 11.8 mm of weld", 0), 0u) << result.reason;
  EXPECT_NE(result.reason.find("or 0 for a section a row"), std::string::npos) << result.reason;
  const std::string plan = planGrinding(scan, result, GrindingParams()).reason;
  EXPECT_EQ(plan.rfind("the weld has 1 section,", 0), 0u) << plan;
  EXPECT_NE(plan.find("take a smaller section_step"), std::string::npos) << plan;
}
