#include "weld_profiler/weld/weld_csv.h"

#include <clocale>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>

#include <gtest/gtest.h>

#include "support/small_scene.h"
#include "support/temporary_folder.h"
#include "weld/records.h"
#include "weld_profiler/core/atomic_file.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/simulation/truth_writer.h"

using namespace weld_profiler;

namespace
{
const char* const kMeasured =
    "width_mm,reinforcement_mm,toe_left_x_mm,toe_right_x_mm,toe_angle_left_deg,toe_angle_right_deg,undercut_left_mm,"
    "undercut_right_mm,misalignment_mm,area_mm2";
const char* const kMeasuredLater =
    "toe_left_y_mm,toe_left_z_mm,toe_right_y_mm,toe_right_z_mm,leg_left_mm,leg_right_mm,throat_mm,height_left_mm,"
    "height_right_mm";

std::string joined(const std::vector<std::string>& fields)
{
  std::string line;
  for (const std::string& field : fields)
    line += (line.empty() ? "" : ",") + field;
  return line;
}

/// A decimal comma, as a user's locale may have it.
struct DecimalComma : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};
}  // namespace

TEST(WeldCsv, HasTheColumnsThatOthersRelyOn)
{
  std::string sigmas;
  for (const std::string& name : csvFields(std::string(kMeasured) + "," + kMeasuredLater))
    sigmas += ",sigma_" + name;
  const std::string given = std::string("row,stage_mm,") + kMeasured + ",verdict,section,s_mm,yaw_deg," +
                            kMeasuredLater + sigmas + ",reference";
  const std::string header = joined(weldCsvColumns());
  EXPECT_EQ(header.substr(0, given.size()), given);
  EXPECT_EQ(header.substr(given.size()),
            ",angle_deg,incomplete_fill_mm,sigma_angle_deg,sigma_incomplete_fill_mm,verdict_source");
  EXPECT_EQ(written({}), header + "\n");
}

TEST(WeldCsv, IsWrittenInMillimetresAndDegrees)
{
  const std::string text = written({ fullRecord() });
  const std::vector<std::string> names = weldCsvColumns();
  const std::vector<std::string> fields = csvFields(text.substr(text.find('\n') + 1));
  ASSERT_EQ(fields.size(), names.size());
  const auto field = [&](const std::string& name)
  { return fields[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())]; };
  EXPECT_EQ(field("row"), "12");
  EXPECT_EQ(field("section"), "7");
  EXPECT_EQ(field("stage_mm"), "-250.000000");
  EXPECT_EQ(field("s_mm"), "12.345600");
  EXPECT_EQ(field("width_mm"), "12.000000");
  EXPECT_EQ(field("sigma_width_mm"), "0.010000");
  EXPECT_EQ(field("toe_angle_left_deg"), "160.000000");
  EXPECT_EQ(field("sigma_toe_angle_left_deg"), "1.000000");
  EXPECT_EQ(field("area_mm2"), "8.000000");
  EXPECT_EQ(field("toe_right_z_mm"), "-0.400000");
  EXPECT_EQ(field("verdict"), "C");
  EXPECT_EQ(field("reference"), "parent_lines");
  EXPECT_EQ(field("verdict_source"), "unverified\n");
}

TEST(WeldCsv, LeavesEmptyWhatWasNotMeasured)
{
  WeldRecord record;
  record.section.width = { 1e-3, std::nan("") };  // without a sigma it is none
  const std::string text = written({ record });
  EXPECT_EQ(text.find("nan"), std::string::npos);
  const std::string line = text.substr(text.find('\n') + 1);
  const std::string empty_ten(10, ',');
  EXPECT_EQ(line.substr(0, 13 + 10), "0,0.000000" + empty_ten + ",,0") << line;
  const std::vector<WeldRecord> read = parseWeldCsv(text, "my.csv");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_FALSE(read[0].section.hasBead());
  EXPECT_FALSE(read[0].section.incomplete_fill.measured());
  EXPECT_EQ(read[0].verdict, "");
  EXPECT_FALSE(read[0].unverified);
}

