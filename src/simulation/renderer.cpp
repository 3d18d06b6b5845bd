#include "simulation/renderer.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kTravelPerMoment = 8e-6;  // a fifth of a pixel of the default rig [m]
constexpr int kFewestMoments = 3;
constexpr int kMostMoments = 24;
constexpr double kBandSigmas = 4.5;

struct RowRange
{
  int first = 0, last = 0;
};

/// Rows across that the lines reach.
RowRange rowsOf(const std::vector<LitLine>& lines, double lens_sigma, int across_pixels)
{
  double low = across_pixels;
  double high = -1.0;
  for (const LitLine& line : lines)
    for (const LitPoint& point : line)
    {
      const double reach = kBandSigmas * std::hypot(point.sheet_sigma, lens_sigma) + 1.0;
      low = std::min(low, point.pixel.across - reach);
      high = std::max(high, point.pixel.across + reach);
    }
  RowRange rows;
  rows.first = static_cast<int>(std::max(0.0, std::floor(low)));
  rows.last = static_cast<int>(std::min(static_cast<double>(across_pixels), std::ceil(high) + 1.0));
  if (rows.last <= rows.first)
    rows = RowRange{ 0, 0 };
  return rows;
}
}  // namespace

World::World(const SceneParams& params)
  : scene(params),
    motion(params),
    rig(params, motion),
    surface(params, motion.lowest() - params.part_start,
            std::abs(motion.position(motion.duration()) - motion.position(0.0))),
    shader(params, surface, rig, rig.pose(0.5 * motion.duration())),
    speckle(params, shader.alongScale(), shader.acrossScale()),
    sensor(params, rig.camera().width(), rig.camera().height())
{
}

std::vector<double> World::moments(int frame) const
{
  const double middle = frameTime(frame);
  if (!scene.motion_blur || scene.exposure <= 0.0)
    return { middle };
  const double travel = std::abs(motion.position(middle + 0.5 * scene.exposure) -
                                 motion.position(middle - 0.5 * scene.exposure));
  const int count =
      std::min(kMostMoments, std::max(kFewestMoments, static_cast<int>(std::ceil(travel / kTravelPerMoment))));
  std::vector<double> result;
  for (int i = 0; i < count; ++i)
    result.push_back(middle + scene.exposure * ((i + 0.5) / count - 0.5));
  return result;
}

void renderFrame(const World& world, int frame, std::vector<std::uint8_t>& pixels)
{
  const std::vector<double> moments = world.moments(frame);
  std::vector<LitLine> lines;
  int cells = 0;
  int across_pixels = 0;
  for (const double moment : moments)
  {
    const SheetCut cut = world.cut(moment);
    lines.push_back(world.shader.shade(cut, cut.trace()));
    cells = cut.cells();
    across_pixels = cut.acrossPixels();
  }
  Brush brush;
  brush.gain = 1.0 / static_cast<double>(moments.size());
  brush.lens_sigma = world.shader.lensSigma();
  brush.speckle = &world.speckle;
  const RowRange rows = rowsOf(lines, brush.lens_sigma, across_pixels);
  StripeBand band(cells, rows.first, rows.last);
  for (const LitLine& line : lines)
    band.paint(line, brush);
  world.sensor.develop(band, world.rig.direction() == Direction::AlongV, {}, frame, pixels);
}
}  // namespace simulation
}  // namespace weld_profiler
