#include "weld_profiler/scan/scan_assembler.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scan/profiles.h"
#include "weld_profiler/core/errors.h"

using namespace weld_profiler;
using Outcome = ScanAssembler::Outcome;

namespace
{
constexpr double kUm = 1e-6;

struct Assembled
{
  std::vector<Scan> scans;  ///< the ended ones, and what was open at the end
  int skipped = 0;
};

Assembled assemble(const ScanParams& params, const std::vector<double>& stages)
{
  ScanAssembler assembler(params, "part");
  Assembled result;
  for (const double stage : stages)
  {
    ScanAssembler::Result added = assembler.add(profileAt(stage));
    result.skipped += added.outcome == Outcome::Skipped ? 1 : 0;
    if (added.ended)
      result.scans.push_back(*added.ended);
  }
  Scan last = assembler.close(ScanEnd::Stopped);
  if (!last.empty())
    result.scans.push_back(last);
  return result;
}

std::vector<double> stagesOf(const Scan& scan)
{
  std::vector<double> stages;
  for (const Profile& row : scan.rows)
    stages.push_back(row.stage);
  return stages;
}

/// from, from + step, ... up to and with to
std::vector<double> ramp(double from, double to, double step)
{
  std::vector<double> stages;
  const int count = static_cast<int>(std::lround((to - from) / step));
  for (int i = 0; i <= count; ++i)
    stages.push_back(from + i * step);
  return stages;
}

std::vector<double> joined(std::vector<double> first, const std::vector<double>& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

ScanParams withPitch(double pitch)
{
  ScanParams params;
  params.pitch = pitch;
  return params;
}
}  // namespace

TEST(ScanAssembler, MakesARowEachTimeTheStageMovedByThePitch)
{
  const Assembled result = assemble(withPitch(100 * kUm), ramp(0.0, 1e-3, 40 * kUm));
  ASSERT_EQ(result.scans.size(), 1u);
  const std::vector<double> stages = stagesOf(result.scans[0]);
  ASSERT_EQ(stages.size(), 9u);  // every third of 26 profiles
  for (std::size_t i = 1; i < stages.size(); ++i)
    EXPECT_NEAR(stages[i] - stages[i - 1], 120 * kUm, 1e-12);
  EXPECT_EQ(result.skipped, 26 - 9);
  EXPECT_EQ(result.scans[0].frame_id, "part");
  EXPECT_EQ(result.scans[0].cells, 4u);
}

TEST(ScanAssembler, MakesARowAtEachStepOfExactlyOnePitch)
{
  std::vector<double> stages;
  double stage = 0.0;
  for (int i = 0; i < 1000; ++i, stage += 0.001)  // a sum, so that the last digit is off either way
    stages.push_back(stage);
  EXPECT_EQ(assemble(withPitch(0.001), stages).skipped, 0);
}

TEST(ScanAssembler, CountsThePitchEitherWayWhenTheStageRunsBackwardsFromTheStart)
{
  const Assembled result = assemble(withPitch(100 * kUm), ramp(0.0, -1e-2, -100 * kUm));
  ASSERT_EQ(result.scans.size(), 1u);
  EXPECT_EQ(result.scans[0].rows.size(), 101u);
}

TEST(ScanAssembler, SkipsWhileTheStageStandsStill)
{
  std::vector<double> stages = ramp(0.0, 1e-3, 100 * kUm);
  for (int i = 0; i < 50; ++i)
    stages.push_back(1e-3 + (i % 2 == 0 ? 1.5 * kUm : -1.5 * kUm));  // within still_tolerance
  const Assembled result = assemble(ScanParams{}, stages);
  ASSERT_EQ(result.scans.size(), 1u);
  EXPECT_EQ(result.scans[0].rows.size(), 11u);
  EXPECT_EQ(result.skipped, 50);
}

TEST(ScanAssembler, MakesARowAFrameWithTheTimeTrigger)
{
  ScanParams params = withPitch(1e-3);
  params.trigger = "time";
  const Assembled result = assemble(params, std::vector<double>(30, 0.5));
  ASSERT_EQ(result.scans.size(), 1u);
  EXPECT_EQ(result.scans[0].rows.size(), 30u);
}

TEST(ScanAssembler, ClosesTheScanAtAReversal)
{
  const auto there = ramp(0.0, 10e-3, 100 * kUm);
  const auto back = ramp(9.9e-3, 0.0, -100 * kUm);
  const Assembled result = assemble(ScanParams{}, joined(there, back));
  ASSERT_EQ(result.scans.size(), 2u);
  EXPECT_EQ(result.scans[0].end, ScanEnd::Reversal);
  EXPECT_EQ(stagesOf(result.scans[0]), there) << "nothing of the way back is in the scan of the way there";
  EXPECT_NEAR(result.scans[1].rows.front().stage, 9.5e-3, 1e-9) << "begins where the hysteresis is covered";
  EXPECT_NEAR(result.scans[1].rows.back().stage, 0.0, 1e-9);
  EXPECT_EQ(result.scans[1].end, ScanEnd::Stopped);
  EXPECT_EQ(result.skipped, 4);
}

TEST(ScanAssembler, ClosesAScanThatRunsTheNegativeWayAtItsReversal)
{
  const Assembled result = assemble(ScanParams{}, joined(ramp(0.0, -10e-3, -100 * kUm), ramp(-9.9e-3, 0.0, 100 * kUm)));
  ASSERT_EQ(result.scans.size(), 2u);
  EXPECT_EQ(result.scans[0].rows.size(), 101u);
}

TEST(ScanAssembler, MakesOneScanOfEachPass)
{
  std::vector<double> stages;
  for (int pass = 0; pass < 5; ++pass)
    stages = joined(stages, pass % 2 == 0 ? ramp(0.0, 5e-3, 50 * kUm) : ramp(5e-3, 0.0, -50 * kUm));
  EXPECT_EQ(assemble(ScanParams{}, stages).scans.size(), 5u);
}

TEST(ScanAssembler, DoesNotTakeAVibrationForAReversal)
{
  std::vector<double> stages;
  for (int i = 0; i < 400; ++i)
    stages.push_back(i * 25 * kUm + 200 * kUm * std::sin(i * 1.3));
  const Assembled result = assemble(ScanParams{}, stages);
  ASSERT_EQ(result.scans.size(), 1u);
  const std::vector<double> rows = stagesOf(result.scans[0]);
  ASSERT_GT(rows.size(), 50u);
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    const bool direction_known = rows[i] > 1e-3;
    EXPECT_TRUE(!direction_known || rows[i] > rows[i - 1]) << "rows lie in order along the scan";
  }
}

