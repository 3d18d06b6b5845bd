#include "weld_profiler/weld/triangle_mesh.h"

#include <Eigen/Geometry>

namespace weld_profiler
{
double area(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (const auto& triangle : mesh.triangles)
  {
    const Eigen::Vector3d a = mesh.vertices[triangle[0]].cast<double>();
    const Eigen::Vector3d b = mesh.vertices[triangle[1]].cast<double>();
    const Eigen::Vector3d c = mesh.vertices[triangle[2]].cast<double>();
    sum += 0.5 * (b - a).cross(c - a).norm();
  }
  return sum;
}
}  // namespace weld_profiler
