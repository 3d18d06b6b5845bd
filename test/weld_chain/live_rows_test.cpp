#include <cmath>

#include <gtest/gtest.h>

#include "tools/simulated_cloud.h"
#include "weld_profiler/simulation/random_welds.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace
{
constexpr double kAllOfIt = 1.0;  // [m]

/// The misalignments that are told of rows with one plate cut off, of welds from the rendered image on.
struct Misalignments
{
  int rows = 0, told = 0, wild = 0;
  double squares = 0.0;

  void add(const Quantity& misalignment, double truth)
  {
    ++rows;
    if (!misalignment.measured())
      return;
    ++told;
    const double off = (misalignment.value - truth) / misalignment.sigma;
    wild += std::abs(off) > 6.0 || std::abs(misalignment.value - truth) > 2.5e-4 ? 1 : 0;
    squares += off * off;
  }
};

void addRow(const Profile& row, const WeldTruth& truth, double in_view, Misalignments& all)
{
  for (const int side : { -1, 1 })
  {
    const double toe = side < 0 ? truth.toe_left[0] : truth.toe_right[0];
    Profile cut = row;
    cut.points.clear();
    for (const CloudPoint& point : row.points)
    {
      if (side * (static_cast<double>(point.x) - toe) < in_view * std::cos(truth.yaw))
        cut.points.push_back(point);
    }
    all.add(WeldMeasurer().measureRow(cut, { truth.yaw, 0.0 }).misalignment, truth.misalignment);
  }
}

/// Rows of butt welds and beads on plate against the simulation's exact truth.
std::vector<Misalignments> measured(const std::vector<double>& in_view)
{
  std::vector<Misalignments> all(in_view.size());
  for (std::uint64_t seed = 100; seed < 124; ++seed)
  {
    SceneParams scene = randomWeldScene(seed);
    if (scene.weld.kind == "fillet")
      continue;
    scene.frame_count = 6;
    const SimulatedScan simulated(scene);
    const Scan scan = simulatedCloud(simulated);
    for (const WeldTruth& truth : simulated.weldSections())
    {
      for (std::size_t i = 0; i < in_view.size(); ++i)
        addRow(scan.rows.at(static_cast<std::size_t>(truth.row)), truth, in_view[i], all[i]);
    }
  }
  return all;
}

TEST(LiveRows, TellNoWildMisalignmentWhereAPlateIsHardlyInView)
{
  const std::vector<Misalignments> all = measured({ 0.0003, 0.001, 0.002, 0.003, 0.004, 0.006, kAllOfIt });
  for (const Misalignments& one : all)
  {
    EXPECT_GE(one.rows, 150);
    EXPECT_LE(one.wild, 0.01 * one.rows);
  }
  EXPECT_LE(all[0].told, 0.02 * all[0].rows) << "0.3 mm of a plate tell nothing";
  for (std::size_t i : { 4u, 5u, 6u })
  {
    EXPECT_GE(all[i].told, (i == 4 ? 0.3 : 0.6) * all[i].rows);
    EXPECT_NEAR(std::sqrt(all[i].squares / all[i].told), 1.0, 0.5) << "sigmas as they should be";
  }
}
}  // namespace
}  // namespace weld_profiler
