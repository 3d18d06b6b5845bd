#include <cmath>

#include <gtest/gtest.h>

#include "weld/ideal_scan.h"
#include "weld_profiler/weld/weld_measurer.h"

// What is told of one row, the live values, where one of the parents is hardly in view.

namespace weld_profiler
{
namespace
{
/// A row in which only so much of the plate on one side is in view.
Profile cutRow(const Profile& row, const IdealWeld& weld, int side, double in_view)
{
  Profile cut = row;
  cut.points.clear();
  for (const CloudPoint& point : row.points)
  {
    if (side * static_cast<double>(point.x) < 0.5 * weld.width + in_view)
      cut.points.push_back(point);
  }
  return cut;
}

/// A low wide bead, in whose face straight pieces long enough for a parent are found, between offset plates.
IdealWeld lowBead(double width)
{
  IdealWeld weld;
  weld.width = width;
  weld.height = 0.08 * width;
  weld.misalignment = 0.0004;
  weld.angle = 0.02;
  return weld;
}

/// Of misalignments and angles: how often they were told, and their errors over their sigmas.
struct Told
{
  int rows = 0, misalignments = 0;
  double squares = 0.0;

  void add(const WeldSection& section, const IdealWeld& weld)
  {
    ++rows;
    if (!section.misalignment.measured())
    {
      EXPECT_FALSE(section.angle.measured());
      return;
    }
    ++misalignments;
    const double offset = section.misalignment.value - weld.misalignment * std::cos(weld.angle);
    const double angle = section.angle.value - weld.angle;
    EXPECT_LT(std::abs(offset), 5.0 * section.misalignment.sigma) << "sigma " << section.misalignment.sigma;
    EXPECT_LT(std::abs(angle), 5.0 * section.angle.sigma) << "sigma " << section.angle.sigma;
    squares += offset * offset / (section.misalignment.sigma * section.misalignment.sigma);
  }

  double spread() const { return std::sqrt(squares / misalignments); }
};

Told measured(double in_view)
{
  Told told;
  for (const double width : { 0.010, 0.014, 0.018 })
  {
    const IdealWeld weld = lowBead(width);
    IdealScanner scanner;
    scanner.rows = 10;
    scanner.noise = 4e-6;
    for (const Profile& row : scanner(weld).rows)
      for (const int side : { -1, 1 })
        told.add(WeldMeasurer().measureRow(cutRow(row, weld, side, in_view)), weld);
  }
  return told;
}
}  // namespace

TEST(LiveRow, TellsNoMisalignmentWhereAPlateIsHardlyInView)
{
  for (const double in_view : { 0.0003, 0.0005, 0.001, 0.0015, 0.002 })
  {
    const Told told = measured(in_view);
    ASSERT_EQ(told.rows, 60);
    EXPECT_LE(told.misalignments, 6) << "a plate that ends " << in_view << " m from the toe";
  }
}

TEST(LiveRow, TellsHowUncertainAMisalignmentIsWhereLittleOfAPlateIsInView)
{
  for (const double in_view : { 0.004, 0.005, 0.006 })
  {
    const Told told = measured(in_view);
    ASSERT_EQ(told.rows, 60);
    EXPECT_GE(told.misalignments, in_view < 0.005 ? 25 : 45) << in_view;
    EXPECT_GT(told.spread(), 0.3) << "sigmas are not blown up either, " << in_view;
    EXPECT_LT(told.spread(), 1.5) << in_view;
  }
}

TEST(LiveRow, TellsMisalignmentAndAngleWhereBothPlatesAreInView)
{
  const Told told = measured(1.0);
  EXPECT_GE(told.misalignments, 55) << "of 60";
  EXPECT_LT(told.spread(), 1.5);
}
}  // namespace weld_profiler
