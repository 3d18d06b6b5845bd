#include "weld_profiler/weld/verdict.h"

#include <gtest/gtest.h>

#include "weld/sections.h"

using namespace weld_profiler;

namespace
{
const double kSigma = 1e-5;  // of goodSection()

std::string verdictOf(const WeldSection& section, const VerdictParams& params = {}, WeldKind kind = WeldKind::Butt)
{
  return WeldJudge(params).judge(kind, section).verdict;
}

/// A section whose reinforcement lies this many sigmas of the margin beyond the limit of a level, b = 12 mm.
WeldSection beyond(double limit, double factor, double sigmas)
{
  WeldSection section = goodSection();
  section.reinforcement.value = limit + sigmas * kSigma * std::sqrt(1.0 + factor * factor);
  section.height_left = section.height_right = section.reinforcement;
  return section;
}
}  // namespace

TEST(SectionVerdict, IsTheBestLevelMet)
{
  WeldSection section = goodSection();
  EXPECT_EQ(verdictOf(section), "B");
  section.reinforcement.value = 2.5e-3;
  EXPECT_EQ(verdictOf(section), "C");
  section.reinforcement.value = 3.5e-3;
  EXPECT_EQ(verdictOf(section), "D");
  section.reinforcement.value = 4.5e-3;
  EXPECT_EQ(verdictOf(section), "fail");
}

TEST(SectionVerdict, IsUndecidedWithinTwoSigmaOfALimit)
{
  const struct
  {
    double limit, factor;
    const char *better, *worse;
  } cases[] = { { 2.2e-3, 0.10, "B", "C" }, { 2.8e-3, 0.15, "C", "D" }, { 4.0e-3, 0.25, "D", "fail" } };
  for (const auto& c : cases)
  {
    EXPECT_EQ(verdictOf(beyond(c.limit, c.factor, -2.1)), c.better);
    EXPECT_EQ(verdictOf(beyond(c.limit, c.factor, -1.9)), "undecided");
    EXPECT_EQ(verdictOf(beyond(c.limit, c.factor, 1.9)), "undecided");
    EXPECT_EQ(verdictOf(beyond(c.limit, c.factor, 2.1)), c.worse);
  }
}

TEST(SectionVerdict, CountsTheSigmaOfTheWidthIntoTheLimits)
{
  WeldSection section = beyond(4.0e-3, 0.25, -4.0);
  EXPECT_EQ(verdictOf(section), "D");
  section.width.sigma = 2e-4;  // the limit's sigma: 0.25 * 0.2 mm = 50 um
  EXPECT_EQ(verdictOf(section), "undecided");
  const Judgement judgement = WeldJudge(VerdictParams{}).judge(WeldKind::Butt, section).judgements.front();
  EXPECT_NEAR(judgement.at(QualityLevel::D).limit.sigma, 5e-5, 1e-12);
  EXPECT_NEAR(judgement.at(QualityLevel::D).margin.sigma, std::hypot(5e-5, kSigma), 1e-12);
}

TEST(SectionVerdict, WithExactValuesIsAlwaysDecided)
{
  WeldSection section = goodSection();
  section.width.sigma = section.reinforcement.sigma = 0.0;
  section.reinforcement.value = 2.2e-3;
  EXPECT_EQ(verdictOf(section), "B") << "a size at its limit is within it";
  section.reinforcement.value = 2.2e-3 + 1e-9;
  EXPECT_EQ(verdictOf(section), "C");
}

TEST(SectionVerdict, IsDecidedWhereTheUncertainLevelCannotMatter)
{
  // undercut at its limit of level B, but the reinforcement has failed B already
  WeldSection section = goodSection();
  section.undercut_left.value = 0.2e-3;
  EXPECT_EQ(verdictOf(section, plate(4.0)), "undecided");
  section.reinforcement.value = 2.5e-3;
  EXPECT_EQ(verdictOf(section, plate(4.0)), "C");
  // at D's limit: C is failed for certain, D is not certain
  section.undercut_left.value = 0.8e-3;
  EXPECT_EQ(verdictOf(section, plate(4.0)), "undecided");
  section.reinforcement.value = 4.5e-3;
  EXPECT_EQ(verdictOf(section, plate(4.0)), "fail");
}

TEST(SectionVerdict, TellsWhichLevelsAreMetThoughTheBestIsUndecided)
{
  const SectionVerdict verdict = WeldJudge(VerdictParams{}).judge(WeldKind::Butt, beyond(2.2e-3, 0.1, 0.5));
  EXPECT_EQ(verdict.verdict, "undecided");
  EXPECT_EQ(verdict.levels[0], Decision::Undecided);
  EXPECT_EQ(verdict.levels[1], Decision::Pass);
  EXPECT_EQ(verdict.levels[2], Decision::Pass);
}

TEST(SectionVerdict, JudgesUndercutAndMisalignmentOnceTheThicknessIsGiven)
{
  WeldSection section = goodSection();
  section.undercut_right.value = 0.5e-3;
  EXPECT_EQ(verdictOf(section), "B");
  EXPECT_EQ(verdictOf(section, plate(4.0)), "D") << "limits 0.2, 0.4, 0.8 mm";
  section = goodSection();
  section.misalignment.value = 0.5e-3;
  section.height_left.value = 1.25e-3;
  EXPECT_EQ(verdictOf(section), "B");
  EXPECT_EQ(verdictOf(section, plate(4.0)), "C") << "limits 0.4, 0.6, 1.0 mm";
}

