#include <opencv2/imgcodecs.hpp>

#include "run_command_line.h"
#include "stripe_image.h"

namespace weld_profiler
{
namespace
{
class ExtractStripe : public CommandTest
{
protected:
  CommandResult extract(const std::string& arguments) const { return run("extract_stripe", arguments); }
};

struct Row
{
  double u = 0.0, v = 0.0, normal = 0.0, intensity = 0.0, width = 0.0, sigma = 0.0;
  int flags = 0, cell = -1;
};

std::vector<Row> rowsOf(const std::string& csv)
{
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "u_px,v_px,normal_rad,intensity,width_px,sigma_px,flags,cell");
  std::vector<Row> rows;
  while (std::getline(lines, line))
  {
    Row row;
    EXPECT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%d,%d", &row.u, &row.v, &row.normal, &row.intensity,
                          &row.width, &row.sigma, &row.flags, &row.cell),
              8)
        << line;
    rows.push_back(row);
  }
  return rows;
}

TEST_F(ExtractStripe, NeverWritesAnOverlayOverTheImageItself)
{
  const std::string before = text("a.png");
  const CommandResult result = extract("--overlay --out . a.png");
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(result.says("a.png")) << result.errors;
  EXPECT_EQ(text("a.png"), before);
}

TEST_F(ExtractStripe, WritesOneCentreAColumn)
{
  writeStripeImage(path("flat.png"), 100.3);
  const CommandResult result = extract("--out centres flat.png");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "") << "quiet in a pipe";
  const std::vector<Row> rows = rowsOf(text("centres/flat.csv"));
  ASSERT_GE(rows.size(), 310u);
  for (const Row& row : rows)
  {
    EXPECT_NEAR(row.v, 100.3, 0.1) << "quantised to whole grey levels, no noise";
    EXPECT_NEAR(row.width, 2.0, 0.5);
    EXPECT_NEAR(row.intensity, 180.0, 15.0);
    EXPECT_GE(row.cell, 0);
  }
  EXPECT_EQ(filesIn("centres"), (std::vector<std::string>{ "flat.csv" }));
}

TEST_F(ExtractStripe, TurnsAStripeAlongTheColumns)
{
  writeStripeImage(path("rows.png"), 90.0, 0.1);
  cv::imwrite(path("columns.png"), cv::Mat(cv::imread(path("rows.png"), cv::IMREAD_UNCHANGED).t()));
  ASSERT_EQ(extract("--direction v --out centres columns.png").status, 0);
  ASSERT_EQ(extract("--out auto columns.png").status, 0);
  const std::vector<Row> rows = rowsOf(text("centres/columns.csv"));
  ASSERT_GE(rows.size(), 310u);
  for (const Row& row : rows)
    EXPECT_NEAR(row.u, 90.0 + 0.1 * row.v, 0.2);
  EXPECT_EQ(text("centres/columns.csv"), text("auto/columns.csv"));
}

TEST_F(ExtractStripe, ReadsTheChannelThatWasAskedFor)
{
  writeStripeImage(path("grey.png"), 60.0);
  const cv::Mat stripe = cv::imread(path("grey.png"), cv::IMREAD_UNCHANGED);
  const cv::Mat dark = cv::Mat::zeros(stripe.size(), CV_8UC1);
  cv::Mat image;
  cv::merge(std::vector<cv::Mat>{ stripe, dark, dark }, image);  // blue comes first
  cv::imwrite(path("blue.png"), image);
  EXPECT_EQ(extract("--channel blue --out blue blue.png").status, 0);
  EXPECT_GE(rowsOf(text("blue/blue.csv")).size(), 310u);
  const CommandResult red = extract("--channel red --out red blue.png");
  EXPECT_EQ(red.status, 3) << "no image shows a stripe: ran, but the result is poor";
  EXPECT_TRUE(red.says("blue.png: no stripe found")) << red.errors;
  EXPECT_EQ(rowsOf(text("red/blue.csv")).size(), 0u);
}

