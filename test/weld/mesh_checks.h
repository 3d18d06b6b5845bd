#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "weld_profiler/weld/triangle_mesh.h"

namespace weld_profiler
{
constexpr double kDegree = 3.14159265358979323846 / 180.0;

/// What is wrong with a mesh; all zero = a manifold, consistently oriented, every vertex in one fan.
struct MeshFaults
{
  int repeated_sides = 0;  ///< directed edges used twice: overlapping or inconsistently oriented triangles
  int split_vertices = 0;  ///< vertices with more than one fan
  int unused_vertices = 0;
  int bad_normals = 0;  ///< not of length 1, or against a triangle's winding
  int facing_away = 0;  ///< triangles whose winding faces -z

  bool none() const { return repeated_sides + split_vertices + unused_vertices + bad_normals + facing_away == 0; }
};

inline Eigen::Vector3d windingNormal(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle)
{
  const Eigen::Vector3d a = mesh.vertices[triangle[0]].cast<double>();
  return (mesh.vertices[triangle[1]].cast<double>() - a).cross(mesh.vertices[triangle[2]].cast<double>() - a);
}

/// Fans around each vertex: edges opposite to it, chained end to end. Independent of how the mesh was made.
inline int splitVertices(const TriangleMesh& mesh)
{
  std::vector<std::map<std::uint32_t, std::uint32_t>> rings(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      rings[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
  int split = 0;
  for (const auto& ring : rings)
  {
    std::set<std::uint32_t> starts;
    for (const auto& edge : ring)
      starts.insert(edge.first);
    for (const auto& edge : ring)
      starts.erase(edge.second);
    // an open fan has one start and visits all; a closed one has none
    if (starts.size() > 1)
      ++split;
    if (ring.empty())
      continue;
    std::uint32_t at = starts.empty() ? ring.begin()->first : *starts.begin();
    std::size_t visited = 0;
    for (auto edge = ring.find(at); edge != ring.end() && visited < ring.size(); edge = ring.find(edge->second))
      ++visited;
    if (visited != ring.size() && starts.size() <= 1)
      ++split;
  }
  return split;
}

inline MeshFaults faultsOf(const TriangleMesh& mesh)
{
  MeshFaults faults;
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& triangle : mesh.triangles)
  {
    const Eigen::Vector3d normal = windingNormal(mesh, triangle);
    faults.facing_away += normal.z() > 0.0 ? 0 : 1;
    for (std::size_t k = 0; k < 3; ++k)
    {
      used[triangle[k]] = true;
      faults.repeated_sides += sides.insert({ triangle[k], triangle[(k + 1) % 3] }).second ? 0 : 1;
      const Eigen::Vector3d vertex_normal = mesh.normals[triangle[k]].cast<double>();
      const bool good = std::abs(vertex_normal.norm() - 1.0) < 1e-5 && vertex_normal.dot(normal) > 0.0;
      faults.bad_normals += good ? 0 : 1;
    }
  }
  faults.unused_vertices = static_cast<int>(std::count(used.begin(), used.end(), false));
  faults.split_vertices = splitVertices(mesh);
  return faults;
}

inline double sharpestCorner(const TriangleMesh& mesh)
{
  double sharpest = 180.0 * kDegree;
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Eigen::Vector3f a = mesh.vertices[triangle[(k + 1) % 3]] - mesh.vertices[triangle[k]];
      const Eigen::Vector3f b = mesh.vertices[triangle[(k + 2) % 3]] - mesh.vertices[triangle[k]];
      sharpest = std::min(sharpest, static_cast<double>(std::atan2(a.cross(b).norm(), a.dot(b))));
    }
  return sharpest;
}

/// Between the mesh and the plane z = 0.
inline double volumeUnder(const TriangleMesh& mesh)
{
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
  {
    const double seen_from_above = 0.5 * windingNormal(mesh, t).z();
    volume += seen_from_above *
              static_cast<double>(mesh.vertices[t[0]].z() + mesh.vertices[t[1]].z() + mesh.vertices[t[2]].z()) / 3.0;
  }
  return volume;
}

/// Pieces that are connected by common vertices.
inline int pieces(const TriangleMesh& mesh)
{
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  for (std::uint32_t i = 0; i < parent.size(); ++i)
    parent[i] = i;
  const auto root = [&parent](std::uint32_t i)
  {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : mesh.triangles)
    parent[root(t[0])] = root(t[1]), parent[root(t[1])] = root(t[2]);
  std::set<std::uint32_t> roots;
  for (std::uint32_t i = 0; i < parent.size(); ++i)
    roots.insert(root(i));
  return static_cast<int>(roots.size());
}
}  // namespace weld_profiler