TEST(SectionVerdict, JudgesTheToeAngleOnlyWhenAsked)
{
  WeldSection section = goodSection();
  section.toe_angle_left.value = 130.0 * kDegree;
  EXPECT_EQ(verdictOf(section), "B");
  VerdictParams params;
  params.judge_toe_angle = true;
  EXPECT_EQ(verdictOf(section, params), "C") << "at least 150, 110, 90 deg";
  section.toe_angle_right.value = 80.0 * kDegree;
  EXPECT_EQ(verdictOf(section, params), "fail");
  section.toe_angle_right.value = 91.0 * kDegree;
  EXPECT_EQ(verdictOf(section, params), "undecided") << "90 deg lies within 2 sigma";
  section.toe_angle_right = {};
  EXPECT_EQ(verdictOf(section, params), "undecided");
  EXPECT_EQ(verdictOf(section), "B");
}

TEST(SectionVerdict, JudgesAFilletByItsConvexity)
{
  WeldSection section = goodSection();
  section.width.value = 50e-3;
  section.reinforcement.value = 4.5e-3;
  EXPECT_EQ(verdictOf(section, {}, WeldKind::Butt), "B");
  EXPECT_EQ(verdictOf(section, {}, WeldKind::Fillet), "D") << "caps of 3, 4, 5 mm";
}

TEST(SectionVerdict, TakesTheHeightAboveTheLowerPlateWhereTheyAreMisaligned)
{
  WeldSection section = goodSection();
  section.reinforcement.value = 2.1e-3;
  section.height_left.value = 2.5e-3;
  section.height_right.value = 1.7e-3;
  EXPECT_EQ(verdictOf(section), "B");
  section.misalignment.value = 0.8e-3;
  EXPECT_EQ(verdictOf(section), "C");
}

TEST(SectionVerdict, WithoutLimitsForTheThicknessIsEmpty)
{
  EXPECT_EQ(verdictOf(goodSection(), plate(0.4)), "") << "the standard begins at 0.5 mm";
  EXPECT_EQ(verdictOf(goodSection(), plate(0.5)), "B");
}

TEST(SectionVerdict, OfAThinPlatePermitsNoUndercutAtLevelB)
{
  WeldSection section = goodSection();
  section.undercut_left.value = 0.02e-3;
  EXPECT_EQ(verdictOf(section, plate(2.0)), "B") << "smaller than what counts as an imperfection, 0.05 mm";
  section.undercut_left.value = 0.06e-3;
  EXPECT_EQ(verdictOf(section, plate(2.0)), "undecided");
  section.undercut_left.value = 0.1e-3;
  EXPECT_EQ(verdictOf(section, plate(2.0)), "C") << "0.2 and 0.4 mm, if short: sections do not ask";
  section.undercut_left.value = 0.3e-3;
  EXPECT_EQ(verdictOf(section, plate(2.0)), "D");
  section.undercut_left.value = 0.5e-3;
  EXPECT_EQ(verdictOf(section, plate(2.0)), "fail");
}

TEST(SectionVerdict, SaysWhenItRestsOnALimitThatWasNotRead)
{
  const auto judged = [](const WeldSection& section, const VerdictParams& params, WeldKind kind = WeldKind::Butt)
  { return WeldJudge(params).judge(kind, section); };
  EXPECT_FALSE(judged(goodSection(), {}).unverified) << "502 was read";
  EXPECT_TRUE(judged(goodSection(), plate(4.0)).unverified) << "507 was not";
  EXPECT_FALSE(judged(goodSection(), plate(4.0), WeldKind::Fillet).unverified) << "503 and 5011 were";
  EXPECT_TRUE(judged(goodSection(), {}, WeldKind::BeadOnPlate).unverified) << "by analogy";
  WeldSection section = goodSection();
  section.reinforcement.value = 4.5e-3;
  EXPECT_FALSE(judged(section, plate(4.0)).unverified) << "502 alone fails it";
  section = goodSection();
  section.misalignment.value = 2e-3;
  EXPECT_EQ(judged(section, plate(4.0)).verdict, "fail");
  EXPECT_TRUE(judged(section, plate(4.0)).unverified) << "only 507 fails it";
  EXPECT_FALSE(judged(WeldSection{}, plate(4.0)).unverified) << "there is no verdict";
}

TEST(SectionVerdict, ShowsEachImperfectionWithItsMargin)
{
  WeldSection section = goodSection();
  section.undercut_right.value = 0.3e-3;
  const SectionVerdict verdict = WeldJudge(plate(4.0)).judge(WeldKind::Butt, section);
  ASSERT_EQ(verdict.judgements.size(), 7u) << "502, two undercuts, two toe angles, 507, 511";
  const Judgement& undercut = verdict.judgements[2];
  EXPECT_EQ(undercut.imperfection, Imperfection::Undercut);
  EXPECT_EQ(undercut.side, "right");
  EXPECT_TRUE(undercut.decides);
  EXPECT_NEAR(undercut.at(QualityLevel::B).margin.value, -0.1e-3, 1e-12);
  EXPECT_NEAR(undercut.at(QualityLevel::C).margin.value, 0.1e-3, 1e-12);
  EXPECT_EQ(undercut.at(QualityLevel::B).decision, Decision::Fail);
  EXPECT_EQ(undercut.at(QualityLevel::C).decision, Decision::Pass);
  EXPECT_FALSE(verdict.judgements[3].decides) << "the toe angle was not asked for";
  EXPECT_NEAR(verdict.judgements[3].at(QualityLevel::B).margin.value, 10.0 * kDegree, 1e-12);
}
