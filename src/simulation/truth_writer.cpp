#include "weld_profiler/simulation/truth_writer.h"

#include <cinttypes>
#include <cmath>
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

/// A number, or nothing for a NaN: not measured.
std::string cell(double value, int digits = 6)
{
  char text[32] = "";
  if (std::isfinite(value))
    std::snprintf(text, sizeof(text), "%.*f", digits, value);
  return text;
}

/// One line of weld.csv.
std::string sectionLine(const WeldTruth& w, int section)
{
  constexpr int kAngleDigits = 4;
  const auto mm = [](double metres) { return cell(metres * kMm) + ","; };
  const auto deg = [](double radians) { return cell(radians * kDegPerRad, kAngleDigits) + ","; };
  return std::to_string(w.row) + "," + mm(w.stage) + mm(w.width) + mm(w.reinforcement) + mm(w.toe_left[0]) +
         mm(w.toe_right[0]) + deg(w.toe_angle_left) + deg(w.toe_angle_right) + mm(w.undercut_left) +
         mm(w.undercut_right) + mm(w.misalignment) + mm(w.area * kMm) + "," + std::to_string(section) + "," + mm(w.s) +
         cell(w.yaw * kDegPerRad) + "," + mm(w.toe_left[1]) + mm(w.toe_left[2]) + mm(w.toe_right[1]) +
         mm(w.toe_right[2]) + mm(w.leg_left) + mm(w.leg_right) + mm(w.throat) + mm(w.height_left) + mm(w.height_right) +
         "chord," + deg(w.angle) + mm(w.incomplete_fill) + mm(w.convexity) + w.kind + "\n";
}

void writeWeld(const SimulatedScan& scan, const fs::path& path)
{
  TextFile file(path);
  file.out() << "row,stage_mm,width_mm,reinforcement_mm,toe_left_x_mm,toe_right_x_mm,toe_angle_left_deg,"
                "toe_angle_right_deg,undercut_left_mm,undercut_right_mm,misalignment_mm,area_mm2,verdict,section,s_mm,"
                "yaw_deg,toe_left_y_mm,toe_left_z_mm,toe_right_y_mm,toe_right_z_mm,leg_left_mm,leg_right_mm,throat_mm,"
                "height_left_mm,height_right_mm,reference,angle_deg,incomplete_fill_mm,convexity_mm,kind\n";
  int section = 0;
  for (const WeldTruth& truth : scan.weldSections())
    file.out() << sectionLine(truth, section++);
  file.close();
}

void writeSpots(const SimulatedScan& scan, const fs::path& path)
{
  TextFile file(path);
  file.out() << "kind,x_mm,y_mm,z_mm,s_mm,diameter_mm,height_mm\n";
  for (const TrueSpot& spot : scan.spots())
  {
    file.out() << (spot.kind == TrueSpot::Kind::Pore ? "pore" : "spatter");
    for (const double value :
         { spot.position[0], spot.position[1], spot.position[2], spot.s, spot.diameter, spot.height })
      file.out() << "," << cell(value * kMm);
    file.out() << "\n";
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
    writeSpots(scan, made / "spots.csv");
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
