#include "weld/judged.h"
#include "weld/verdict_length.h"

using namespace weld_profiler;

TEST(ShortImperfections, OfAShortWeldAreAQuarterOfIt)
{
  for (const auto& c : { std::make_pair(14.0, Decision::Pass), std::make_pair(16.0, Decision::Fail) })
  {
    std::vector<WeldSection> sections = goodWeld(0.06);
    cut(sections, 5.0, 5.0 + c.first);
    const WeldVerdict verdict = judged(sections, plate(2.0));
    EXPECT_EQ(shortRow(verdict).decision, c.second) << c.first << " mm of 60 mm";
    EXPECT_NEAR(shortRow(verdict).length, c.first * kMillimetre, 1e-9);
    EXPECT_EQ(rowOf(verdict, Imperfection::Undercut, QualityLevel::B).decision, Decision::Fail) << "not permitted";
  }
}

TEST(ShortImperfections, MayBeShortOfAWeldThatGoesOnBeyondTheScan)
{
  const std::vector<WeldSpot> spots;
  for (const auto& c : { std::make_pair(14.0, Decision::Pass), std::make_pair(16.0, Decision::Undecided),
                         std::make_pair(26.0, Decision::Fail) })
  {
    std::vector<WeldSection> sections = goodWeld(0.06);
    cut(sections, 5.0, 5.0 + c.first);
    WeldToJudge weld{ WeldKind::Butt, &sections, &spots };
    weld.runs_out = true;
    const WeldVerdict verdict = WeldJudge(plate(2.0)).judge(weld);
    EXPECT_EQ(shortRow(verdict).decision, c.second) << c.first << " mm of 60 mm seen";
    EXPECT_EQ(verdict.notes.back().find("the weld runs out of the scan") == 0, c.second == Decision::Undecided);
  }
}

TEST(ShortImperfections, OfALongWeldAreCountedInAnyHundredMillimetres)
{
  // two cuts of 15 mm, their outer ends 110 mm apart: at most 20 mm lie within any 100 mm
  std::vector<WeldSection> sections = goodWeld(0.3);
  cut(sections, 95.0, 110.0);
  cut(sections, 190.0, 205.0);
  EXPECT_EQ(shortRow(judged(sections, plate(2.0))).decision, Decision::Pass);
  EXPECT_NEAR(shortRow(judged(sections, plate(2.0))).length, 20e-3, 1e-9);
  // 10 mm closer, both lie within 100 mm, which no fixed grid of 100 mm sees
  sections = goodWeld(0.3);
  cut(sections, 95.0, 110.0);
  cut(sections, 180.0, 195.0);
  EXPECT_EQ(shortRow(judged(sections, plate(2.0))).decision, Decision::Fail);
  EXPECT_NEAR(shortRow(judged(sections, plate(2.0))).length, 30e-3, 1e-9);
}

TEST(ShortImperfections, MayAddUpToMoreAlongAWholeLongWeld)
{
  std::vector<WeldSection> sections = goodWeld(0.3);
  for (const double from : { 10.0, 120.0, 230.0 })
    cut(sections, from, from + 24.0);
  EXPECT_EQ(shortRow(judged(sections, plate(2.0))).decision, Decision::Pass) << "72 mm, but 24 in any 100";
  cut(sections, 34.0, 36.0);
  EXPECT_EQ(shortRow(judged(sections, plate(2.0))).decision, Decision::Fail) << "26 mm";
}

TEST(ShortImperfections, OfBothSidesAddUp)
{
  std::vector<WeldSection> sections = goodWeld(0.3);
  cut(sections, 50.0, 65.0);
  cut(sections, 50.0, 65.0, 0.12, &WeldSection::undercut_right);
  EXPECT_EQ(shortRow(judged(sections, plate(2.0))).decision, Decision::Fail);
}

TEST(ShortImperfections, MustNotBeTooDeepEither)
{
  std::vector<WeldSection> sections = goodWeld(0.3);
  cut(sections, 50.0, 55.0, 0.3);
  const WeldVerdict verdict = judged(sections, plate(2.0));
  EXPECT_EQ(shortRow(verdict).decision, Decision::Fail) << "0.2 mm";
  EXPECT_EQ(rowOf(verdict, Imperfection::Undercut, QualityLevel::D).decision, Decision::Pass) << "0.4 mm";
}

TEST(ShortImperfections, AreUndecidedWhereTheirLengthIs)
{
  // 20 mm for certain, and 10 mm that may or may not count: within 2 sigma of 0.05 mm
  std::vector<WeldSection> sections = goodWeld(0.3);
  cut(sections, 50.0, 70.0);
  EXPECT_EQ(shortRow(judged(sections, plate(2.0))).decision, Decision::Pass);
  cut(sections, 80.0, 90.0, 0.05);
  EXPECT_EQ(shortRow(judged(sections, plate(2.0))).decision, Decision::Undecided);
}

