#include "weld_profiler/weld/weld_surface.h"

#include <utility>

#include <gtest/gtest.h>

#include "made_weld.h"
#include "mesh_checks.h"
#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

TEST(WeldSurface, LeavesHolesWhereNothingWasSeen)
{
  MadeWeld weld;
  weld.holes = { { -2e-3, 0.0, -2e-3, 1e-3 } };
  weld.make();
  const WeldMeshes meshes = makeWeldMeshes(weld.scan, weld.result);
  ASSERT_FALSE(meshes.bead.empty());
  for (const TriangleMesh* mesh : { &meshes.bead, &meshes.target })
  {
    int inside = 0;
    for (const auto& triangle : mesh->triangles)
    {
      const Eigen::Vector3f middle =
          (mesh->vertices[triangle[0]] + mesh->vertices[triangle[1]] + mesh->vertices[triangle[2]]) / 3.0F;
      const Eigen::Vector2d place = weld.locate(middle.x(), middle.y());
      inside += place.x() > -1.8e-3 && place.x() < -0.2e-3 && place.y() > -1.8e-3 && place.y() < 0.8e-3 ? 1 : 0;
    }
    EXPECT_EQ(inside, 0);
  }
  const double hole = 2e-3 * 3e-3;
  const double missing = (weld.width + 6e-3) * weld.length() - area(meshes.target);
  EXPECT_NEAR(missing / hole, 1.0, 0.25);  // its edge is known to half a step
}

TEST(WeldSurface, BridgesGapsUpToTheLimit)
{
  MadeWeld weld;
  weld.holes = { { -2e-3, 2e-3, 0.0, 0.4e-3 } };
  weld.make();
  WeldSurfaceParams params;
  const double bridged = area(makeWeldMeshes(weld.scan, weld.result, params).bead);
  params.max_gap = 0.25e-3;
  const double open = area(makeWeldMeshes(weld.scan, weld.result, params).bead);
  EXPECT_NEAR(bridged / (weld.arc() * weld.length()), 1.0, 0.003);
  EXPECT_GT(bridged - open, 0.5 * 4e-3 * 0.4e-3);
}

TEST(WeldSurface, DropsLoosePieces)
{
  MadeWeld weld;  // an island of 0.8 mm x 0.8 mm in a hole of 4 mm x 4 mm
  weld.holes = { { -2e-3, -0.4e-3, -2e-3, 2e-3 },
                 { 0.4e-3, 2e-3, -2e-3, 2e-3 },
                 { -0.5e-3, 0.5e-3, -2e-3, -0.4e-3 },
                 { -0.5e-3, 0.5e-3, 0.4e-3, 2e-3 } };
  weld.make();
  WeldSurfaceParams params;
  EXPECT_EQ(pieces(makeWeldMeshes(weld.scan, weld.result, params).bead), 1);
  params.min_piece_area = 1e-7;
  const TriangleMesh with = makeWeldMeshes(weld.scan, weld.result, params).bead;
  EXPECT_EQ(pieces(with), 2);
  EXPECT_TRUE(faultsOf(with).none());
}

TEST(WeldSurface, KeepsTheBeadInsideItsInset)
{
  MadeWeld weld;
  weld.make();
  WeldSurfaceParams params;
  params.edge_inset = 0.5e-3;
  const WeldMeshes meshes = makeWeldMeshes(weld.scan, weld.result, params);
  ASSERT_FALSE(meshes.bead.empty());
  double left = 1.0, right = -1.0;
  for (const Eigen::Vector3f& vertex : meshes.bead.vertices)
    left = std::min(left, static_cast<double>(vertex.x())), right = std::max(right, static_cast<double>(vertex.x()));
  EXPECT_NEAR(left, -0.5 * weld.width + params.edge_inset, 2e-6);
  EXPECT_NEAR(right, 0.5 * weld.width - params.edge_inset, 2e-6);
  EXPECT_TRUE(faultsOf(meshes.bead).none());
  EXPECT_NEAR(area(meshes.target) / ((weld.width + 6e-3) * weld.length()), 1.0, 0.01);  // as it was
}

TEST(WeldSurface, OfARestIsALowTableThatEndsOnTheFlanks)
{
  MadeWeld weld;
  weld.rest = 0.3e-3;
  weld.make();
  const WeldMeshes meshes = makeWeldMeshes(weld.scan, weld.result);
  ASSERT_FALSE(meshes.target.empty());
  for (const Eigen::Vector3f& vertex : meshes.target.vertices)
  {
    const Eigen::Vector2d place = weld.locate(vertex.x(), vertex.y());
    const double left = std::min(weld.rest, weld.rise(place.x(), place.y()));  // grinding adds nothing
    ASSERT_NEAR(vertex.z(), left, 5e-6) << "q " << place.y();
  }
  EXPECT_TRUE(faultsOf(meshes.target).none());
}

TEST(WeldSurface, LeavesPointsFilledInAcrossAGapOut)
{
  MadeWeld weld;
  weld.make();
  std::size_t filled = 0;
  for (Profile& row : weld.scan.rows)
    for (CloudPoint& point : row.points)
      if (std::abs(point.x) < 1e-3F)
        point.flags = stripe_flag::kInterpolated, ++filled;
  ASSERT_GT(filled, 0U);
  const WeldMeshes meshes = makeWeldMeshes(weld.scan, weld.result);
  ASSERT_FALSE(meshes.bead.empty());
  EXPECT_EQ(pieces(meshes.bead), 2);
}

TEST(WeldSurface, SaysWhyThereIsNone)
{
  MadeWeld weld;
  weld.make();
  WeldResult none = weld.result;
  none.kind = WeldKind::None;
  none.reason = "no bead stands out";
  EXPECT_EQ(makeWeldMeshes(weld.scan, none).reason, "no bead stands out");
  none.reason.clear();
  EXPECT_EQ(makeWeldMeshes(weld.scan, none).reason, "the scan shows no weld");
  WeldResult toeless = weld.result;
  for (WeldSection& section : toeless.sections)
    section.toe_left = SectionPoint();
  EXPECT_NE(makeWeldMeshes(weld.scan, toeless).reason.find("both toes were measured in 0 sections"), std::string::npos);
  WeldSurfaceParams fine;
  fine.max_gap = 1e-4;
  weld.pitch = 2e-4;
  MadeWeld coarse = weld;
  coarse.result = WeldResult();
  coarse.scan = Scan();
  coarse.make();
  const WeldMeshes meshes = makeWeldMeshes(coarse.scan, coarse.result, fine);
  EXPECT_NE(meshes.reason.find("more than max_gap"), std::string::npos) << meshes.reason;
  EXPECT_TRUE(meshes.bead.empty());
}

TEST(WeldSurface, RefusesAResultOfAnotherScan)
{
  MadeWeld weld;
  weld.make();
  Scan shorter = weld.scan;
  shorter.rows.pop_back();
  EXPECT_THROW(makeWeldMeshes(shorter, weld.result), PreconditionError);
  WeldResult pathless = weld.result;
  pathless.path.pop_back();
  EXPECT_THROW(makeWeldMeshes(weld.scan, pathless), PreconditionError);
  WeldResult backwards = weld.result;
  std::swap(backwards.path[3].s, backwards.path[4].s);
  EXPECT_THROW(makeWeldMeshes(weld.scan, backwards), PreconditionError);
  WeldResult unlabelled = weld.result;
  unlabelled.labels.clear();
  EXPECT_THROW(makeWeldMeshes(weld.scan, unlabelled), PreconditionError);
}
