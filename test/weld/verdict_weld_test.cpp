#include <cmath>
#include <random>

#include "weld/judged.h"
#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

TEST(WeldVerdict, OfAFlawlessWeldIsB)
{
  const WeldVerdict verdict = judged(goodWeld(0.05), plate(4.0));
  EXPECT_EQ(verdict.verdict, "B");
  EXPECT_NEAR(verdict.length, 0.05, 1e-12);
  ASSERT_EQ(verdict.rows.size(), 15u) << "502, undercut, toe angle, 507, 511 at B, C, D";
  for (const VerdictRow& row : verdict.rows)
  {
    const bool toe = row.imperfection == Imperfection::ToeAngle;
    EXPECT_EQ(row.decision, toe ? Decision::NotJudged : Decision::Pass) << name(row.imperfection);
    EXPECT_NEAR(row.measured, 0.05, 1e-12);
    EXPECT_NEAR(row.length, 0.0, 1e-12);
  }
  const VerdictRow& height = rowOf(verdict, Imperfection::ExcessWeldMetal, QualityLevel::D);
  EXPECT_NEAR(height.value.value, 1e-3, 1e-12);
  EXPECT_NEAR(height.limit.value, 4e-3, 1e-12);
  EXPECT_NEAR(height.margin.value, 3e-3, 1e-12);
  EXPECT_NEAR(height.margin.sigma, 1e-5 * std::sqrt(1.0 + 0.25 * 0.25), 1e-12);
}

TEST(WeldVerdict, IsThatOfItsWorstMillimetre)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  cut(sections, 20.0, 23.0, 0.5, &WeldSection::undercut_right);
  const WeldVerdict verdict = judged(sections, plate(4.0));
  EXPECT_EQ(verdict.verdict, "D") << "0.2, 0.4, 0.8 mm";
  const VerdictRow& row = rowOf(verdict, Imperfection::Undercut, QualityLevel::C);
  EXPECT_EQ(row.decision, Decision::Fail);
  EXPECT_EQ(row.side, "right");
  EXPECT_GT(row.s, 20e-3);
  EXPECT_LT(row.s, 23e-3);
  EXPECT_NEAR(row.margin.value, -0.1e-3, 1e-9);
  EXPECT_NEAR(row.length, 3e-3, 1e-9);
}

TEST(WeldVerdict, DoesNotFailByOneSectionAmongHundreds)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  sections[100].undercut_left.value = 0.9e-3;
  const WeldVerdict verdict = judged(sections, plate(4.0));
  EXPECT_EQ(verdict.verdict, "undecided") << "but it does not pass either";
  const VerdictRow& row = rowOf(verdict, Imperfection::Undercut, QualityLevel::D);
  EXPECT_EQ(row.decision, Decision::Undecided);
  EXPECT_NEAR(row.value.value, 0.9e-3, 1e-12);
  EXPECT_NEAR(row.s, sections[100].s, 1e-12);
  cut(sections, 25.0, 26.0, 0.9);
  EXPECT_EQ(judged(sections, plate(4.0)).verdict, "fail") << "a millimetre is enough";
}

TEST(WeldVerdict, WithoutMediansNeedsMoreSigmasTheMoreSectionsThereAre)
{
  // 200 independent sections: the largest of them lies beyond 3.7 sigma by chance in 2.3 % of welds
  VerdictParams params = plate(4.0);
  params.min_length = 0.0;
  std::vector<WeldSection> sections = goodWeld(0.05);
  sections[100].undercut_left.value = 0.8e-3 + 3.5e-5;
  EXPECT_EQ(rowOf(judged(sections, params), Imperfection::Undercut, QualityLevel::D).decision, Decision::Undecided);
  sections[100].undercut_left.value = 0.8e-3 + 4.0e-5;
  EXPECT_EQ(rowOf(judged(sections, params), Imperfection::Undercut, QualityLevel::D).decision, Decision::Fail);
}

TEST(WeldVerdict, OfALoneSectionHasNoLength)
{
  std::vector<WeldSection> one = { goodSection(0.01) };
  EXPECT_EQ(judged(one, plate(2.0)).verdict, "B");
  one[0].undercut_left.value = 0.12e-3;
  EXPECT_EQ(shortRow(judged(one, plate(2.0))).decision, Decision::Undecided) << "short or not is not known";
}

TEST(WeldVerdict, DoesNotPassWhatIsMostlyNotMeasured)
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
  EXPECT_EQ(judged(sections, plate(4.0)).verdict, "");
  EXPECT_EQ(rowOf(judged(sections, plate(4.0)), Imperfection::Undercut, QualityLevel::B).decision,
            Decision::NotMeasured);
  EXPECT_TRUE(noted(judged(sections, plate(4.0)), "undercut was not measured"));
}

