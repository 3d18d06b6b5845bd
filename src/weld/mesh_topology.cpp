#include "mesh_topology.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr int kEvenRounds = 1;  // of normals, with their neighbours': one vertex's noise is a degree or two

/// Sets that grow together (union-find with path halving).
class Sets
{
public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{ 0 }); }

  std::size_t of(std::size_t i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void unite(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

private:
  std::vector<std::size_t> parent_;
};

/// The side of a triangle that begins at its corner.
struct Side
{
  std::uint32_t low = 0, high = 0;  ///< nodes
  std::size_t corner = 0;           ///< 3 * triangle + k
};

std::size_t nextCorner(std::size_t corner)
{
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// Calls with both sides of every edge that two triangles have in common.
template <class Found>
void eachSharedEdge(const std::vector<Triangle>& triangles, Found&& found)
{
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      sides.push_back({ std::min(a, b), std::max(a, b), 3 * t + k });
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high)
      found(sides[i - 1].corner, sides[i].corner);
}

Eigen::Vector3d doubleArea(const std::vector<Eigen::Vector3d>& nodes, const Triangle& triangle)
{
  return (nodes[triangle[1]] - nodes[triangle[0]]).cross(nodes[triangle[2]] - nodes[triangle[0]]);
}

/// Of the triangles around each vertex with the weights that are exact on a sphere: N. Max, "Weights for Computing
/// Vertex Normals from Facet Normals", 1999. Triangles on a steep flank are large and would count too much by their
/// area.
void addNormals(TriangleMesh& mesh)
{
  mesh.normals.assign(mesh.vertices.size(), Eigen::Vector3f::Zero());
  for (const Triangle& triangle : mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Eigen::Vector3f& here = mesh.vertices[triangle[k]];
      const Eigen::Vector3f a = mesh.vertices[triangle[(k + 1) % 3]] - here;
      const Eigen::Vector3f b = mesh.vertices[triangle[(k + 2) % 3]] - here;
      mesh.normals[triangle[k]] += a.cross(b) / (a.squaredNorm() * b.squaredNorm());
    }
  }
  for (int round = 0; round < kEvenRounds; ++round)
  {
    for (Eigen::Vector3f& normal : mesh.normals)
      normal.normalize();
    std::vector<Eigen::Vector3f> even = mesh.normals;
    for (const Triangle& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle)
        even[corner] += 0.5F * (mesh.normals[triangle[0]] + mesh.normals[triangle[1]] + mesh.normals[triangle[2]] -
                                mesh.normals[corner]);
    mesh.normals = std::move(even);
  }
  for (Eigen::Vector3f& normal : mesh.normals)
    normal.normalize();
}
}  // namespace

void dropSmallPieces(const std::vector<Eigen::Vector3d>& nodes, double min_area, std::vector<Triangle>& triangles)
{
  Sets pieces(triangles.size());
  eachSharedEdge(triangles, [&pieces](std::size_t a, std::size_t b) { pieces.unite(a / 3, b / 3); });
  std::vector<double> area(triangles.size(), 0.0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    area[pieces.of(t)] += 0.5 * doubleArea(nodes, triangles[t]).norm();
  std::vector<Triangle> kept;
  kept.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (area[pieces.of(t)] >= min_area)
      kept.push_back(triangles[t]);
  triangles = std::move(kept);
}

TriangleMesh connect(const std::vector<Eigen::Vector3d>& nodes, const std::vector<Triangle>& triangles)
{
  Sets fans(3 * triangles.size());
  eachSharedEdge(triangles,
                 [&fans](std::size_t a, std::size_t b)
                 {
                   // neighbours run along their common edge in opposite directions
                   fans.unite(a, nextCorner(b));
                   fans.unite(nextCorner(a), b);
                 });
  TriangleMesh mesh;
  constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::vector<std::uint32_t> vertex_of(3 * triangles.size(), kNone);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
    {
      std::uint32_t& vertex = vertex_of[fans.of(3 * t + k)];
      if (vertex == kNone)
      {
        vertex = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(nodes[triangles[t][k]].cast<float>());
      }
      triangle[k] = vertex;
    }
    mesh.triangles.push_back(triangle);
  }
  addNormals(mesh);
  return mesh;
}
}  // namespace weld
}  // namespace weld_profiler
