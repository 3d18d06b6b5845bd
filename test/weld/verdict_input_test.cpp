#include <cmath>
#include <limits>
#include <random>

#include "weld/judged.h"
#include "weld_profiler/core/errors.h"

// What a verdict is worth when little of a weld was measured, or what was is odd.

using namespace weld_profiler;

TEST(VerdictInput, OfALoneSectionHasNoLengthAndPassesNothing)
{
  std::vector<WeldSection> one = { goodSection(0.01) };
  const WeldVerdict verdict = judged(one, plate(2.0));
  EXPECT_EQ(verdict.verdict, "undecided");
  EXPECT_EQ(verdict.levels[0], Decision::Undecided);
  EXPECT_TRUE(noted(verdict, "one section alone was measured, which has no length"));
  one[0].undercut_left.value = 0.12e-3;
  EXPECT_EQ(shortRow(judged(one, plate(2.0))).decision, Decision::Undecided) << "short or not is not known";
  one[0].undercut_left.value = 3e-3;
  EXPECT_EQ(judged(one, plate(2.0)).verdict, "fail") << "what is beyond a limit is so in one section too";
}

TEST(VerdictInput, DoesNotPassWhatIsMostlyNotMeasured)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  for (std::size_t i = 0; i < 19; ++i)
    sections[60 + i].undercut_left = {};
  EXPECT_EQ(judged(sections, plate(4.0)).verdict, "B") << "9.5 % missing";
  for (std::size_t i = 0; i < 3; ++i)
    sections[90 + i].undercut_left = {};
  const WeldVerdict verdict = judged(sections, plate(4.0));
  EXPECT_EQ(verdict.verdict, "undecided");
  EXPECT_TRUE(noted(verdict, "least share of the weld, so that it cannot pass: undercut"));
  cut(sections, 20.0, 23.0, 1.0, &WeldSection::undercut_right);
  EXPECT_EQ(judged(sections, plate(4.0)).verdict, "fail") << "a fault that was seen counts";
  for (WeldSection& section : sections)
    section.undercut_left = section.undercut_right = {};
  EXPECT_EQ(judged(sections, plate(4.0)).verdict, "undecided");
  EXPECT_EQ(judged(sections, plate(4.0)).waits_for, std::vector<std::string>{ "undercut" });
  EXPECT_EQ(rowOf(judged(sections, plate(4.0)), Imperfection::Undercut, QualityLevel::B).decision,
            Decision::NotMeasured);
  EXPECT_TRUE(noted(judged(sections, plate(4.0)), "undercut was not measured"));
}

TEST(VerdictInput, BeginsAndEndsWithTheBead)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  for (std::size_t i = 0; i < 40; ++i)
  {
    WeldSection empty;
    empty.s = sections[i].s;
    sections[i] = empty;
  }
  const WeldVerdict verdict = judged(sections, plate(4.0));
  EXPECT_NEAR(verdict.length, 0.04, 1e-9);
  EXPECT_EQ(verdict.verdict, "B");
}

TEST(VerdictInput, OfNothingIsEmpty)
{
  for (const WeldVerdict& verdict :
       { judged({}, plate(4.0)), judged(std::vector<WeldSection>(5), plate(4.0)),
         judged(goodWeld(0.05), plate(4.0), WeldKind::None), WeldJudge(VerdictParams{}).judge(WeldToJudge{}) })
  {
    EXPECT_EQ(verdict.verdict, "");
    EXPECT_TRUE(verdict.rows.empty());
    EXPECT_TRUE(noted(verdict, "nothing to judge"));
  }
}

TEST(VerdictInput, SaysWhatIsNotJudgedForWantOfAThickness)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  cut(sections, 10.0, 40.0, 3.0);
  const WeldVerdict unknown = judged(sections, {});
  EXPECT_EQ(unknown.verdict, "B");
  EXPECT_TRUE(noted(unknown, "no plate thickness given"));
  const VerdictRow& row = rowOf(unknown, Imperfection::Undercut, QualityLevel::B);
  EXPECT_EQ(row.decision, Decision::NotJudged);
  EXPECT_NEAR(row.value.value, 3e-3, 1e-12) << "measured all the same";
  EXPECT_FALSE(row.limit.measured());
  const WeldVerdict thin = judged(sections, plate(0.4));
  EXPECT_EQ(thin.verdict, "");
  EXPECT_TRUE(noted(thin, "thickness 0.4 mm is below the scope of ISO 5817 (0.5 mm)"));
  EXPECT_EQ(rowOf(thin, Imperfection::ExcessWeldMetal, QualityLevel::B).decision, Decision::NotJudged);
}

TEST(VerdictInput, WondersAtAThicknessThatNobodyWelds)
{
  EXPECT_TRUE(noted(judged(goodWeld(0.05), plate(900.0)), "thickness 900 mm is more than is welded: is it given in"));
  EXPECT_FALSE(noted(judged(goodWeld(0.05), plate(200.0)), "more than is welded"));
}

TEST(VerdictInput, SaysOnHowLittleOfAWeldItIs)
{
  EXPECT_TRUE(noted(judged(goodWeld(0.002), plate(4.0)), "mm of weld were seen"));
  EXPECT_FALSE(noted(judged(goodWeld(0.02), plate(4.0)), "of weld were seen"));
}

TEST(VerdictInput, RefusesSectionsOutOfOrder)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  std::swap(sections[3], sections[4]);
  EXPECT_THROW(judged(sections, plate(4.0)), PreconditionError);
  sections = goodWeld(0.05);
  sections[4].s = sections[3].s;
  EXPECT_THROW(judged(sections, plate(4.0)), PreconditionError);
  sections[4].s = std::nan("");
  EXPECT_THROW(judged(sections, plate(4.0)), PreconditionError);
}

TEST(VerdictInput, IsGivenForAnyNumbers)
{
  const double kInfinity = std::numeric_limits<double>::infinity();
  std::mt19937 random(9);
  const std::vector<double> odd = { std::nan(""), kInfinity, -kInfinity, 0.0, -1e-3, 1e-3, 1e300 };
  const auto any = [&]() { return odd[random() % odd.size()]; };
  for (int i = 0; i < 300; ++i)
  {
    std::vector<WeldSection> sections = goodWeld(0.005);
    for (WeldSection& section : sections)
      for (Quantity WeldSection::*field :
           { &WeldSection::width, &WeldSection::reinforcement, &WeldSection::undercut_left,
             &WeldSection::undercut_right, &WeldSection::misalignment, &WeldSection::toe_angle_left })
      {
        if (random() % 4 == 0)
          section.*field = { any(), std::abs(any()) };
      }
    const WeldKind kind = static_cast<WeldKind>(random() % 4);
    const WeldVerdict verdict = judged(sections, plate(i % 2 == 0 ? 2.0 : 4.0), kind);
    for (const VerdictRow& row : verdict.rows)
      EXPECT_EQ(row.decision == Decision::NotMeasured, !row.value.measured()) << name(row.imperfection);
  }
}
