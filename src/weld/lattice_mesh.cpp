#include "lattice_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh_topology.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

/// The triangles over a lattice whose corners are known and not too sharp; corners are the lattice's nodes.
class Triangulation
{
public:
  Triangulation(const WeldLattice& lattice, const std::vector<double>& z, double min_angle)
    : lattice_(lattice), z_(z), most_cosine_(std::cos(min_angle))
  {
  }

  std::vector<Triangle> operator()()
  {
    for (int i = 0; i + 1 < lattice_.rowCount(); ++i)
    {
      const LatticeRow& row = lattice_.rows[static_cast<std::size_t>(i)];
      const LatticeRow& next = lattice_.rows[static_cast<std::size_t>(i) + 1];
      if (!row.valid || !next.valid)
        continue;
      for (int j = std::min(row.first, next.first); j < std::max(row.last, next.last); ++j)
        fillCell(i, j);
    }
    return std::move(triangles_);
  }

private:
  void fillCell(int i, int j)
  {
    // counter-clockwise seen from +z: right of the path, then along it
    const std::array<std::size_t, 4> corners = { { lattice_.at(i, j), lattice_.at(i, j + 1), lattice_.at(i + 1, j + 1),
                                                   lattice_.at(i + 1, j) } };
    std::array<Triangle, 4> without;  // each of the corners
    int missing = -1, missing_count = 0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      for (std::size_t n = 0; n < 3; ++n)
        without[k][n] = static_cast<std::uint32_t>(corners[(k + 1 + n) % 4]);
      if (!std::isfinite(z_[corners[k]]))
        missing = static_cast<int>(k), ++missing_count;
    }
    if (missing_count == 1)
      add(without[static_cast<std::size_t>(missing)]);
    if (missing_count > 0)
      return;
    const std::size_t k = std::max(largestCosine(without[0]), largestCosine(without[2])) <
                                  std::max(largestCosine(without[1]), largestCosine(without[3]))
                              ? 0
                              : 1;
    add(without[k]);
    add(without[k + 2]);
  }

  void add(const Triangle& triangle)
  {
    if (largestCosine(triangle) <= most_cosine_)
      triangles_.push_back(triangle);
  }

  /// Of the sharpest corner.
  double largestCosine(const Triangle& triangle) const
  {
    double largest = -1.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d here = node(triangle[k]);
      const Eigen::Vector3d a = node(triangle[(k + 1) % 3]) - here, b = node(triangle[(k + 2) % 3]) - here;
      largest = std::max(largest, a.dot(b) / (a.norm() * b.norm()));
    }
    return largest;
  }

  Eigen::Vector3d node(std::size_t at) const { return { lattice_.x[at], lattice_.y[at], z_[at] }; }

  const WeldLattice& lattice_;
  const std::vector<double>& z_;
  double most_cosine_;
  std::vector<Triangle> triangles_;
};
}  // namespace

TriangleMesh meshOf(const WeldLattice& lattice, const std::vector<double>& z, const WeldSurfaceParams& params)
{
  std::vector<Eigen::Vector3d> nodes(z.size());
  for (std::size_t i = 0; i < z.size(); ++i)
    nodes[i] = { lattice.x[i], lattice.y[i], z[i] };
  std::vector<Triangle> triangles = Triangulation(lattice, z, params.min_angle_deg * kPi / 180.0)();
  dropSmallPieces(nodes, params.min_piece_area, triangles);
  return connect(nodes, triangles);
}
}  // namespace weld
}  // namespace weld_profiler