TEST_F(ExtractStripe, OverlayIsAnEnlargedColourPicture)
{
  writeStripeImage(path("a.png"), 100.0);
  ASSERT_EQ(extract("--overlay --overlay-scale 2 --out centres a.png").status, 0);
  const cv::Mat overlay = cv::imread(path("centres/a.png"), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(overlay.size(), cv::Size(640, 480));
  EXPECT_EQ(overlay.channels(), 3);
  EXPECT_EQ(filesIn("centres"), (std::vector<std::string>{ "a.csv", "a.png" }));
}

TEST_F(ExtractStripe, ParametersComeFromTheFileAndTheCommandLineWins)
{
  writeStripeImage(path("a.png"), 100.0);
  write("dim.yaml", "stripe_centre:\n  min_peak_counts: 250\n  method: nonsense\ntriangulation:\n  pitch: 0.1\n");
  EXPECT_EQ(extract("--params dim.yaml --method gray_centroid --out o a.png").status, 3) << "180 grey levels only";
  write("typo.yaml", "min_peak: 30\n");
  const CommandResult typo = extract("--params typo.yaml --out o a.png");
  EXPECT_EQ(typo.status, 1);
  EXPECT_TRUE(typo.says("typo.yaml: unknown parameter 'min_peak'")) << typo.errors;
  EXPECT_EQ(extract("--params none.yaml --out o a.png").status, 1);
}

TEST_F(ExtractStripe, GoodImagesAreWrittenBesideABrokenOne)
{
  writeStripeImage(path("a.png"), 100.0);
  writeStripeImage(path("b.png"), 100.0);
  writeStripeImage(path("c.png"), 100.0);
  std::filesystem::resize_file(path("b.png"), std::filesystem::file_size(path("b.png")) / 2);
  const CommandResult result = extract("--out centres a.png b.png c.png missing.png");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errorLines(), 2) << result.errors;
  EXPECT_TRUE(result.says("extract_stripe: b.png: the image is truncated")) << result.errors;
  EXPECT_TRUE(result.says("extract_stripe: missing.png: cannot be read: No such file")) << result.errors;
  EXPECT_EQ(filesIn("centres"), (std::vector<std::string>{ "a.csv", "c.csv" }));
}

TEST_F(ExtractStripe, RefusesTwoImagesOfOneStem)
{
  std::filesystem::create_directory(folder_ / "x");
  writeStripeImage(path("a.png"), 100.0);
  writeStripeImage(path("x/a.png"), 50.0);
  const CommandResult result = extract("--out centres a.png x/a.png");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errorLines(), 1);
  EXPECT_TRUE(result.says("x/a.png: its centres would go to a.csv as those of a.png")) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(path("centres")));
}

TEST_F(ExtractStripe, NamesABadMethodDirectionOrChannelAndTheKnownOnes)
{
  writeStripeImage(path("a.png"), 100.0);
  for (const char* bad : { "--method steeger", "--direction w", "--channel infrared" })
  {
    const CommandResult result = extract(std::string(bad) + " --out centres a.png");
    EXPECT_EQ(result.status, 1) << bad;
    EXPECT_EQ(result.errorLines(), 1) << result.errors;
    EXPECT_TRUE(result.says("must be one of:")) << result.errors;
  }
  EXPECT_EQ(extract("--overlay-scale 17 --overlay --out centres a.png").status, 1);
  EXPECT_FALSE(std::filesystem::exists(path("centres")));
}

TEST_F(ExtractStripe, RefusesAnOutputThatCannotBeWritten)
{
  writeStripeImage(path("a.png"), 100.0);
  write("file", "in the way");
  const CommandResult result = extract("--out file a.png");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errorLines(), 1);
  EXPECT_TRUE(result.says("file: the directory cannot be created")) << result.errors;
  EXPECT_EQ(extract("--out /proc/centres a.png").status, 1);
}

TEST_F(ExtractStripe, UsageErrorsAreStatusTwoAndHelpIsZero)
{
  EXPECT_EQ(extract("--out centres").status, 2);
  EXPECT_EQ(extract("a.png").status, 2);
  const CommandResult unknown = extract("--overlayy --out centres a.png");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(unknown.says("nearest known: --overlay")) << unknown.errors;
  const CommandResult help = extract("--help");
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.output.find("squared_centroid"), std::string::npos) << "the methods are listed";
}

TEST_F(ExtractStripe, SameImageSameBytes)
{
  writeStripeImage(path("a.png"), 100.0, 0.2);
  ASSERT_EQ(extract("--overlay --out one a.png").status, 0);
  ASSERT_EQ(extract("--overlay --out two a.png").status, 0);
  EXPECT_EQ(text("one/a.csv"), text("two/a.csv"));
  EXPECT_EQ(text("one/a.png"), text("two/a.png"));
}
}  // namespace
}  // namespace weld_profiler
