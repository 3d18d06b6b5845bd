#include "weld_profiler/weld/mesh_ply.h"

#include <cstdint>
#include <cstring>
#include <limits>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
void append(std::string& bytes, std::uint32_t value)
{
  for (int shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<char>((value >> shift) & 0xFFU));
}

void append(std::string& bytes, const Eigen::Vector3f& vector)
{
  for (int i = 0; i < 3; ++i)
  {
    std::uint32_t bits = 0;
    const float value = vector(i);
    std::memcpy(&bits, &value, sizeof bits);
    append(bytes, bits);
  }
}

void requireSound(const TriangleMesh& mesh, const std::vector<std::string>& comments)
{
  if (mesh.normals.size() != mesh.vertices.size())
    throw PreconditionError("a mesh of " + std::to_string(mesh.vertices.size()) + " vertices has " +
                            std::to_string(mesh.normals.size()) + " normals, must be one a vertex");
  if (mesh.vertices.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw PreconditionError("a mesh of " + std::to_string(mesh.vertices.size()) +
                            " vertices is too large for PLY's int");
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= mesh.vertices.size())
        throw PreconditionError("a triangle names vertex " + std::to_string(corner) + ", but the mesh has " +
                                std::to_string(mesh.vertices.size()));
  for (const std::string& comment : comments)
    if (comment.find_first_of("\r\n") != std::string::npos)
      throw PreconditionError("a comment of a PLY file must be one line: '" + comment + "'");
}
}  // namespace

void writePly(const TriangleMesh& mesh, std::ostream& out, const std::vector<std::string>& comments)
{
  requireSound(mesh, comments);
  std::string bytes = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : comments)
    bytes += "comment " + comment + "\n";
  bytes += "element vertex " + std::to_string(mesh.vertices.size()) + "\n";
  for (const char* name : { "x", "y", "z", "nx", "ny", "nz" })
    bytes += std::string("property float ") + name + "\n";
  bytes += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  bytes += "property list uchar int vertex_indices\nend_header\n";
  constexpr std::size_t kVertexBytes = 24, kFaceBytes = 13;
  bytes.reserve(bytes.size() + kVertexBytes * mesh.vertices.size() + kFaceBytes * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
  {
    append(bytes, mesh.vertices[i]);
    append(bytes, mesh.normals[i]);
  }
  for (const auto& triangle : mesh.triangles)
  {
    bytes.push_back(3);
    for (const std::uint32_t corner : triangle)
      append(bytes, corner);
  }
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}
}  // namespace weld_profiler
