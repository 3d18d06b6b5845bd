#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "weld/ground_weld.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/weld/scan_comparison.h"

namespace weld_profiler
{
namespace
{
void expectRefused(const Scan& before, const Scan& after, const std::string& words,
                   const ScanComparer& comparer = ScanComparer())
{
  try
  {
    comparer.compare(before, after);
    ADD_FAILURE() << "not refused: " << words;
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

Scan scanOf(const IdealWeld& weld, unsigned seed = 2)
{
  return longerScanner(seed)(weld);
}

IdealWeld flush()
{
  IdealWeld weld;
  weld.width = 0.0;
  return weld;
}
}  // namespace

TEST(CompareRefusal, NoWeldInTheScanBefore)
{
  expectRefused(scanOf(flush()), scanOf(flush(), 3), "the scan before shows no weld");
}

TEST(CompareRefusal, ScansOfDifferentPlaces)
{
  IdealScanner elsewhere;
  elsewhere.first_y = 0.030;
  expectRefused(scanOf(IdealWeld()), elsewhere(flush()), "do not overlap");
}

TEST(CompareRefusal, OnlyOneParentIsSeenAfter)
{
  const auto half = [](double x, double /*y*/) { return x < 0.004 ? 0.0 : NAN; };
  expectRefused(scanOf(IdealWeld()), longerScanner(3)(half), "of the parent right of the weld");
}

TEST(CompareRefusal, APartWithOtherParents)
{
  IdealWeld offset = flush();
  offset.misalignment = 0.0005;
  expectRefused(scanOf(IdealWeld()), scanOf(offset, 3), "the parents do not match");
}

TEST(CompareRefusal, PlatesAtAnotherAngle)
{
  IdealWeld bent;
  bent.width = 0.0, bent.angle = 3.0 * kDegree;
  expectRefused(scanOf(IdealWeld()), scanOf(bent, 3), "the parents do not match");
}

TEST(CompareRefusal, ScansTooFarApart)
{
  const Scan far = moved(scanOf(flush(), 3), motionAbout({ 0, 0, 0 }, { 0, 0, 0.015 }, { 0, 0, 0 }));
  expectRefused(scanOf(IdealWeld()), far, "max_shift");
  const Scan turned = moved(scanOf(flush(), 3), motionAbout({ 0, 0.006, 0 }, { 0, 0, 0 }, { 0, 7, 0 }));
  expectRefused(scanOf(IdealWeld()), turned, "max_turn_deg");
}

TEST(CompareRefusal, AScanAfterWithoutASurface)
{
  Scan one_row = scanOf(flush());
  one_row.rows.resize(1);
  expectRefused(scanOf(IdealWeld()), one_row, "no surface");
  expectRefused(scanOf(IdealWeld()), Scan(), "no surface");
}

TEST(CompareRefusal, AnEmptyScanBefore)
{
  expectRefused(Scan(), scanOf(flush()), "shows no weld");
}

TEST(CompareRefusal, ACellOutsideItsScan)
{
  const Scan good = scanOf(IdealWeld());
  Scan broken = scanOf(flush());
  broken.rows[3].points[5].cell = 1000;
  EXPECT_THROW(ScanComparer().compare(good, broken), PreconditionError);
  EXPECT_THROW(ScanComparer().compare(broken, good), PreconditionError);
}

TEST(CompareParams, RefusesWhatIsOutOfRange)
{
  const auto refuses = [](double CompareParams::*field, double value, const std::string& name)
  {
    CompareParams params;
    params.*field = value;
    try
    {
      ScanComparer(WeldParams(), params);
      ADD_FAILURE() << name << " " << value << " was taken";
    }
    catch (const ConfigError& error)
    {
      EXPECT_EQ(std::string(error.what()).find(name), 0u) << error.what();
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : { nan, 0.0, -1e-5, 0.02 })
    refuses(&CompareParams::over_ground_limit, value, "over_ground_limit");
  for (const double value : { nan, -1e-9, 1e-3 })
    refuses(&CompareParams::min_spot_area, value, "min_spot_area");
  for (const double value : { nan, 0.0, 0.05 })
    refuses(&CompareParams::placement, value, "placement");
  for (const double value : { nan, 0.0, 11.0 })
    refuses(&CompareParams::placement_turn_deg, value, "placement_turn_deg");
  for (const double value : { nan, 0.0, 0.01 })
    refuses(&CompareParams::max_residual, value, "max_residual");
  for (const double value : { nan, 0.0, 1.0 })
    refuses(&CompareParams::max_shift, value, "max_shift");
  for (const double value : { nan, 0.0, 21.0 })
    refuses(&CompareParams::max_turn_deg, value, "max_turn_deg");
  WeldParams measuring;
  measuring.kind = "spot";
  EXPECT_THROW(ScanComparer{ measuring }, ConfigError);
}
}  // namespace weld_profiler
