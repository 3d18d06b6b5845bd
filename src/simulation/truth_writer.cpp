#include "weld_profiler/simulation/truth_writer.h"

#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;

constexpr double kMm = 1000.0;
constexpr double kDegPerRad = 57.29577951308232;
constexpr double kMeshStep = 0.00025;  // of surface.ply [m]
constexpr int kMostMeshPoints = 2000;  // a side

/// A text file that notices when it could not be written to the end.
class TextFile
{
public:
  explicit TextFile(const fs::path& path) : path_(path), file_(path, std::ios::binary) {}

  std::ofstream& out() { return file_; }

  void close()
  {
    file_.close();
    if (!file_)
      throw InputError(path_.string() + ": cannot be written, check the folder, its permissions and the free space");
  }

private:
  fs::path path_;
  std::ofstream file_;
};

void writeCentres(const SimulatedScan& scan, const fs::path& path, const TruthProgress& progress)
{
  TextFile file(path);
  file.out() << "frame,stamp,stage_m,cell,u_px,v_px,normal_rad,x_m,y_m,z_m,visible\n";
  for (int frame = 0; frame < scan.frameCount(); ++frame)
  {
    const Stamp stamp = scan.stamp(frame);
    char head[96];
    std::snprintf(head, sizeof(head), "%d,%" PRId64 ".%09" PRId64 ",%.9f", frame, stamp / 1000000000,
                  stamp % 1000000000, scan.stagePosition(stamp));
    for (const TruthCentre& centre : scan.truth(frame))
    {
      char line[256];
      std::snprintf(line, sizeof(line), "%s,%u,%.6f,%.6f,%.9f,%.9f,%.9f,%.9f,%d\n", head, centre.cell, centre.u,
                    centre.v, centre.normal_angle, centre.x, centre.y, centre.z, centre.visible ? 1 : 0);
      file.out() << line;
    }
    if (progress)
      progress(frame + 1, scan.frameCount());
  }
  file.close();
}

void writeWeld(const SimulatedScan& scan, const fs::path& path)
{
  TextFile file(path);
  file.out() << "row,stage_mm,width_mm,reinforcement_mm,toe_left_x_mm,toe_right_x_mm,toe_angle_left_deg,"
                "toe_angle_right_deg,undercut_left_mm,undercut_right_mm,misalignment_mm,area_mm2,verdict,section,s_mm,"
                "yaw_deg,toe_left_y_mm,toe_left_z_mm,toe_right_y_mm,toe_right_z_mm,leg_left_mm,leg_right_mm,throat_mm,"
                "height_left_mm,height_right_mm,reference\n";
  int section = 0;
  for (const WeldTruth& w : scan.weldSections())
  {
    char line[512];
    std::snprintf(line, sizeof(line),
                  "%d,%.6f,%.6f,%.6f,%.6f,%.6f,%.4f,%.4f,%.6f,%.6f,%.6f,%.6f,,%d,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,,,,"
                  "%.6f,%.6f,chord\n",
                  w.row, w.stage * kMm, w.width * kMm, w.reinforcement * kMm, w.toe_left[0] * kMm, w.toe_right[0] * kMm,
                  w.toe_angle_left * kDegPerRad, w.toe_angle_right * kDegPerRad, w.undercut_left * kMm,
                  w.undercut_right * kMm, w.misalignment * kMm, w.area * kMm * kMm, section++, w.s * kMm,
                  w.yaw * kDegPerRad, w.toe_left[1] * kMm, w.toe_left[2] * kMm, w.toe_right[1] * kMm,
                  w.toe_right[2] * kMm, w.height_left * kMm, w.height_right * kMm);
    file.out() << line;
  }
  file.close();
}

template <class T>
void put(std::string& buffer, T value)
{
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  buffer.append(bytes, sizeof(T));
}

int meshPoints(double from, double to)
{
  return std::min(kMostMeshPoints, std::max(2, static_cast<int>((to - from) / kMeshStep) + 1));
}

void writeSurface(const SimulatedScan& scan, const fs::path& path)
{
  const std::array<double, 4> extent = scan.extent();
  const int columns = meshPoints(extent[0], extent[1]);
  const int rows = meshPoints(extent[2], extent[3]);
  std::string body;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
    {
      const double x = extent[0] + (extent[1] - extent[0]) * column / (columns - 1);
      const double y = extent[2] + (extent[3] - extent[2]) * row / (rows - 1);
      for (const double value : { x, y, scan.surfaceHeight(x, y) })
        put(body, static_cast<float>(value));
    }
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column)
    {
      const int corner = row * columns + column;  // triangles turn left seen from above: normals point to the sensor
      for (const auto& face : { std::array<int, 3>{ { corner, corner + 1, corner + columns } },
                                std::array<int, 3>{ { corner + 1, corner + columns + 1, corner + columns } } })
      {
        put(body, static_cast<std::uint8_t>(3));
        for (const int vertex : face)
          put(body, static_cast<std::int32_t>(vertex));
      }
    }
  TextFile file(path);
  file.out() << "ply\nformat binary_little_endian 1.0\ncomment true surface, cloud frame, metres\nelement vertex "
             << rows * columns << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
             << 2 * (rows - 1) * (columns - 1) << "\nproperty list uchar int vertex_indices\nend_header\n"
             << body;
  file.close();
}

void replace(const fs::path& made, const fs::path& directory)
{
  if (fs::exists(directory))
    fs::remove_all(directory);
  fs::rename(made, directory);
}
}  // namespace

void writeTruth(const SimulatedScan& scan, const std::string& directory, const TruthProgress& progress)
{
  const fs::path target(directory);
  if (fs::exists(target) && !fs::exists(target / "centres.csv"))
    throw InputError(directory + ": exists and holds no truth of a scan, remove it or choose another name");
  const fs::path made(directory + ".part");
  try
  {
    fs::remove_all(made);
    fs::create_directory(made);
    writeCentres(scan, made / "centres.csv", progress);
    writeSurface(scan, made / "surface.ply");
    writeWeld(scan, made / "weld.csv");
    saveScene(scan.scene(), (made / "scene.yaml").string());
    replace(made, target);
  }
  catch (const fs::filesystem_error& error)
  {
    std::error_code ignored;
    fs::remove_all(made, ignored);
    throw InputError(directory + ": cannot be written: " + error.code().message());
  }
  catch (const Error&)
  {
    std::error_code ignored;
    fs::remove_all(made, ignored);
    throw;
  }
}
}  // namespace weld_profiler