TEST(WeldVerdict, BeginsAndEndsWithTheBead)
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

TEST(WeldVerdict, OfNothingIsEmpty)
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

TEST(WeldVerdict, SaysWhatIsNotJudgedForWantOfAThickness)
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

TEST(WeldVerdict, WondersAtAThicknessThatNobodyWelds)
{
  EXPECT_TRUE(noted(judged(goodWeld(0.05), plate(900.0)), "thickness 900 mm is more than is welded: is it given in"));
  EXPECT_FALSE(noted(judged(goodWeld(0.05), plate(200.0)), "more than is welded"));
}

TEST(WeldVerdict, SaysOnHowLittleOfAWeldItIs)
{
  EXPECT_TRUE(noted(judged(goodWeld(0.002), plate(4.0)), "mm of weld were seen"));
  EXPECT_FALSE(noted(judged(goodWeld(0.02), plate(4.0)), "of weld were seen"));
}

TEST(WeldVerdict, AnswersForTheLevelAskedFor)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  for (WeldSection& section : sections)
    section.reinforcement.value = 2.5e-3;
  VerdictParams params = plate(4.0);
  EXPECT_EQ(judged(sections, params).asked, Decision::NotJudged);
  const std::vector<std::pair<const char*, Decision>> answers = { { "B", Decision::Fail },
                                                                  { "C", Decision::Pass },
                                                                  { "D", Decision::Pass } };
  for (const auto& answer : answers)
  {
    params.level = answer.first;
    EXPECT_EQ(judged(sections, params).asked, answer.second) << answer.first;
  }
}

TEST(WeldVerdict, JudgesTheToeAngleWhenAsked)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  for (WeldSection& section : sections)
    section.toe_angle_right.value = 100.0 * kDegree;
  VerdictParams params = plate(4.0);
  EXPECT_EQ(judged(sections, params).verdict, "B");
  params.judge_toe_angle = true;
  const WeldVerdict verdict = judged(sections, params);
  EXPECT_EQ(verdict.verdict, "D");
  const VerdictRow& row = rowOf(verdict, Imperfection::ToeAngle, QualityLevel::C);
  EXPECT_EQ(row.side, "right");
  EXPECT_NEAR(row.margin.value, -10.0 * kDegree, 1e-9);
}

TEST(WeldVerdict, JudgesPoresOneByOne)
{
  const std::vector<WeldSection> sections = goodWeld(0.05);
  std::vector<WeldSpot> spots;
  EXPECT_EQ(judged(sections, plate(5.0), WeldKind::Butt, &spots).verdict, "B") << "looked for, none there";
  WeldSpot spot;
  spot.diameter = { 1.2e-3, 1e-5 };
  spot.s = 0.02;
  spots.push_back(spot);
  EXPECT_EQ(judged(sections, plate(5.0), WeldKind::Butt, &spots).verdict, "B") << "spatter has no limit";
  spots[0].kind = WeldSpot::Kind::Pore;
  const WeldVerdict verdict = judged(sections, plate(5.0), WeldKind::Butt, &spots);
  EXPECT_EQ(verdict.verdict, "D") << "none, 0.2 s, 0.3 s";
  const VerdictRow& row = rowOf(verdict, Imperfection::SurfacePore, QualityLevel::C);
  EXPECT_EQ(row.decision, Decision::Fail);
  EXPECT_NEAR(row.s, 0.02, 1e-12);
  EXPECT_NEAR(row.limit.value, 1e-3, 1e-12);
  VerdictParams params = plate(5.0);
  params.nominal_thickness = 3.5e-3;
  EXPECT_EQ(judged(sections, params, WeldKind::Butt, &spots).verdict, "fail") << "0.3 s = 1.05 mm";
}

TEST(WeldVerdict, JudgesAnUnfilledGrooveThoughSectionsDoNot)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  for (WeldSection& section : sections)
    section.incomplete_fill.value = 1.2e-3;
  EXPECT_EQ(WeldJudge(plate(4.0)).judge(WeldKind::Butt, sections[0]).verdict, "B");
  EXPECT_EQ(judged(sections, plate(4.0)).verdict, "fail") << "0.25 t";
  for (WeldSection& section : sections)
    section.incomplete_fill = {};
  EXPECT_EQ(judged(sections, plate(4.0)).verdict, "B") << "a verdict does not wait for it";
}

TEST(WeldVerdict, RefusesSectionsOutOfOrder)
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

TEST(WeldVerdict, IsGivenForAnyNumbers)
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
