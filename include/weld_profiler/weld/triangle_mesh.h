#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace weld_profiler
{
/// A surface of triangles. Corners run counter-clockwise seen from where the surface faces.
struct TriangleMesh
{
  std::vector<Eigen::Vector3f> vertices;  ///< [m]
  std::vector<Eigen::Vector3f> normals;   ///< one a vertex, of length 1
  std::vector<std::array<std::uint32_t, 3>> triangles;

  bool empty() const { return triangles.empty(); }
};

/// Sum of the triangles' areas [m^2].
double area(const TriangleMesh& mesh);
}  // namespace weld_profiler
