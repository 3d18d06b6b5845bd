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
  EXPECT_TRUE(noted(unknown, "no plate thickness given, not judged: undercut, misalignment"));
  const VerdictRow& row = rowOf(unknown, Imperfection::Undercut, QualityLevel::B);
  EXPECT_EQ(row.decision, Decision::NotJudged);
  EXPECT_NEAR(row.value.value, 3e-3, 1e-12) << "measured all the same";
  EXPECT_FALSE(row.limit.measured());
  const WeldVerdict thin = judged(sections, plate(0.4));
  EXPECT_EQ(thin.verdict, "");
  EXPECT_TRUE(noted(thin, "thickness 0.4 mm is below the scope of ISO 5817 (0.5 mm)"));
  EXPECT_EQ(rowOf(thin, Imperfection::ExcessWeldMetal, QualityLevel::B).decision, Decision::NotJudged);
}

TEST(VerdictInput, NamesTheLimitsThatNeedAThicknessAndMeetsNoLevelWithoutThem)
{
  using Names = std::vector<std::string>;
  const std::vector<WeldSpot> spots;
  VerdictParams params;
  params.level = "C";
  const auto of = [&](WeldKind kind) { return judged(goodWeld(0.05), params, kind, &spots); };
  const WeldVerdict butt = of(WeldKind::Butt);
  EXPECT_EQ(butt.lacks_thickness, (Names{ "undercut", "misalignment", "incomplete_fill", "surface_pore" }));
  EXPECT_EQ(butt.lacking(),
            "no plate thickness given, not judged: undercut, misalignment, incomplete_fill, surface_pore");
  EXPECT_TRUE(noted(butt, butt.lacking()));
  EXPECT_EQ(butt.headline(), "not fully judged, B by what was judged");
  EXPECT_EQ(butt.text(), butt.headline() + " (" + butt.lacking() + ")");
  EXPECT_EQ(butt.asked, Decision::NotJudged) << "what was not judged may fail it";
  EXPECT_EQ(of(WeldKind::Fillet).lacks_thickness, Names{ "undercut" });
  EXPECT_EQ(of(WeldKind::BeadOnPlate).text(),
            "not fully judged, B by what was judged (no plate thickness given, not judged: undercut) (limits not "
            "verified)");
  std::vector<WeldSection> high = goodWeld(0.05);
  for (WeldSection& section : high)
    section.reinforcement.value = 3e-3;
  const WeldVerdict failed = judged(high, params);
  EXPECT_EQ(failed.headline(), "not fully judged, D by what was judged");
  EXPECT_EQ(failed.asked, Decision::Fail) << "one failure suffices";
  params.thickness = 4e-3;
  EXPECT_EQ(of(WeldKind::Butt).lacks_thickness, Names{});
  EXPECT_EQ(of(WeldKind::Butt).headline(), "B");
  EXPECT_EQ(of(WeldKind::Butt).asked, Decision::Pass);
}

TEST(VerdictInput, LacksNoThicknessWhereNoEntryOfTheTableNeedsOne)
{
  using Names = std::vector<std::string>;
  const auto lacking = [](const std::string& entries, const VerdictParams& params = {})
  {
    const std::vector<WeldSection> sections = goodWeld(0.05);
    const std::vector<WeldSpot> spots;
    const std::string head =
        "version: 1\nstandard: mine\nleast_thickness_mm: 0.5\n"
        "short: {length_mm: 25, per_mm: 100, share: 0.25, edition: mine, source: read}\n"
        "entries:\n  - {iso: 502, kinds: [butt], edition: mine, source: read, "
        "B: {base_mm: 2}, C: {base_mm: 3}, D: {base_mm: 4}}\n";
    const WeldJudge judge(params, Limits::parse(head + entries, "mine.yaml"));
    return judge.judge(WeldToJudge{ WeldKind::Butt, &sections, &spots, nullptr }).lacks_thickness;
  };
  const auto entry = [](const std::string& what)
  { return "  - {edition: mine, source: read, kinds: [butt], " + what + "}\n"; };
  const std::string levels = "B: {base_mm: 0.1}, C: {base_mm: 0.2}, D: ";
  EXPECT_EQ(lacking(""), Names{});
  EXPECT_EQ(lacking(entry("iso: 5011, " + levels + "{base_mm: 0.3}")), Names{});
  EXPECT_EQ(lacking(entry("iso: 5011, " + levels + "{base_mm: 0.3, factor: 0.3, of: t}")), Names{ "undercut" });
  EXPECT_EQ(lacking(entry("iso: 5011, above_mm: 3, " + levels + "{base_mm: 0.3}")), Names{ "undercut" });
  EXPECT_EQ(lacking(entry("iso: 507, to_mm: 3, B: permitted, C: permitted, D: permitted")), Names{});
  EXPECT_EQ(lacking("  - {edition: mine, source: read, kinds: [fillet], iso: 5011, above_mm: 3, " + levels +
                    "{base_mm: 0.3}}\n"),
            Names{})
      << "of another kind";
  const std::string angle = entry("iso: 505, above_mm: 3, B: {base_deg: 150}, C: {base_deg: 110}, D: {base_deg: 90}");
  EXPECT_EQ(lacking(angle), Names{}) << "not asked for";
  VerdictParams params;
  params.judge_toe_angle = true;
  EXPECT_EQ(lacking(angle, params), Names{ "toe_angle" });
  const std::string pore = entry("iso: 2017, " + levels + "{base_mm: 0.3, factor: 0.3, of: s}");
  EXPECT_EQ(lacking(pore), Names{ "surface_pore" });
  params.nominal_thickness = 4e-3;
  EXPECT_EQ(lacking(pore, params), Names{});
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
