#include <map>
#include <string>
#include <vector>

#include "weld/judged.h"

// What a verdict says where something that has a limit was not measured.

using namespace weld_profiler;

namespace
{
std::string verdictOf(const WeldSection& section, const VerdictParams& params = {}, WeldKind kind = WeldKind::Butt)
{
  return WeldJudge(params).judge(kind, section).verdict;
}
}  // namespace

TEST(SectionVerdict, IsUndecidedWhereADecidingValueIsNotMeasuredAndSaysWhich)
{
  using Names = std::vector<std::string>;
  const std::vector<std::pair<Quantity WeldSection::*, std::string>> fields = {
    { &WeldSection::undercut_left, "undercut left" },
    { &WeldSection::undercut_right, "undercut right" },
    { &WeldSection::misalignment, "misalignment" }
  };
  for (const auto& [field, name] : fields)
  {
    WeldSection section = goodSection();
    section.*field = {};
    EXPECT_EQ(verdictOf(section), "B") << "without a thickness there is no limit for it";
    SectionVerdict verdict = WeldJudge(plate(4.0)).judge(WeldKind::Butt, section);
    EXPECT_EQ(verdict.verdict, "undecided");
    EXPECT_EQ(verdict.waits_for, Names{ name });
    EXPECT_EQ(verdict.levels,
              (std::array<Decision, 3>{ Decision::Undecided, Decision::Undecided, Decision::Undecided }));
    section.reinforcement.value = 2.5e-3;
    verdict = WeldJudge(plate(4.0)).judge(WeldKind::Butt, section);
    EXPECT_EQ(verdict.verdict, "undecided") << "C or worse, by what was not measured";
    EXPECT_EQ(verdict.levels[0], Decision::Fail) << "one certain failure is enough";
    section.reinforcement.value = 4.5e-3;
    verdict = WeldJudge(plate(4.0)).judge(WeldKind::Butt, section);
    EXPECT_EQ(verdict.verdict, "fail");
    EXPECT_EQ(verdict.waits_for, Names{}) << "a failed section waits for nothing";
  }
  WeldSection section = goodSection();
  section.reinforcement = {};
  EXPECT_EQ(verdictOf(section), "") << "nothing that has a limit was measured";
  EXPECT_EQ(WeldJudge(VerdictParams{}).judge(WeldKind::Butt, section).waits_for, Names{}) << "without a verdict";
  const SectionVerdict verdict = WeldJudge(plate(4.0)).judge(WeldKind::Butt, section);
  EXPECT_EQ(verdict.verdict, "undecided");
  EXPECT_EQ(verdict.waits_for, Names{ "excess_weld_metal" });
  section = goodSection();
  section.undercut_left.value = 0.9e-3;
  section.undercut_right = section.reinforcement = {};
  EXPECT_EQ(verdictOf(section, plate(4.0)), "fail") << "what was measured fails for certain";
}

TEST(SectionVerdict, WaitsForNothingThatIsPermittedWhateverItsSize)
{
  const std::string table =
      "version: 1\nstandard: mine\nleast_thickness_mm: 0.5\n"
      "short: {length_mm: 25, per_mm: 100, share: 0.25, edition: mine, source: read}\nentries:\n"
      "  - {iso: 502, kinds: [butt], edition: mine, source: read, B: {base_mm: 2}, C: {base_mm: 3}, "
      "D: {base_mm: 4}}\n"
      "  - {iso: 5011, kinds: [butt], edition: mine, source: read, B: {base_mm: 1}, C: {base_mm: 2}, "
      "D: permitted}\n";
  const WeldJudge judge(plate(4.0), Limits::parse(table, "mine.yaml"));
  WeldSection section = goodSection();
  section.undercut_left = {};
  EXPECT_EQ(judge.judge(WeldKind::Butt, section).verdict, "undecided");
  section.reinforcement.value = 3.5e-3;
  const SectionVerdict verdict = judge.judge(WeldKind::Butt, section);
  EXPECT_EQ(verdict.verdict, "D") << "C has failed, and D permits any undercut";
  EXPECT_TRUE(verdict.waits_for.empty());
  std::vector<WeldSection> sections = goodWeld(0.05);
  for (WeldSection& one : sections)
  {
    one.undercut_left = one.undercut_right = {};
    one.reinforcement.value = 3.5e-3;
  }
  EXPECT_EQ(judge.judge(WeldToJudge{ WeldKind::Butt, &sections, nullptr }).verdict, "D");
}

TEST(SectionVerdict, IsEmptyWhereNoBeadWasMeasured)
{
  WeldSection section = goodSection();
  section.width = {};
  EXPECT_EQ(verdictOf(section), "");
  const SectionVerdict verdict = WeldJudge(plate(4.0)).judge(WeldKind::Butt, section);
  EXPECT_EQ(verdict.verdict, "") << "plates that lie well say nothing of the bead";
  EXPECT_TRUE(verdict.waits_for.empty()) << "what is not judged does not wait";
  section.misalignment.value = 2e-3;
  EXPECT_EQ(verdictOf(section, plate(4.0)), "fail");
  EXPECT_EQ(verdictOf(WeldSection{}), "");
  EXPECT_EQ(verdictOf(goodSection(), {}, WeldKind::None), "");
  EXPECT_TRUE(WeldJudge(plate(4.0)).judge(WeldKind::None, section).waits_for.empty());
}

TEST(WeldVerdict, CountsTheSectionsThatWaitAndForWhat)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  EXPECT_EQ(judged(sections, plate(4.0)).waiting.text(), "");
  for (std::size_t i = 60; i < 69; ++i)
    sections[i].undercut_left = {};
  sections[68].undercut_right = sections[90].undercut_right = {};
  sections[30].width = {};
  sections[62].reinforcement.value = 4.5e-3;  // fails: waits no longer
  sections[63].misalignment = {};
  const WeldVerdict verdict = judged(sections, plate(4.0));
  EXPECT_EQ(verdict.waiting.sections, 9);
  EXPECT_EQ(verdict.waiting.all, 200);
  const std::map<std::string, int> expected = { { "undercut left", 8 },
                                                { "undercut right", 2 },
                                                { "misalignment", 1 } };
  EXPECT_EQ(verdict.waiting.for_what, expected);
  EXPECT_TRUE(noted(verdict,
                    "9 of 200 sections wait for what was not measured there: misalignment 1, undercut left 8, "
                    "undercut right 2"));
  EXPECT_EQ(judged(sections, {}).waiting.text(), "") << "without a thickness nothing that is missing has a limit";
  int undecided = 0;
  for (const WeldSection& section : sections)
    undecided += verdictOf(section, plate(4.0)) == "undecided" ? 1 : 0;
  EXPECT_EQ(undecided, verdict.waiting.sections) << "as weld.csv has them";
}
