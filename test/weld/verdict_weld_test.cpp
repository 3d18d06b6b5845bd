#include <cmath>

#include "weld/judged.h"

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

TEST(WeldVerdict, AHollowThatMayBeAPoreFailsNothingAndPassesWhatOneTwiceAsWideWould)
{
  const std::vector<WeldSection> sections = goodWeld(0.05);
  const std::vector<WeldSpot> spots;
  WeldSpot hollow;
  hollow.kind = WeldSpot::Kind::Pore;
  hollow.diameter = { 0.6e-3, 0.3e-3 };
  hollow.s = 0.02;
  const std::vector<WeldSpot> hollows{ hollow };
  const WeldVerdict verdict = WeldJudge(plate(5.0)).judge(WeldToJudge{ WeldKind::Butt, &sections, &spots, &hollows });
  const std::array<Decision, 3> decisions{ Decision::Undecided, Decision::Undecided, Decision::Pass };
  for (const QualityLevel level : kQualityLevels)
  {
    const VerdictRow& row = rowOf(verdict, Imperfection::SurfacePore, level);
    EXPECT_EQ(row.decision, decisions[static_cast<std::size_t>(level)]) << "none, 0.2 s = 1 mm, 0.3 s = 1.5 mm";
    EXPECT_NEAR(row.s, 0.02, 1e-12);
  }
  EXPECT_EQ(verdict.verdict, "undecided");
  EXPECT_TRUE(std::any_of(verdict.notes.begin(), verdict.notes.end(),
                          [](const std::string& note)
                          { return note.find("hollow of 0.60 mm at s = 20.00 mm") != std::string::npos; }));
}

TEST(WeldVerdict, PassesNoLevelWhoseLimitAnUnseenPoreMayBeBeyond)
{
  const std::vector<WeldSection> sections = goodWeld(0.05);
  std::vector<WeldSpot> spots;
  const WeldJudge judge(plate(5.0));
  const auto decisions = [&](double round, double shallow)
  {
    const WeldVerdict verdict =
        judge.judge(WeldToJudge{ WeldKind::Butt, &sections, &spots, nullptr, UnseenPores{ round, shallow } });
    std::array<Decision, 3> all{};
    for (const QualityLevel level : kQualityLevels)
      all[static_cast<std::size_t>(level)] = rowOf(verdict, Imperfection::SurfacePore, level).decision;
    const bool said =
        std::any_of(verdict.notes.begin(), verdict.notes.end(),
                    [](const std::string& note) { return note.find("a pore of up to 1.20 mm") != std::string::npos; });
    EXPECT_EQ(said, round > 5e-4);
    return all;
  };
  using All = std::array<Decision, 3>;
  EXPECT_EQ(decisions(4e-4, 7e-4), (All{ Decision::Pass, Decision::Pass, Decision::Pass }));
  EXPECT_EQ(decisions(6e-4, 1.2e-3), (All{ Decision::Undecided, Decision::Undecided, Decision::Pass }));
  WeldSpot pore;
  pore.kind = WeldSpot::Kind::Pore;
  pore.diameter = { 0.6e-3, 0.05e-3 };
  spots.push_back(pore);
  EXPECT_EQ(decisions(6e-4, 1.2e-3), (All{ Decision::Fail, Decision::Undecided, Decision::Pass }));
}

TEST(WeldVerdict, NoPoreWhereAQuarterWasNotSeenIsNoPass)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  const std::vector<WeldSpot> spots;
  for (std::size_t i = 0; i < sections.size(); i += 4)
    sections[i].width = Quantity{};
  const WeldVerdict verdict = judged(sections, plate(5.0), WeldKind::Butt, &spots);
  const VerdictRow& row = rowOf(verdict, Imperfection::SurfacePore, QualityLevel::C);
  EXPECT_EQ(row.decision, Decision::Undecided);
  EXPECT_NEAR(row.measured, 0.75 * 0.05, 1e-3);
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

TEST(WeldVerdict, PassesNothingOfAWeldOfWhichOneSectionInManyWasMeasured)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  const auto hide = [&sections](double from, double to)
  {
    for (WeldSection& section : sections)
    {
      const double s = section.s;
      if (s < from || s > to)
        continue;
      section = WeldSection();
      section.s = s;
    }
  };
  hide(0.0, 0.012);
  EXPECT_EQ(judged(sections, plate(4.0)).verdict, "B") << "a crater of a quarter";
  hide(0.0, 0.030);
  const WeldVerdict verdict = judged(sections, plate(4.0));
  EXPECT_EQ(verdict.verdict, "undecided");
  EXPECT_EQ(rowOf(verdict, Imperfection::ExcessWeldMetal, QualityLevel::D).decision, Decision::Undecided);
  ASSERT_FALSE(verdict.notes.empty());
  EXPECT_NE(verdict.notes.front().find("less than the least share of the weld"), std::string::npos);
}
