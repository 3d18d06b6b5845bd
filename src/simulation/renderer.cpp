#include "simulation/renderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
constexpr double kMirrorSpread = 1.5;  // mirrored light is less sharp than the lens alone would make it

/// A line of light and how it is painted.
struct Stroke
{
  LitLine line;
  Brush brush;
};

struct RowRange
{
  int first = 0, last = 0;
};

/// Rows across that the strokes reach.
RowRange rowsOf(const std::vector<Stroke>& strokes, int across_pixels)
{
  double low = across_pixels;
  double high = -1.0;
  for (const Stroke& stroke : strokes)
    for (const LitPoint& point : stroke.line)
    {
      const double reach = kBandSigmas * std::hypot(point.sheet_sigma, stroke.brush.lens_sigma) + 1.0;
      low = std::min(low, point.pixel.across + stroke.brush.shift - reach);
      high = std::max(high, point.pixel.across + stroke.brush.shift + reach);
    }
  RowRange rows;
  rows.first = static_cast<int>(std::max(0.0, std::floor(low)));
  rows.last = static_cast<int>(std::min(static_cast<double>(across_pixels), std::ceil(high) + 1.0));
  if (rows.last <= rows.first)
    rows = RowRange{ 0, 0 };
  return rows;
}

/// What else the middle of the exposure throws on the sensor: mirrored light, the filter's ghost, the halo.
void addSideLights(const World& world, const SheetCut& cut, const std::vector<CutPoint>& points,
                   std::vector<Stroke>& strokes)
{
  const SceneLaser& laser = world.scene.laser;
  const LitLine line = world.shader.shade(cut, points);
  if (laser.interreflection > 0.0)
  {
    Stroke mirrored{ world.shader.mirror(cut, points), Brush() };
    mirrored.brush.gain = laser.interreflection;
    mirrored.brush.lens_sigma = kMirrorSpread * laser.lens_sigma_px;
    strokes.push_back(mirrored);
  }
  if (laser.ghost > 0.0)
  {
    Stroke ghost{ line, Brush() };
    ghost.brush.gain = laser.ghost;
    ghost.brush.shift = laser.ghost_offset_px;
    ghost.brush.lens_sigma = laser.lens_sigma_px;
    strokes.push_back(ghost);
  }
  if (laser.glow > 0.0)
  {
    Stroke halo{ line, Brush() };
    halo.brush.gain = laser.glow * laser.glow_sigma_px / laser.sigma_px;  // the halo's peak is `glow` of the stripe's
    halo.brush.lens_sigma = laser.glow_sigma_px;
    strokes.push_back(halo);
  }
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
    light(params, rig.camera().width(), rig.camera().height()),
    sensor(params, rig.camera().width(), rig.camera().height())
{
}

std::vector<double> World::moments(int frame) const
{
  const double middle = frameTime(frame);
  if (!scene.motion_blur || scene.exposure <= 0.0)
    return { middle };
  const double travel =
      std::abs(motion.position(middle + 0.5 * scene.exposure) - motion.position(middle - 0.5 * scene.exposure));
  const int count =
      std::min(kMostMoments, std::max(kFewestMoments, static_cast<int>(std::ceil(travel / kTravelPerMoment))));
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    result.push_back(middle + scene.exposure * ((i + 0.5) / count - 0.5));
  return result;
}

void renderFrame(const World& world, int frame, std::vector<std::uint8_t>& pixels)
{
  const std::vector<double> moments = world.moments(frame);
  std::vector<Stroke> strokes;
  for (const double moment : moments)
  {
    const SheetCut cut = world.cut(moment);
    Stroke stroke{ world.shader.shade(cut, cut.trace()), Brush() };
    stroke.brush.gain = 1.0 / static_cast<double>(moments.size());
    stroke.brush.lens_sigma = world.scene.laser.lens_sigma_px;
    stroke.brush.speckle = &world.speckle;
    strokes.push_back(std::move(stroke));
  }
  const SheetCut middle = world.cut(world.frameTime(frame));
  const SceneLaser& laser = world.scene.laser;
  if (laser.interreflection > 0.0 || laser.ghost > 0.0 || laser.glow > 0.0)
    addSideLights(world, middle, middle.trace(), strokes);
  const RowRange rows = rowsOf(strokes, middle.acrossPixels());
  StripeBand band(middle.cells(), rows.first, rows.last);
  for (const Stroke& stroke : strokes)
    band.paint(stroke.line, stroke.brush);
  world.sensor.develop(band, world.rig.direction() == Direction::AlongV, world.light.field(frame), frame, pixels);
}
}  // namespace simulation
}  // namespace weld_profiler
