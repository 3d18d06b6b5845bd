#include "weld_profiler/weld/mesh_ply.h"

#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>
#ifdef WELD_PROFILER_HAS_VTK
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#endif

#include "made_weld.h"
#include "support/temporary_folder.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/weld/weld_surface.h"

using namespace weld_profiler;

namespace
{
TriangleMesh square()
{
  TriangleMesh mesh;
  mesh.vertices = { { 0.0F, 0.0F, 0.0F }, { 0.01F, 0.0F, 0.0F }, { 0.01F, 0.02F, 0.001F }, { 0.0F, 0.02F, 0.0F } };
  mesh.normals.assign(4, Eigen::Vector3f::UnitZ());
  mesh.triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
  return mesh;
}

/// The bead of a made weld, in a file.
class PlyOfAWeld : public ::testing::Test
{
protected:
  PlyOfAWeld()
  {
    MadeWeld weld;
    weld.rows = 60;
    weld.make();
    mesh_ = makeWeldMeshes(weld.scan, weld.result).bead;
    std::ofstream file(path_, std::ios::binary);
    writePly(mesh_, file, { "weld 7", "frame weld_profiler_scan" });
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("bead.ply");
  TriangleMesh mesh_;
};
}  // namespace

TEST(MeshPly, IsWhatPlannersRead)
{
  std::ostringstream out;
  writePly(square(), out, { "weld 7" });
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment weld 7\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n";
  ASSERT_EQ(out.str().substr(0, header.size()), header);
  EXPECT_EQ(out.str().size(), header.size() + 4 * 24 + 2 * 13);
  const std::string face = out.str().substr(header.size() + 4 * 24, 13);
  EXPECT_EQ(face, std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13));
}

TEST_F(PlyOfAWeld, IsReadByPclWithNormals)
{
  ASSERT_GT(mesh_.triangles.size(), 100U);
  pcl::PolygonMesh read;
  ASSERT_EQ(pcl::PLYReader().read(path_, read), 0);
  ASSERT_EQ(read.polygons.size(), mesh_.triangles.size());
  pcl::PointCloud<pcl::PointNormal> cloud;
  pcl::fromPCLPointCloud2(read.cloud, cloud);
  ASSERT_EQ(cloud.size(), mesh_.vertices.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    ASSERT_EQ(cloud[i].getVector3fMap(), mesh_.vertices[i]);
    ASSERT_EQ(cloud[i].getNormalVector3fMap(), mesh_.normals[i]);
  }
  for (std::size_t i = 0; i < read.polygons.size(); ++i)
  {
    ASSERT_EQ(read.polygons[i].vertices.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_EQ(static_cast<std::uint32_t>(read.polygons[i].vertices[k]), mesh_.triangles[i][k]);
  }
}

#ifdef WELD_PROFILER_HAS_VTK
TEST_F(PlyOfAWeld, IsReadByVtkWithNormals)
{
  ASSERT_GT(mesh_.triangles.size(), 100U);
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(path_.c_str());
  reader->Update();
  vtkPolyData* read = reader->GetOutput();
  ASSERT_EQ(static_cast<std::size_t>(read->GetNumberOfPoints()), mesh_.vertices.size());
  ASSERT_EQ(static_cast<std::size_t>(read->GetNumberOfPolys()), mesh_.triangles.size());
  vtkDataArray* normals = read->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  for (std::size_t i = 0; i < mesh_.vertices.size(); ++i)
  {
    double place[3], normal[3];
    read->GetPoint(static_cast<vtkIdType>(i), place);
    normals->GetTuple(static_cast<vtkIdType>(i), normal);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(static_cast<float>(place[k]), mesh_.vertices[i](k));
      ASSERT_EQ(static_cast<float>(normal[k]), mesh_.normals[i](k));
    }
  }
  vtkNew<vtkIdList> corners;
  read->GetPolys()->InitTraversal();
  for (const auto& triangle : mesh_.triangles)
  {
    ASSERT_TRUE(read->GetPolys()->GetNextCell(corners));
    ASSERT_EQ(corners->GetNumberOfIds(), 3);
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(corners->GetId(k), static_cast<vtkIdType>(triangle[static_cast<std::size_t>(k)]));
  }
}
#endif

TEST(MeshPly, OfNothingIsAFileOfNothing)
{
  std::ostringstream out;
  writePly(TriangleMesh(), out);
  EXPECT_NE(out.str().find("element vertex 0\n"), std::string::npos);
  EXPECT_NE(out.str().find("element face 0\n"), std::string::npos);
}

TEST(MeshPly, RefusesAMeshThatIsNone)
{
  std::ostringstream out;
  TriangleMesh mesh = square();
  mesh.normals.pop_back();
  EXPECT_THROW(writePly(mesh, out), PreconditionError);
  mesh = square();
  mesh.triangles[1][2] = 4;
  EXPECT_THROW(writePly(mesh, out), PreconditionError);
  EXPECT_THROW(writePly(square(), out, { "two\nlines" }), PreconditionError);
  EXPECT_TRUE(out.str().empty()) << "nothing is written of what is refused";
}
