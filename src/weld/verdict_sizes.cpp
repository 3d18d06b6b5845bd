#include "verdict_sizes.h"

namespace weld_profiler
{
namespace
{
constexpr double kCertain = 2.0;    // sigmas
constexpr double kNoOffset = 5e-5;  // a smaller one is none: what is not permitted counts from here, too [m]
}  // namespace

Quantity judgedHeight(const WeldSection& section)
{
  Quantity height = section.reinforcement;
  const Quantity& misalignment = section.misalignment;
  if (!height.measured() || !misalignment.measured() ||
      !(misalignment.value - kNoOffset > kCertain * misalignment.sigma))
    return height;
  for (const Quantity& candidate : { section.height_left, section.height_right })
  {
    if (candidate.measured() && candidate.value > height.value)
      height = candidate;
  }
  return height;
}

std::vector<ImperfectionSize> sizesOf(WeldKind kind, const WeldSection& section)
{
  if (kind == WeldKind::None)
    return {};
  std::vector<ImperfectionSize> sizes;
  if (kind == WeldKind::Fillet)
    sizes.push_back({ Imperfection::Convexity, "", section.reinforcement });
  else
    sizes.push_back({ Imperfection::ExcessWeldMetal, "", judgedHeight(section) });
  sizes.push_back({ Imperfection::Undercut, "left", section.undercut_left });
  sizes.push_back({ Imperfection::Undercut, "right", section.undercut_right });
  sizes.push_back({ Imperfection::ToeAngle, "left", section.toe_angle_left });
  sizes.push_back({ Imperfection::ToeAngle, "right", section.toe_angle_right });
  if (kind != WeldKind::Fillet)
  {
    sizes.push_back({ Imperfection::Misalignment, "", section.misalignment });
    sizes.push_back({ Imperfection::IncompleteFill, "", section.incomplete_fill });
  }
  return sizes;
}

bool decidesSections(Imperfection imperfection, bool judge_toe_angle)
{
  return imperfection != Imperfection::IncompleteFill && imperfection != Imperfection::SurfacePore &&
         (imperfection != Imperfection::ToeAngle || judge_toe_angle);
}
}  // namespace weld_profiler