TEST(ScanAssembler, GoesOnThroughAReversalThatIsIgnored)
{
  ScanParams params = withPitch(100 * kUm);
  params.on_reversal = "ignore";
  const Assembled result = assemble(params, joined(ramp(0.0, 5e-3, 100 * kUm), ramp(4.9e-3, 0.0, -100 * kUm)));
  ASSERT_EQ(result.scans.size(), 1u);
  EXPECT_EQ(result.scans[0].rows.size(), 101u);
  EXPECT_EQ(result.skipped, 0);
}

TEST(ScanAssembler, ClosesAScanOfMaxRowsAndBeginsTheNext)
{
  ScanParams params = withPitch(100 * kUm);
  params.max_rows = 40;
  const Assembled result = assemble(params, ramp(0.0, 9.9e-3, 50 * kUm));  // 199 profiles, 100 rows
  ASSERT_EQ(result.scans.size(), 3u);
  EXPECT_EQ(result.scans[0].rows.size(), 40u);
  EXPECT_EQ(result.scans[1].rows.size(), 40u);
  EXPECT_EQ(result.scans[2].rows.size(), 20u);
  EXPECT_EQ(result.scans[0].end, ScanEnd::MaxRows);
  EXPECT_NEAR(result.scans[1].rows.front().stage - result.scans[0].rows.back().stage, 100 * kUm, 1e-12)
      << "the pitch goes on across the scans";
}

TEST(ScanAssembler, ClosesTheScanWhenTheWidthChanges)
{
  ScanAssembler assembler(ScanParams{}, "part");
  assembler.add(profileAt(0.0, 4));
  assembler.add(profileAt(1e-3, 4));
  const ScanAssembler::Result result = assembler.add(profileAt(2e-3, 6));
  ASSERT_TRUE(result.ended);
  EXPECT_EQ(result.ended->rows.size(), 2u);
  EXPECT_EQ(result.ended->cells, 4u);
  EXPECT_EQ(result.outcome, Outcome::Row);
  EXPECT_EQ(assembler.open().cells, 6u);
  EXPECT_EQ(assembler.open().rows.size(), 1u);
}

TEST(ScanAssembler, KeepsTheScanWhenAFrameWithoutAStripeHasAnotherWidth)
{
  ScanAssembler assembler(ScanParams{}, "part");
  EXPECT_FALSE(assembler.add(profileAt(0.0, 6, 0)).ended) << "which way the stripe will run is not known yet";
  EXPECT_FALSE(assembler.add(profileAt(1e-3, 4)).ended);
  EXPECT_FALSE(assembler.add(profileAt(2e-3, 6, 0)).ended);
  EXPECT_FALSE(assembler.add(profileAt(3e-3, 4)).ended);
  const Scan scan = assembler.close(ScanEnd::Stopped);
  EXPECT_EQ(scan.cells, 4u);
  ASSERT_EQ(scan.rows.size(), 4u);
  for (const Profile& row : scan.rows)
    EXPECT_EQ(row.cells, 4u);
}

TEST(ScanAssembler, BeginsAnewAfterClose)
{
  ScanAssembler assembler(withPitch(1e-3), "part");
  EXPECT_TRUE(assembler.close(ScanEnd::Stopped).empty());
  assembler.add(profileAt(0.0));
  EXPECT_EQ(assembler.add(profileAt(1e-5)).outcome, Outcome::Skipped);
  EXPECT_EQ(assembler.close(ScanEnd::Stopped).rows.size(), 1u);
  EXPECT_EQ(assembler.add(profileAt(1e-5)).outcome, Outcome::Row);
  EXPECT_EQ(assembler.open().frame_id, "part");
  EXPECT_EQ(assembler.open().end, ScanEnd::Open);
}

TEST(ScanAssembler, RefusesAProfileThatWasNotPlaced)
{
  ScanAssembler assembler(ScanParams{}, "part");
  EXPECT_THROW(assembler.add(profileAt(std::numeric_limits<double>::quiet_NaN())), PreconditionError);
}