TEST(ShortImperfections, MayHideInWhatWasNotMeasured)
{
  std::vector<WeldSection> sections = goodWeld(0.3);
  cut(sections, 50.0, 70.0);
  for (WeldSection& section : sections)
  {
    if (section.s > 0.1 && section.s < 0.11)
      section.undercut_left = {};
  }
  EXPECT_EQ(shortRow(judged(sections, plate(2.0))).decision, Decision::Undecided) << "20 mm and 10 mm of hole";
  EXPECT_NEAR(shortRow(judged(sections, plate(2.0))).measured, 0.29, 1e-9);
  std::vector<WeldSection> holes;
  for (const WeldSection& section : sections)
  {
    if (section.undercut_left.measured())
      holes.push_back(section);
  }
  ASSERT_EQ(holes.size(), 1160u);
  EXPECT_EQ(shortRow(judged(holes, plate(2.0))).decision, Decision::Undecided) << "left out is not measured";
  EXPECT_NEAR(judged(holes, plate(2.0)).length, 0.3, 1e-9);
  EXPECT_NEAR(shortRow(judged(holes, plate(2.0))).measured, 0.29, 1e-9);
}

TEST(ShortImperfections, CountTheLengthThatASectionStandsFor)
{
  // the same 14 mm of 60 mm, cut at steps of 0.1 and 0.3 mm
  std::vector<WeldSection> sections;
  for (double s = 0.0; s <= 0.06; s += s < 0.03 ? 0.1e-3 : 0.3e-3)
    sections.push_back(goodSection(s));
  cut(sections, 23.0, 37.0);
  const WeldVerdict verdict = judged(sections, plate(2.0));
  EXPECT_NEAR(shortRow(verdict).length, 14e-3, 0.3e-3) << "ends fall between sections";
  EXPECT_EQ(shortRow(verdict).decision, Decision::Pass);
}

TEST(ShortImperfections, RestOnARuleThatWasNotRead)
{
  const WeldVerdict thin = judged(goodWeld(0.06), plate(2.0), WeldKind::Fillet);
  EXPECT_FALSE(shortRow(thin).verified) << "the limit was read, the rule was not";
  EXPECT_TRUE(rowOf(thin, Imperfection::Undercut, QualityLevel::B).verified);
  EXPECT_TRUE(thin.unverified);
  EXPECT_TRUE(noted(thin, "not checked against a copy of ISO 5817: undercut"));
  const WeldVerdict thick = judged(goodWeld(0.06), plate(4.0), WeldKind::Fillet);
  EXPECT_FALSE(thick.unverified);
  EXPECT_FALSE(noted(thick, "not checked"));
}

TEST(WeldLength, OfASectionEndsHalfWayToItsNeighboursOrAtAGap)
{
  const std::vector<Stretch> cells = cellsOf({ 0.0, 1.0, 2.0, 4.0, 5.0, 9.0, 10.0 });
  ASSERT_EQ(cells.size(), 7u);
  EXPECT_DOUBLE_EQ(cells[0].begin, -0.5);
  EXPECT_DOUBLE_EQ(cells[2].end, 3.0) << "two steps are no gap";
  EXPECT_DOUBLE_EQ(cells[4].end, 5.5);
  EXPECT_DOUBLE_EQ(cells[5].begin, 8.5);
  EXPECT_DOUBLE_EQ(cells[6].end, 10.5);
  const std::vector<Stretch> gaps = gapsBetween(cells, 2.0);
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_DOUBLE_EQ(gaps[0].begin, 5.5);
  EXPECT_DOUBLE_EQ(gaps[0].end, 8.5);
}

TEST(WeldLength, WithinAWindowIsThatOfTheWorstWindow)
{
  const std::vector<Stretch> stretches = { { 0.0, 2.0, 1.0 }, { 5.0, 6.0, 2.0 }, { 8.0, 9.0, 1.0 } };
  EXPECT_DOUBLE_EQ(mostWithin(stretches, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(mostWithin(stretches, 4.0), 3.0);
  EXPECT_DOUBLE_EQ(mostWithin(stretches, 5.0), 3.0);
  EXPECT_DOUBLE_EQ(mostWithin(stretches, 6.0), 4.0);
  EXPECT_DOUBLE_EQ(mostWithin(stretches, 100.0), 5.0);
  EXPECT_DOUBLE_EQ(mostWithin({}, 1.0), 0.0);
}
