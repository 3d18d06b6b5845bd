#include "weld_profiler/weld/verdict_csv.h"

#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "weld/records.h"

using namespace weld_profiler;

namespace
{
using Line = std::map<std::string, std::string>;

std::string written(const WeldVerdict& verdict)
{
  std::ostringstream out;
  writeVerdictCsv(verdict, out);
  return out.str();
}

/// The lines by imperfection and level.
std::map<std::string, Line> linesOf(const std::vector<WeldSection>& sections, const VerdictParams& params,
                                    WeldKind kind = WeldKind::Butt)
{
  WeldToJudge weld;
  weld.kind = kind;
  weld.sections = &sections;
  std::istringstream text(written(WeldJudge(params).judge(weld)));
  std::string line;
  std::getline(text, line);
  const std::vector<std::string> names = csvFields(line);
  std::map<std::string, Line> lines;
  while (std::getline(text, line))
  {
    const std::vector<std::string> fields = csvFields(line);
    EXPECT_EQ(fields.size(), names.size()) << line;
    Line& named = lines[fields[0] + " " + fields[1]];
    for (std::size_t i = 0; i < std::min(fields.size(), names.size()); ++i)
      named[names[i]] = fields[i];
  }
  return lines;
}
}  // namespace

TEST(VerdictCsv, BeginsWithTheColumnsThatOthersRelyOn)
{
  const std::string given = "imperfection,level,value_mm,sigma_mm,limit_mm,margin_mm,length_mm,decision,";
  EXPECT_EQ(written(WeldVerdict{}).substr(0, given.size()), given);
}

TEST(VerdictCsv, HasALineForEachImperfectionAndLevel)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  for (WeldSection& section : sections)
    section.undercut_right.value = 0.3e-3;
  auto lines = linesOf(sections, plate(4.0));
  ASSERT_EQ(lines.size(), 18u) << "502, 5011, 505, 507, 511 and the weld, at three levels";
  Line& undercut = lines["undercut B"];
  EXPECT_EQ(undercut["value_mm"], "0.300000");
  EXPECT_EQ(undercut["sigma_mm"], "0.010000");
  EXPECT_EQ(undercut["limit_mm"], "0.200000");
  EXPECT_EQ(undercut["margin_mm"], "-0.100000");
  EXPECT_EQ(undercut["length_mm"], "50.000000");
  EXPECT_EQ(undercut["decision"], "fail");
  EXPECT_EQ(undercut["source"], "read");
  EXPECT_EQ(undercut["iso_6520"], "5011");
  EXPECT_EQ(undercut["rule"], "max");
  EXPECT_EQ(undercut["side"], "right");
  EXPECT_EQ(undercut["measured_mm"], "50.000000");
  EXPECT_EQ(undercut["value_deg"], "");
  EXPECT_EQ(lines["undercut C"]["decision"], "pass");
  EXPECT_EQ(lines["weld B"]["decision"], "fail");
  EXPECT_EQ(lines["weld B"]["source"], "read");
  EXPECT_EQ(lines["weld C"]["decision"], "pass");
  EXPECT_EQ(lines["weld C"]["length_mm"], "50.000000");
}

TEST(VerdictCsv, MarksWhatRestsOnALimitThatWasNotRead)
{
  auto lines = linesOf(goodWeld(0.05), plate(4.0));
  EXPECT_EQ(lines["misalignment B"]["source"], "unverified");
  EXPECT_EQ(lines["misalignment B"]["edition"], "not established");
  EXPECT_EQ(lines["excess_weld_metal B"]["source"], "read");
  EXPECT_EQ(lines["weld B"]["source"], "unverified");
  EXPECT_EQ(linesOf(goodWeld(0.05), plate(4.0), WeldKind::Fillet)["weld B"]["source"], "read");
  EXPECT_EQ(linesOf(goodWeld(0.05), plate(2.0), WeldKind::Fillet)["undercut C"]["rule"], "short");
  EXPECT_EQ(linesOf(goodWeld(0.05), plate(2.0), WeldKind::Fillet)["undercut B"]["rule"], "not_permitted");
}

TEST(VerdictCsv, KeepsAnEditionInOneField)
{
  auto lines = linesOf(goodWeld(0.05), plate(4.0), WeldKind::BeadOnPlate);
  EXPECT_EQ(lines["undercut B"]["edition"], "2003 with corrigendum 1:2006; by analogy");
}

TEST(VerdictCsv, GivesTheToeAngleInDegrees)
{
  VerdictParams params = plate(4.0);
  params.judge_toe_angle = true;
  auto lines = linesOf(goodWeld(0.05), params);
  Line& toe = lines["toe_angle B"];
  EXPECT_EQ(toe["value_mm"], "");
  EXPECT_EQ(toe["limit_mm"], "");
  EXPECT_EQ(toe["value_deg"], "160.000000");
  EXPECT_EQ(toe["sigma_deg"], "1.000000");
  EXPECT_EQ(toe["limit_deg"], "150.000000");
  EXPECT_EQ(toe["margin_deg"], "10.000000");
  EXPECT_EQ(toe["sigma_margin_deg"], "1.000000");
  EXPECT_EQ(toe["decision"], "pass");
}

TEST(VerdictCsv, LeavesEmptyWhatWasNotMeasuredOrHasNoLimit)
{
  std::vector<WeldSection> sections = goodWeld(0.05);
  for (WeldSection& section : sections)
    section.misalignment = {};
  auto lines = linesOf(sections, plate(4.0));
  for (const char* column : { "value_mm", "sigma_mm", "limit_mm", "margin_mm", "decision" })
    EXPECT_EQ(lines["misalignment B"][column], "") << column;
  EXPECT_EQ(lines["weld B"]["decision"], "undecided") << "it waits for 507";
  for (WeldSection& section : sections)
    section.width = section.reinforcement = section.undercut_left = section.undercut_right =
        section.incomplete_fill = {};
  sections[0].width = sections[199].width = goodSection().width;
  lines = linesOf(sections, plate(4.0));
  EXPECT_EQ(lines["weld B"]["decision"], "") << "of what decides nothing was measured";
  EXPECT_EQ(lines["weld B"]["source"], "");
  lines = linesOf(goodWeld(0.05), {});
  EXPECT_EQ(lines["undercut B"]["value_mm"], "0.000000");
  EXPECT_EQ(lines["undercut B"]["limit_mm"], "");
  EXPECT_EQ(lines["undercut B"]["source"], "");
  EXPECT_EQ(lines["undercut B"]["decision"], "not_judged");
}