TEST(WeldCsv, IsReadBackAsItWasWritten)
{
  const TemporaryFolder folder;
  const std::vector<WeldRecord> records = { WeldRecord{}, fullRecord() };
  writeWholeFile(folder.file("weld.csv"), written(records));
  const std::vector<WeldRecord> read = readWeldCsv(folder.file("weld.csv"));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(written(read), written(records));
  const WeldSection& section = read[1].section;
  EXPECT_NEAR(section.yaw, -0.1, 1e-8);
  EXPECT_NEAR(section.toe_left.y.value, 2e-3, 1e-9);
  EXPECT_NEAR(section.toe_left.y.sigma, 2e-6, 1e-9);
  EXPECT_NEAR(section.angle.value, 0.02, 1e-8);
  EXPECT_EQ(section.reference, SectionReference::ParentLines);
  EXPECT_EQ(read[1].verdict, "C");
  EXPECT_TRUE(read[1].unverified);
}

TEST(WeldCsv, HasADecimalPointWhateverTheLocale)
{
  const std::string text = written({ fullRecord() });
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  std::ostringstream out;
  writeWeldCsv({ fullRecord() }, out);
  std::string read;
  try
  {
    read = written(parseWeldCsv(text, "my.csv"));
  }
  catch (const Error& error)
  {
    read = error.what();
  }
  std::locale::global(before);
  EXPECT_EQ(out.str(), text);
  EXPECT_EQ(read, text);
}

TEST(WeldCsv, IsReadWithLineEndsOfWindowsAndColumnsOfOthers)
{
  std::string text = replaced(written({ fullRecord() }), ",verdict_source\n", ",verdict_source,mine\r\n");
  text = replaced(text, ",unverified\n", ",unverified,anything\r\n");
  EXPECT_EQ(written(parseWeldCsv(text, "my.csv")), written({ fullRecord() }));
}

TEST(WeldCsv, OfTheTruthHasTheSameColumnsAndIsRead)
{
  SceneParams scene = smallScene(5);
  scene.part_start = 0.02;
  const SimulatedScan scan(scene);
  const TemporaryFolder folder;
  writeTruth(scan, folder.file("truth"));
  std::ifstream file(folder.file("truth/weld.csv"));
  std::string header;
  ASSERT_TRUE(std::getline(file, header));
  std::vector<std::string> ours;
  for (const std::string& name : weldCsvColumns())
  {
    if (name.rfind("sigma_", 0) != 0)
      ours.push_back(name);
  }
  const std::vector<std::string> theirs = csvFields(header);
  // Behind what both have the truth tells a fillet's convexity and the kind, weld.csv of a scan where its verdict is
  // from.
  const std::size_t common = ours.size() - 1;
  ASSERT_EQ(ours.back(), "verdict_source");
  ASSERT_GE(theirs.size(), common);
  EXPECT_EQ(joined(std::vector<std::string>(theirs.begin(), theirs.begin() + common)),
            joined(std::vector<std::string>(ours.begin(), ours.begin() + common)));
  const std::vector<WeldRecord> truth = readWeldCsv(folder.file("truth/weld.csv"));
  ASSERT_EQ(truth.size(), scan.weldSections().size());
  ASSERT_FALSE(truth.empty());
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    EXPECT_NEAR(truth[i].section.width.value, scan.weldSections()[i].width, 1e-9);
    EXPECT_EQ(truth[i].section.width.sigma, 0.0) << "it states exact values";
  }
}

TEST(WeldCsv, RefusesToWriteAVerdictThatItDoesNotKnow)
{
  WeldRecord record = fullRecord();
  record.verdict = "good, mostly";
  std::ostringstream out;
  EXPECT_THROW(writeWeldCsv({ record }, out), PreconditionError);
  EXPECT_EQ(out.str(), "") << "nothing half written";
}
