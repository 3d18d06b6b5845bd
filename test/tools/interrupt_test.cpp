#include <filesystem>
#include <string>
#include <vector>

#include "scan_bag_case.h"
#include "stripe_image.h"

namespace weld_profiler
{
namespace
{
/// The command alone is told, or with its report program, as a terminal does with Ctrl-C.
const std::string kCommand = "$pid", kGroup = "-$pid";

const std::vector<std::string> kScanFiles = { "scan.pcd", "scan.ply", "summary.json" };

class Interrupt : public ScanBag
{
protected:
  /// Runs a command and interrupts it once `ready`, as often as it takes: Python, while it starts, loses one in
  /// hundreds. What it says stands in `errors`.
  /// @param ready  a condition, @param kill  signal and whom: for the shell, where the command is $pid.
  int interrupted(const std::string& command, const std::string& ready, const std::string& kill) const
  {
    const std::string commands = WELD_PROFILER_COMMANDS "/";
    write("interrupt.sh", "set -m\n" + commands + command + " 2> errors &\npid=$!\nuntil " + ready +
                              " || ! kill -0 $pid; do sleep 0.02; done\nwhile kill " + kill +
                              "; do sleep 0.1; done\nwait $pid\n");
    const int status = std::system(("cd " + path("") + " && bash interrupt.sh > /dev/null 2>&1").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// Once the report program runs, the only one that scan_bag starts.
  int interruptedScan(const std::string& options, const std::string& kill) const
  {
    return interrupted("scan_bag " + kCalibration + options + "--out scan weld.bag",
                       "grep -q python /proc/$(cat /proc/$pid/task/$pid/children | tr -d ' ')/comm", kill);
  }

  /// As soon as the report is all that is missing.
  void expectNoReport(const std::string& kill) const
  {
    EXPECT_EQ(interruptedScan("", kill), 130) << kill << ": " << text("errors");
    EXPECT_EQ(text("errors"),
              "scan_bag: interrupted, what is in scan stays and is whole; missing: the report of scan "
              "(weld_report.py scan draws it)\n")
        << kill;
    EXPECT_EQ(filesIn("scan"),
              (std::vector<std::string>{ "bead.ply", "passes.csv", "scan.pcd", "scan.ply", "spots.csv", "summary.json",
                                         "target.ply", "verdict.csv", "weld.csv", "weld.json", "weld_points.pcd" }))
        << kill;
  }
};

TEST_F(Interrupt, WhileTheReportIsDrawnTheRestStaysAndIsNamed)
{
  for (const char* number : { "-INT", "-TERM" })
  {
    expectNoReport(std::string(number) + " -- " + kGroup);
    std::filesystem::remove_all(path("scan"));
  }
}

TEST_F(Interrupt, OfWhatAnEarlierRunDrewNothingPassesForTheReport)
{
  ASSERT_EQ(scan(kCalibration + "--out scan weld.bag").status, 0);
  ASSERT_TRUE(std::filesystem::exists(path("scan/report.png")));
  expectNoReport("-INT -- " + kGroup);
}

TEST_F(Interrupt, AReportProgramThatHeardNothingDrawsTheReport)
{
  EXPECT_EQ(interruptedScan("", "-INT " + kCommand), 130) << text("errors");
  EXPECT_EQ(text("errors"),
            "scan_bag: interrupted, but everything was written before it ended: nothing is missing in scan\n");
  EXPECT_EQ(filesIn("scan").size(), 13u);
  EXPECT_TRUE(std::filesystem::exists(path("scan/report.html")));
  EXPECT_TRUE(std::filesystem::exists(path("scan/report.png")));
}

TEST_F(Interrupt, WeldsThatWereNotMeasuredAreNamed)
{
  write("short.yaml", "triangulation: {max_rows: 10}\n");
  EXPECT_EQ(interruptedScan("--params short.yaml ", "-INT -- " + kGroup), 130) << text("errors");
  EXPECT_EQ(text("errors"),
            "scan_bag: interrupted, what is in scan stays and is whole; missing: the report of scan, the "
            "weld's files and report of scan/scan_2 (run the command again)\n");
  EXPECT_TRUE(std::filesystem::exists(path("scan/weld.json")));
  EXPECT_TRUE(std::filesystem::exists(path("scan/scan_2.pcd")));
  EXPECT_FALSE(std::filesystem::exists(path("scan/scan_2/weld.json")));
}

TEST_F(Interrupt, ImagesThatWereExtractedAreCounted)
{
  std::string images;
  for (int i = 0; i < 200; ++i)
  {
    const std::string name = "frame" + std::to_string(1000 + i) + ".png";
    writeStripeImage(path(name), 60.0);
    images += " " + name;
  }
  EXPECT_EQ(interrupted("extract_stripe --out centres" + images, "[ -e centres/frame1001.csv ]", "-INT " + kCommand),
            130);
  const std::size_t count = filesIn("centres").size();
  EXPECT_LT(count, 200u);
  EXPECT_EQ(text("errors"), "extract_stripe: interrupted, the files of the first " + std::to_string(count) +
                                " of 200 images stay in centres, whole\n");
}
}  // namespace
}  // namespace weld_profiler
