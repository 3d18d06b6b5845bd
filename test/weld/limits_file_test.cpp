#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/temporary_folder.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/weld/limits.h"

using namespace weld_profiler;

namespace
{
const char* const kHead =
    "version: 1\nstandard: mine\nleast_thickness_mm: 0.5\n"
    "short: {length_mm: 25, per_mm: 100, share: 0.25, edition: mine, source: read}\n";

std::string entry(const std::string& levels, const std::string& more = "")
{
  return "  - {iso: 5011, kinds: [butt], edition: mine, source: read" + more + ", " + levels + "}\n";
}

const char* const kGood = "B: {base_mm: 0.1}, C: {base_mm: 0.2}, D: {base_mm: 0.3, factor: 0.1, of: t, cap_mm: 1}";

std::string table(const std::string& entries)
{
  return kHead + ("entries:\n" + entries);
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string errorOf(const std::string& text)
{
  try
  {
    Limits::parse(text, "my.yaml");
  }
  catch (const ConfigError& error)
  {
    return error.what();
  }
  return "";
}

struct Refusal
{
  std::string text;
  std::string key;     ///< named by the error
  std::string remedy;  ///< part of it
};

void expectRefused(const std::vector<Refusal>& refusals)
{
  for (const Refusal& refusal : refusals)
  {
    const std::string error = errorOf(refusal.text);
    EXPECT_NE(error.find("my.yaml"), std::string::npos) << error << "\n" << refusal.text;
    EXPECT_NE(error.find(refusal.key), std::string::npos) << error << "\n" << refusal.text;
    EXPECT_NE(error.find(refusal.remedy), std::string::npos) << error << "\n" << refusal.text;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}
}  // namespace

TEST(LimitsFile, ThatIsShippedIsTheOneBuiltIn)
{
  std::ifstream file("config/limits/iso5817.yaml");
  std::ostringstream text;
  text << file.rdbuf();
  ASSERT_FALSE(text.str().empty());
  const Limits from_file = Limits::parse(text.str(), "file");
  const Limits built_in = Limits::shipped();
  ASSERT_EQ(from_file.entries().size(), built_in.entries().size());
  for (std::size_t i = 0; i < built_in.entries().size(); ++i)
    for (const QualityLevel level : kQualityLevels)
    {
      EXPECT_EQ(from_file.entries()[i].at(level).base, built_in.entries()[i].at(level).base);
      EXPECT_EQ(from_file.entries()[i].at(level).factor, built_in.entries()[i].at(level).factor);
    }
}

TEST(LimitsFile, OfTheUserIsRead)
{
  const TemporaryFolder folder;
  std::ofstream(folder.file("mine.yaml")) << table(entry(kGood, ", above_mm: 2, to_mm: 10"));
  const Limits limits = Limits::load(folder.file("mine.yaml"));
  ASSERT_EQ(limits.entries().size(), 1u);
  EXPECT_EQ(limits.standard(), "mine");
  EXPECT_EQ(limits.origin(), folder.file("mine.yaml"));
  EXPECT_EQ(limits.find(Imperfection::Undercut, WeldKind::Butt, 2e-3, 2e-3), nullptr);
  const LimitEntry* found = limits.find(Imperfection::Undercut, WeldKind::Butt, 3e-3, 3e-3);
  ASSERT_NE(found, nullptr);
  EXPECT_TRUE(found->verified);
  EXPECT_NEAR(evaluate(found->at(QualityLevel::D), { {}, {}, 3e-3, 3e-3 }).value, 0.6e-3, 1e-12);
  EXPECT_EQ(limits.find(Imperfection::Undercut, WeldKind::Butt, 11e-3, 11e-3), nullptr);
}

TEST(LimitsFile, MayPermitAndForbid)
{
  const Limits limits =
      Limits::parse(table(entry("B: not_permitted, C: {base_mm: 1, short: true}, D: permitted")), "x");
  ASSERT_EQ(limits.entries().size(), 1u);
  EXPECT_EQ(limits.entries()[0].at(QualityLevel::B).rule, LevelLimit::Rule::NotPermitted);
  EXPECT_EQ(limits.entries()[0].at(QualityLevel::C).rule, LevelLimit::Rule::Short);
  EXPECT_EQ(limits.entries()[0].at(QualityLevel::D).rule, LevelLimit::Rule::Permitted);
}

TEST(LimitsFile, IsRefusedByKeyAndValueWithARemedy)
{
  const std::string good = table(entry(kGood));
  ASSERT_EQ(errorOf(good), "");
  expectRefused({
      { "", "my.yaml", "must hold" },
      { "just text", "just text", "must hold" },
      { "version: [1", "line", "correct" },
      { replaced(good, "version: 1", "version: 2"), "version is 2", "must be" },
      { replaced(good, "version: 1\n", ""), "version", "add" },
      { replaced(good, "standard: mine\n", ""), "standard", "add" },
      { replaced(good, "standard: mine", "standard: [a]"), "standard", "must be a text" },
      { replaced(good, "standard: mine", "standart: mine"), "standart", "must be one of" },
      { replaced(good, "thickness_mm: 0.5", "thickness_mm: thin"), "least_thickness_mm is 'thin'", "a number" },
      { replaced(good, "thickness_mm: 0.5", "thickness_mm: .nan"), "least_thickness_mm", "must be in" },
      { replaced(good, "length_mm: 25", "length_mm: 101"), "short.length_mm is 101", "must be in" },
      { replaced(good, "per_mm: 100", "per_mm: 0"), "short.per_mm is 0", "must be in" },
      { replaced(good, "share: 0.25", "share: 25"), "short.share is 25", "must be in" },
      { replaced(good, "share: 0.25", "part: 0.25"), "short.part", "must be one of" },
      { std::string(kHead), "entries", "add" },
      { std::string(kHead) + "entries: []\n", "entries is empty", "one limit or more" },
      { std::string(kHead) + "entries: {a: 1}\n", "entries is no list", "list" },
      { std::string(kHead) + "entries: [1]\n", "entries[0]", "must hold" },
  });
}

TEST(LimitsFile, IsRefusedForAnEntryThatSaysTooLittle)
{
  const std::string good = table(entry(kGood));
  expectRefused({
      { replaced(good, "iso: 5011", "iso: 504"), "entries[0].iso is 504", "must be one of" },
      { replaced(good, "iso: 5011", "iso: x"), "entries[0].iso is 'x'", "a number" },
      { replaced(good, "iso: 5011", "so: 5011"), "entries[0].so", "must be one of" },
      { replaced(good, "[butt]", "[but]"), "entries[0].kinds is 'but'", "must be one of" },
      { replaced(good, "[butt]", "butt"), "entries[0].kinds", "must be a list" },
      { replaced(good, "[butt]", "[]"), "entries[0].kinds is empty", "must be a list" },
      { table(entry(kGood, ", above_mm: -1")), "entries[0].above_mm is -1", "must be in" },
      { table(entry(kGood, ", from_mm: .nan")), "entries[0].from_mm is nan", "must be in" },
      { table(entry(kGood, ", from_mm: 3, to_mm: 2")), "entries[0].to_mm is 2", "must not be less" },
      { replaced(good, "[butt], edition: mine, source: read", "[butt], source: read"), "entries[0].edition", "add" },
      { replaced(good, "[butt], edition: mine, source: read", "[butt], edition: mine"), "entries[0].source", "add" },
      { replaced(good, "[butt], edition: mine, source: read", "[butt], edition: mine, source: seen"),
        "entries[0].source is 'seen'", "must be one of" },
  });
}

TEST(LimitsFile, IsRefusedForALevelThatCannotBe)
{
  const std::string good = table(entry(kGood));
  expectRefused({
      { replaced(good, "B: {base_mm: 0.1}, ", ""), "entries[0].B", "add" },
      { replaced(good, "B: {base_mm: 0.1}", "B: forbidden"), "entries[0].B is 'forbidden'", "must be one of" },
      { replaced(good, "B: {base_mm: 0.1}", "B: {}"), "entries[0].B.base_mm", "add" },
      { replaced(good, "B: {base_mm: 0.1}", "B: {base: 0.1}"), "entries[0].B.base ", "must be one of" },
      { replaced(good, "B: {base_mm: 0.1}", "B: {base_mm: -0.1}"), "entries[0].B.base_mm is -0.1", "must be in" },
      { replaced(good, "B: {base_mm: 0.1}", "B: {base_mm: .inf}"), "entries[0].B.base_mm is inf", "must be in" },
      { replaced(good, "factor: 0.1", "factor: .nan"), "entries[0].D.factor is nan", "must be in" },
      { replaced(good, "factor: 0.1, ", ""), "entries[0].D.factor", "add" },
      { replaced(good, "of: t, ", ""), "entries[0].D.of", "add" },
      { replaced(good, "of: t", "of: h"), "entries[0].D.of is 'h'", "must be one of" },
      { replaced(good, "cap_mm: 1", "cap_mm: 0"), "entries[0].D.cap_mm is 0", "must be in" },
      { replaced(good, "cap_mm: 1", "short: maybe"), "entries[0].D.short is 'maybe'", "true or false" },
      { replaced(good, "B: {base_mm: 0.1}", "B: {base_mm: 0.25}"), "entries[0].B allows more than C", "must" },
      { replaced(good, "B: {base_mm: 0.1}", "B: permitted"), "entries[0].B allows more than C", "must" },
  });
}

TEST(LimitsFile, IsRefusedForALevelThatIsShortWhereTheBetterIsNot)
{
  const auto levels = [](const std::string& text) { return table(entry(text)); };
  expectRefused({
      { levels("B: {base_mm: 0.39}, C: {base_mm: 0.4, short: true}, D: permitted"),
        "entries[0].B allows any length, C only short ones", "short: true" },
      { levels("B: not_permitted, C: {factor: 0.1, of: t}, D: {factor: 0.2, of: t, short: true}"),
        "entries[0].C allows any length, D only short ones", "short: true" },
  });
  EXPECT_EQ(errorOf(levels("B: {base_mm: 0.3, short: true}, C: {base_mm: 0.4, short: true}, D: {base_mm: 0.5}")), "");
  EXPECT_EQ(errorOf(levels("B: {base_mm: 0}, C: {base_mm: 0.4, short: true}, D: permitted")), "") << "B allows nothing";
}

TEST(LimitsFile, IsRefusedForAnEntryThatFitsNoWeld)
{
  const std::string good = table(entry(kGood));
  const std::string angle = replaced(good, "iso: 5011", "iso: 505");
  expectRefused({
      { replaced(good, "iso: 5011, kinds: [butt]", "iso: 502, kinds: [fillet]"), "entries[0].kinds has fillet", "503" },
      { replaced(good, "iso: 5011", "iso: 503"), "entries[0].kinds has butt", "502" },
      { replaced(good, "iso: 5011, kinds: [butt]", "iso: 507, kinds: [fillet]"), "entries[0].kinds has fillet", "not" },
      { table(entry(kGood) + entry(kGood, ", above_mm: 3")), "entries[1] is for the same welds", "remove" },
      { angle, "entries[0].B.base_mm", "must be one of: base_deg" },
      { replaced(angle, "B: {base_mm: 0.1}", "B: not_permitted"), "entries[0].B", "must be an angle" },
      { table("  - {iso: 505, kinds: [butt], edition: x, source: read, B: {base_deg: 90}, C: {base_deg: 100}, "
              "D: {base_deg: 80}}\n"),
        "entries[0].B allows more than C", "must" },
      { table("  - {iso: 505, kinds: [butt], edition: x, source: read, B: {base_deg: 190}, C: permitted, "
              "D: permitted}\n"),
        "entries[0].B.base_deg is 190", "must be in" },
  });
}

TEST(LimitsFile, MayHoldNeighbouringThicknesses)
{
  EXPECT_EQ(errorOf(table(entry(kGood, ", above_mm: 3") + entry(kGood, ", to_mm: 3"))), "");
  EXPECT_NE(errorOf(table(entry(kGood, ", from_mm: 3") + entry(kGood, ", to_mm: 3"))), "") << "3 mm is in both";
}

TEST(LimitsFile, ThatIsMissingIsNamed)
{
  for (const char* path : { "/nowhere/limits.yaml", "/tmp" })
  {
    try
    {
      Limits::load(path);
      ADD_FAILURE() << path << " was accepted";
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    }
  }
}
