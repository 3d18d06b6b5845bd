#include "weld/records.h"
#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

namespace
{
std::string errorOf(const std::string& text)
{
  try
  {
    parseWeldCsv(text, "my.csv");
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

/// The text with one field of its first record replaced.
std::string spoilt(const std::string& column, const std::string& value)
{
  std::istringstream text(written({ fullRecord(), fullRecord() }));
  std::string header, line, rest;
  std::getline(text, header);
  std::getline(text, line);
  std::getline(text, rest);
  const std::vector<std::string> names = csvFields(header);
  std::vector<std::string> fields = csvFields(line);
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (names[i] == column)
      fields[i] = value;
  }
  std::string spoilt_line;
  for (std::size_t i = 0; i < fields.size(); ++i)
    spoilt_line += (i == 0 ? "" : ",") + fields[i];
  return header + "\n" + rest + "\n" + spoilt_line + "\n";
}
}  // namespace

TEST(WeldCsv, ThatIsBrokenIsRefusedByLineAndColumn)
{
  const std::string good = written({ fullRecord() });
  ASSERT_EQ(errorOf(good), "");
  const struct
  {
    std::string text, what, remedy;
  } cases[] = {
    { "", "my.csv is empty", "write it again" },
    { good.substr(0, good.size() - 1), "ends within a line", "write it again" },
    { good.substr(0, good.size() - 40) + "\n", "line 2 has", "must have 50" },
    { good + "\n", "line 3 has 1 fields", "must have 50" },
    { "some text\n", "column row is missing", "no weld.csv" },
    { replaced(good, "row,", "rows,"), "column row is missing", "no weld.csv" },
    { replaced(good, ",sigma_throat_mm", ",sigma_throat"), "column sigma_throat_mm is missing", "write it again" },
    { replaced(good, ",s_mm,", ",row,"), "column row stands there twice", "write it again" },
    { spoilt("width_mm", "wide"), "line 3: width_mm is 'wide'", "must be a number or empty" },
    { spoilt("width_mm", "1.2.3"), "line 3: width_mm is '1.2.3'", "must be a number" },
    { spoilt("width_mm", " 1"), "line 3: width_mm is ' 1'", "must be a number" },
    { spoilt("width_mm", "nan"), "width_mm is 'nan'", "must be a number" },
    { spoilt("width_mm", "inf"), "width_mm is 'inf'", "must be a number" },
    { spoilt("width_mm", "1e999"), "width_mm is '1e999'", "must be a number" },
    { spoilt("sigma_width_mm", ""), "sigma_width_mm is ''", "width_mm is measured" },
    { spoilt("sigma_width_mm", "-0.1"), "sigma_width_mm is '-0.1'", "must be a number from 0" },
    { spoilt("stage_mm", ""), "stage_mm is ''", "must be a number" },
    { spoilt("s_mm", ""), "s_mm is ''", "must be a number" },
    { spoilt("yaw_deg", "x"), "yaw_deg is 'x'", "must be a number" },
    { spoilt("row", "1.5"), "row is '1.5'", "a whole number" },
    { spoilt("row", "-1"), "row is '-1'", "a whole number" },
    { spoilt("row", "1e300"), "row is '1e300'", "a whole number" },
    { spoilt("section", ""), "section is ''", "must be a number" },
    { spoilt("verdict", "A"), "verdict is 'A'", "must be one of: empty, B" },
    { spoilt("reference", "cho"), "reference is 'cho'", "must be one of: chord" },
    { spoilt("verdict_source", "seen"), "verdict_source is 'seen'", "must be one of" },
  };
  for (const auto& c : cases)
  {
    const std::string error = errorOf(c.text);
    EXPECT_NE(error.find("my.csv"), std::string::npos) << error;
    EXPECT_NE(error.find(c.what), std::string::npos) << error << "\nshould say: " << c.what;
    EXPECT_NE(error.find(c.remedy), std::string::npos) << error << "\nshould say: " << c.remedy;
  }
}

TEST(WeldCsv, ThatIsMissingIsNamed)
{
  for (const char* path : { "/nowhere/weld.csv", "/tmp" })
  {
    try
    {
      readWeldCsv(path);
      ADD_FAILURE() << path << " was accepted";
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    }
  }
}
