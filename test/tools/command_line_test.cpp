#include "tools/command_line.h"

#include <gtest/gtest.h>

#include "tools/run_command.h"

namespace weld_profiler
{
namespace
{
class CommandLineTest : public ::testing::Test
{
protected:
  CommandLineTest() : command_("weigh", "Weighs things.")
  {
    command_.option("out DIR", out_, "where results go");
    command_.required();
    command_.option("mass KG", mass_, "of the scale");
    command_.option("count N", count_, "how many");
    command_.flag("dry", dry_, "without water");
    command_.arguments("THING...", things_, "what to weigh");
    command_.example("weigh --out here apple");
  }

  bool parse(std::vector<const char*> words)
  {
    words.insert(words.begin(), "weigh");
    return command_.parse(static_cast<int>(words.size()), words.data());
  }

  std::string refusal(const std::vector<const char*>& words)
  {
    try
    {
      parse(words);
    }
    catch (const UsageError& error)
    {
      return error.what();
    }
    return "not refused";
  }

  CommandLine command_;
  std::string out_;
  double mass_ = 1.5;
  int count_ = 3;
  bool dry_ = false;
  std::vector<std::string> things_;
};

TEST_F(CommandLineTest, ReadsOptionsFlagsAndArguments)
{
  ASSERT_TRUE(parse({ "--out", "here", "apple", "--mass=-2.5", "--dry", "--count", "7", "--", "--pear" }));
  EXPECT_EQ(out_, "here");
  EXPECT_DOUBLE_EQ(mass_, -2.5);
  EXPECT_EQ(count_, 7);
  EXPECT_TRUE(dry_);
  EXPECT_EQ(things_, (std::vector<std::string>{ "apple", "--pear" }));
}

TEST_F(CommandLineTest, TakesANegativeNumberAsAValue)
{
  ASSERT_TRUE(parse({ "--out", "here", "--mass", "-1", "apple" }));
  EXPECT_DOUBLE_EQ(mass_, -1.0);
}

TEST_F(CommandLineTest, NamesTheUnknownOptionAndTheNearestKnownOne)
{
  EXPECT_EQ(refusal({ "--cout", "3" }), "unknown option --cout, nearest known: --out; see weigh --help");
  EXPECT_EQ(refusal({ "--coumt", "3" }), "unknown option --coumt, nearest known: --count; see weigh --help");
  EXPECT_NE(refusal({ "-o", "here" }).find("unknown option -o"), std::string::npos);
}

TEST_F(CommandLineTest, RefusesWhatCannotBeRead)
{
  EXPECT_EQ(refusal({ "--out", "d", "--mass", "heavy", "x" }), "--mass is 'heavy', must be a number");
  EXPECT_EQ(refusal({ "--out", "d", "--count", "1.5", "x" }), "--count is '1.5', must be a whole number");
}

TEST_F(CommandLineTest, RefusesACountThatIsNotANumber)
{
  EXPECT_EQ(refusal({ "--out", "d", "--count", "nan", "x" }), "--count is 'nan', must be a whole number");
}

TEST_F(CommandLineTest, RefusesAMissingOption)
{
  EXPECT_EQ(refusal({ "apple" }), "--out DIR is missing; see weigh --help");
}

TEST_F(CommandLineTest, RefusesAnOptionWithoutItsValue)
{
  EXPECT_EQ(refusal({ "--out" }), "--out needs a value: --out DIR");
}

TEST_F(CommandLineTest, RefusesAnOptionGivenTwice)
{
  EXPECT_EQ(refusal({ "--out", "a", "--out", "b", "x" }), "--out is given twice; give it once");
}

TEST_F(CommandLineTest, RefusesAFlagWithAValueAndNoArguments)
{
  EXPECT_EQ(refusal({ "--dry=yes" }), "--dry takes no value");
  EXPECT_EQ(refusal({ "--out", "d" }), "THING... is missing; see weigh --help");
}

TEST_F(CommandLineTest, HelpNamesEveryOptionItsDefaultAndAnExample)
{
  const std::string help = command_.help();
  for (const char* text : { "usage: weigh --out DIR", "Weighs things.", "--mass KG", "(default 1.5)", "(required)",
                            "weigh --out here apple", "exit status", "130 interrupted" })
    EXPECT_NE(help.find(text), std::string::npos) << text;
}

TEST(RunCommand, MapsExceptionsToExitStatuses)
{
  const char* words[] = { "weigh" };
  const auto status = [&](const std::function<int()>& body)
  {
    CommandLine command("weigh", "");
    return runCommand(command, 1, words, body);
  };
  EXPECT_EQ(status([] { return static_cast<int>(kGood); }), 0);
  EXPECT_EQ(status([] { return static_cast<int>(kPoorResult); }), 3);
  EXPECT_EQ(status([]() -> int { throw UsageError("x"); }), 2);
  EXPECT_EQ(status([]() -> int { throw std::runtime_error("x"); }), 1);
}

TEST(RunCommand, SaysItInOneLine)
{
  const char* words[] = { "weigh" };
  CommandLine command("weigh", "");
  ::testing::internal::CaptureStderr();
  runCommand(command, 1, words, []() -> int { throw std::runtime_error("first\nsecond\n"); });
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "weigh: first second\n");
}
}  // namespace
}  // namespace weld_profiler
