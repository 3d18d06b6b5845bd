#include "kinds.h"

#include <algorithm>
#include <cmath>

#include "weld_profiler/stripe/stripe_methods.h"

namespace weld_profiler
{
namespace paper_tables
{
namespace
{
constexpr int kFramesAround = 2;
constexpr double kHessianVariance = 3.0;  // the paper, 3.1: of the Gaussian of the Hessian
constexpr double kGrayThreshold = 11.0;   // likewise

KindFrame renderFrame(const SimulatedScan& scan, int index)
{
  KindFrame frame;
  scan.render(index, frame.pixels);
  frame.image = RawImage{ frame.pixels.data(), scan.width(), scan.height(), scan.step(), scan.encoding() };
  frame.truth = scan.truth(index);
  frame.truth.erase(std::remove_if(frame.truth.begin(), frame.truth.end(), [](const auto& t) { return !t.visible; }),
                    frame.truth.end());
  return frame;
}
}  // namespace

std::vector<Kind> renderKinds(const std::string& scene_path)
{
  const SceneParams scene = loadScene(scene_path);
  const SimulatedScan scan(scene);
  const double end = scene.weld.start + scene.weld.length;
  // On the flat plate half-way to the weld; half-way up and down its ends; in its middle. [m along the part]
  const std::pair<const char*, double> places[] = { { "flat", scene.part_start + 0.5 * scene.weld.start },
                                                    { "start", scene.weld.start + 0.5 * scene.weld.end_length },
                                                    { "middle", 0.5 * (scene.weld.start + end) },
                                                    { "end", end - 0.5 * scene.weld.end_length } };
  std::vector<Kind> kinds;
  for (const auto& [name, place] : places)
  {
    const int middle =
        static_cast<int>(std::lround((place - scene.part_start) / std::abs(scene.speed) * scene.frame_rate));
    Kind kind;
    kind.name = name;
    for (int i = middle - kFramesAround; i <= middle + kFramesAround; ++i)
      kind.frames.push_back(renderFrame(scan, i));
    kinds.push_back(std::move(kind));
  }
  return kinds;
}

std::vector<Entry> entries()
{
  StripeParams params;
  params.direction = "u";
  params.hessian_sigma_px = std::sqrt(kHessianVariance);
  params.min_peak_counts = kGrayThreshold;
  std::vector<Entry> result;
  for (const std::string& method : stripeMethods())
  {
    params.method = method;
    result.push_back({ "`" + method + "`", params });
  }
  params.method = "svd";
  params.taylor = "literal";
  params.derivatives = "sobel";
  result.push_back({ "`svd` to the letter", params });
  return result;
}
}  // namespace paper_tables
}  // namespace weld_profiler
