#include "weld_profiler/weld/weld_surface.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "made_cases.h"
#include "mesh_checks.h"

using namespace weld_profiler;

namespace
{
std::vector<MadeCase> cases()
{
  return bothWays({
      { "Straight", [](MadeWeld&) {} },
      { "Yawed", [](MadeWeld& weld) { weld.yaw = 20.0 * kDegree; } },
      { "CurvedRight", [](MadeWeld& weld) { weld.bend = 1.0 / 0.08; } },
      { "CurvedLeftAndYawed", [](MadeWeld& weld) { weld.bend = -1.0 / 0.08, weld.yaw = -10.0 * kDegree; } },
      { "Misaligned", [](MadeWeld& weld) { weld.misalignment = 0.5e-3; } },
      { "Narrowing", [](MadeWeld& weld) { weld.narrowing = 0.3; } },
      { "Noisy", [](MadeWeld& weld) { weld.sigma = 15e-6; } },
      { "CoarseRows", [](MadeWeld& weld) { weld.pitch = 0.4e-3, weld.rows = 50; } },
      { "HighAndNarrow", [](MadeWeld& weld) { weld.width = 4e-3, weld.height = 1.6e-3; } },
      { "WithHoles",
        [](MadeWeld& weld) {
          weld.holes = { { -2e-3, 0.0, -2e-3, 1e-3 }, { 4e-3, 5e-3, -9e-3, -3e-3 }, { 5e-3, 5.8e-3, -3e-3, 0.0 } };
        } },
  });
}

class SurfaceOf : public ::testing::TestWithParam<MadeCase>
{
protected:
  SurfaceOf() : weld_(GetParam().weld)
  {
    weld_.make();
    meshes_ = makeWeldMeshes(weld_.scan, weld_.result);
  }

  /// Whether a place is so near to a hole that a mesh may end there.
  bool whole() const { return weld_.holes.empty(); }

  MadeWeld weld_;
  WeldMeshes meshes_;
};
}  // namespace

TEST_P(SurfaceOf, IsAManifoldThatFacesTheSensor)
{
  EXPECT_EQ(meshes_.reason, "");
  ASSERT_GT(meshes_.bead.triangles.size(), 2000U);
  ASSERT_GT(meshes_.target.triangles.size(), meshes_.bead.triangles.size());
  for (const TriangleMesh* mesh : { &meshes_.bead, &meshes_.target })
  {
    ASSERT_EQ(mesh->normals.size(), mesh->vertices.size());
    const MeshFaults faults = faultsOf(*mesh);
    EXPECT_EQ(faults.repeated_sides, 0);
    EXPECT_EQ(faults.split_vertices, 0);
    EXPECT_EQ(faults.unused_vertices, 0);
    EXPECT_EQ(faults.bad_normals, 0);
    EXPECT_EQ(faults.facing_away, 0);
  }
}

TEST_P(SurfaceOf, HasNoSlivers)
{
  // the target lies nearly flat: half a step beside a step makes 26 deg, a little less where the grid is oblique
  ASSERT_FALSE(meshes_.target.empty());
  EXPECT_GT(sharpestCorner(meshes_.target), 20.0 * kDegree);
  ASSERT_FALSE(meshes_.bead.empty());
  EXPECT_GT(sharpestCorner(meshes_.bead), 15.0 * kDegree);  // flanks of up to 77 deg
}

TEST_P(SurfaceOf, IsOnePiece)
{
  EXPECT_EQ(pieces(meshes_.bead), 1);
  EXPECT_EQ(pieces(meshes_.target), 1);
}

TEST_P(SurfaceOf, LiesOnTheWeld)
{
  ASSERT_FALSE(meshes_.bead.empty());
  const double tolerance = 4e-6 + 0.8 * weld_.sigma;  // 60 points a vertex; half of them at an edge
  for (const Eigen::Vector3f& vertex : meshes_.bead.vertices)
  {
    const Eigen::Vector2d place = weld_.locate(vertex.x(), vertex.y());
    const double q = std::max(-0.5 * weld_.widthAt(place.x()), std::min(0.5 * weld_.widthAt(place.x()), place.y()));
    ASSERT_NEAR(place.y(), q, 5e-6) << "beyond a toe";
    ASSERT_NEAR(vertex.z(), weld_.surface(place.x(), q), tolerance) << "q " << q;
  }
  for (const Eigen::Vector3f& vertex : meshes_.target.vertices)
  {
    const Eigen::Vector2d place = weld_.locate(vertex.x(), vertex.y());
    ASSERT_NEAR(vertex.z(), weld_.flush(place.x(), place.y()), tolerance) << "q " << place.y();
  }
}

TEST_P(SurfaceOf, HasTheNormalsOfTheWeld)
{
  ASSERT_FALSE(meshes_.bead.empty());
  double worst = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < meshes_.bead.vertices.size(); ++i)
  {
    const Eigen::Vector3f& vertex = meshes_.bead.vertices[i];
    const auto height = [this](double x, double y)
    {
      const Eigen::Vector2d place = weld_.locate(x, y);
      const double edge = 0.5 * weld_.widthAt(place.x()) - 2e-6;
      return weld_.surface(place.x(), std::max(-edge, std::min(edge, place.y())));
    };
    const Eigen::Vector2d place = weld_.locate(vertex.x(), vertex.y());
    const double edge = 0.5 * weld_.widthAt(place.x()) - 4e-6;
    const Eigen::Vector2d p = weld_.at(place.x(), std::max(-edge, std::min(edge, place.y())));
    const double d = 1e-6;
    const Eigen::Vector3d normal(-(height(p.x() + d, p.y()) - height(p.x() - d, p.y())) / (2.0 * d),
                                 -(height(p.x(), p.y() + d) - height(p.x(), p.y() - d)) / (2.0 * d), 1.0);
    const double cosine = normal.normalized().dot(meshes_.bead.normals[i].cast<double>());
    const double angle = std::acos(std::min(1.0, cosine));
    worst = std::max(worst, angle);
    sum += angle;
  }
  // at a toe normals lean inward by the turn of the face over the mesh's 0.2 mm: 1/6 rad a mm, 1/2 for the narrow one
  // at a toe the vertices around lie to one side: their normals are those of the face up to a step further in
  const double s = weld_.narrowing > 0.0 ? 0.5 * weld_.length() : 0.0, step = WeldSurfaceParams().mesh_step;
  const double turn = weld_.halfAngle(s) - std::asin((0.5 * weld_.widthAt(s) - step) / weld_.radius(s));
  EXPECT_LT(sum / static_cast<double>(meshes_.bead.vertices.size()), 1.5 * kDegree);
  EXPECT_LT(worst, turn + 1.0 * kDegree);
}

TEST_P(SurfaceOf, HasTheAreaAndVolumeOfTheWeld)
{
  if (!whole() || weld_.narrowing != 0.0)
    return;
  const double length = weld_.length();
  EXPECT_NEAR(area(meshes_.bead) / (weld_.arc() * length), 1.0, weld_.misalignment > 0.0 ? 0.02 : 0.005);
  const double volume = volumeUnder(meshes_.bead) - (-0.5 * weld_.misalignment * weld_.width * length);
  EXPECT_NEAR(volume / (weld_.segmentArea() * length), 1.0, 0.01);
  WeldSurfaceParams defaults;
  EXPECT_NEAR(area(meshes_.target) / ((weld_.width + 2.0 * defaults.target_margin) * length), 1.0, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Welds, SurfaceOf, ::testing::ValuesIn(cases()), nameOf);
