// Pores that a face would hide.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "weld/ideal_scan.h"
#include "weld/low_ripples.h"
#include "weld/pits.h"
#include "weld_profiler/weld/weld_evaluation.h"

namespace weld_profiler
{
namespace
{
/// A butt weld whose ripples trail at the toes.
Crescents rippled(double ripple)
{
  Crescents face;
  face.weld.width = 0.010, face.weld.height = 1.5e-3, face.weld.misalignment = 3e-4;
  face.ripple = ripple;
  return face;
}

/// Whether a pit is told as a pore, or as a hollow that may be one.
bool isTold(const Crescents& face, const Pit& pit)
{
  const WeldResult result =
      WeldMeasurer().measure(fineRows()([&](double x, double y) { return face(x, y) - pit(x, y); }));
  const auto is_it = [&](const WeldSpot& spot)
  { return spot.kind == WeldSpot::Kind::Pore && std::hypot(spot.x - pit.x, spot.y - pit.y) < 0.5 * pit.diameter; };
  return std::any_of(result.spots.begin(), result.spots.end(), is_it) ||
         std::any_of(result.hollows.begin(), result.hollows.end(), is_it);
}
}  // namespace

TEST(UnseenPores, ALargerOneIsToldAndAMuchSmallerOneIsNot)
{
  for (const double ripple : { 0.0, 1e-4, 2e-4 })
  {
    SCOPED_TRACE(ripple);
    const Crescents weld = rippled(ripple);
    const UnseenPores unseen = WeldMeasurer().measure(fineRows()(weld)).unseen_pores;
    ASSERT_GT(unseen.round, 0.0);
    EXPECT_LT(unseen.round, unseen.shallow);
    int larger = 0, smaller = 0;
    for (const double x : { -0.0015, 0.0, 0.0006 })
    {
      for (const double y : { 0.0072, 0.0090 })
      {
        const double shallow = 1.2 * unseen.shallow, round = 1.2 * unseen.round, small = 0.4 * unseen.shallow;
        larger += isTold(weld, { x, y, shallow, 0.25 * shallow }) ? 1 : 0;
        larger += isTold(weld, { x, y, round, 0.5 * round }) ? 1 : 0;
        smaller += isTold(weld, { x, y, small, 0.25 * small }) ? 1 : 0;
      }
    }
    EXPECT_GE(larger, 10) << "of 12: in a quarter of the face they may be larger";
    EXPECT_LE(smaller, 1) << "of 6";
  }
}

TEST(UnseenPores, RipplesThatHideThemLeaveTheVerdictOpen)
{
  WeldSettings settings;
  settings.judging.thickness = 0.005;
  const WeldEvaluator evaluator(settings);
  for (const double ripple : { 0.0, 1e-4, 3e-4 })
  {
    const WeldEvaluation evaluation = evaluator.evaluate(fineRows()(rippled(ripple)));
    const bool hide = ripple > 2e-4;
    EXPECT_EQ(evaluation.result.unseen_pores.round > 5e-4, hide) << ripple;
    const auto row = std::find_if(evaluation.verdict.rows.begin(), evaluation.verdict.rows.end(),
                                  [](const VerdictRow& one) { return one.imperfection == Imperfection::SurfacePore; });
    ASSERT_NE(row, evaluation.verdict.rows.end());
    EXPECT_EQ(row->level, QualityLevel::B);
    EXPECT_EQ(row->decision, hide ? Decision::Undecided : Decision::Pass) << ripple;
  }
}
}  // namespace weld_profiler
