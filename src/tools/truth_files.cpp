#include "tools/truth_files.h"

#include <cstdio>
#include <fstream>

#include "tools/run_command.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/geometry/calibration_file.h"

namespace weld_profiler
{
namespace
{
void writeCentres(const SimulatedScan& scan, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  file << "frame,stamp,stage_m,cell,u_px,v_px,normal_rad,x_m,y_m,z_m,visible\n";
  for (int frame = 0; frame < scan.frameCount(); ++frame)
  {
    throwIfInterrupted();
    const Stamp stamp = scan.stamp(frame);
    constexpr Stamp kSecond = 1000000000;
    for (const TruthCentre& centre : scan.truth(frame))
    {
      char line[256];
      std::snprintf(line, sizeof line, "%d,%lld.%09lld,%.9f,%u,%.5f,%.5f,%.7f,%.9f,%.9f,%.9f,%d\n", frame,
                    static_cast<long long>(stamp / kSecond), static_cast<long long>(stamp % kSecond),
                    scan.stagePosition(stamp), static_cast<unsigned>(centre.cell), centre.u, centre.v,
                    centre.normal_angle, centre.x, centre.y, centre.z, centre.visible ? 1 : 0);
      file << line;
    }
  }
  file.close();
  if (!file)
    throw InputError(path + ": cannot be written (is the disk full?)");
}
}  // namespace

void writeTruthFiles(const SimulatedScan& scan, const SceneParams& scene, const std::string& directory)
{
  writeCentres(scan, directory + "/centres.csv");
  saveScene(scene, directory + "/scene.yaml");
  saveCalibration(scan.calibration(), directory + "/calibration.yaml");
}
}  // namespace weld_profiler
