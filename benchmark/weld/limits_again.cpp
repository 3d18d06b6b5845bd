#include "weld/limits_again.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
constexpr double kMm = 0.001;
constexpr double kDegree = 3.141592653589793 / 180.0;
constexpr double kThin = 3.0 * kMm;
constexpr double kNoImperfection = 0.05 * kMm;  // docs/verdict.md: "not permitted" counts from here
using Levels = std::array<double, 3>;           // B, C, D

/// Room to a limit: > 0 = within it.
struct Margin
{
  std::size_t level;
  double value, sigma;
};
using Margins = std::vector<Margin>;

void addHeight(const Judging& judging, const std::array<Deviation, kSizes>& sizes, Margins& margins)
{
  constexpr Levels kShare = { 0.10, 0.15, 0.25 };
  constexpr Levels kButtCap = { 5.0, 7.0, 10.0 }, kFilletCap = { 3.0, 4.0, 5.0 };
  Deviation height = sizes[Reinforcement];
  if (judging.kind == "butt" &&
      sizes[Misalignment].truth > kNoImperfection)  // of plates that are offset the largest height counts
  {
    for (const Size side : { HeightLeft, HeightRight })
    {
      if (sizes[side].truth > height.truth)
        height = sizes[side];
    }
  }
  const Levels& cap = judging.kind == "fillet" ? kFilletCap : kButtCap;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double limit = std::min(kMm + kShare[i] * sizes[Width].truth, cap[i] * kMm);
    margins.push_back({ i, limit - height.truth, std::hypot(height.sigma, kShare[i] * sizes[Width].sigma) });
  }
}

void addUndercut(double t, const Deviation& undercut, Margins& margins)
{
  const Levels thick = { std::min(0.05 * t, 0.5 * kMm), std::min(0.1 * t, 0.5 * kMm), std::min(0.2 * t, kMm) };
  const Levels thin = { kNoImperfection, 0.1 * t, 0.2 * t };
  for (std::size_t i = 0; i < 3; ++i)
    margins.push_back({ i, (t > kThin ? thick[i] : thin[i]) - undercut.truth, undercut.sigma });
}

void addMisalignment(double t, const Deviation& offset, Margins& margins)
{
  constexpr Levels kShare = { 0.10, 0.15, 0.25 }, kCap = { 3.0, 4.0, 5.0 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double limit = t > kThin ? std::min(kShare[i] * t, kCap[i] * kMm) : 0.2 * kMm + kShare[i] * t;
    margins.push_back({ i, limit - offset.truth, offset.sigma });
  }
}

void addToeAngle(const std::string& kind, const Deviation& angle, Margins& margins)
{
  const Levels least = kind == "fillet" ? Levels{ 110.0, 100.0, 90.0 } : Levels{ 150.0, 110.0, 90.0 };
  for (std::size_t i = 0; i < 3; ++i)
    margins.push_back({ i, angle.truth - least[i] * kDegree, angle.sigma });
}

Margins marginsOf(const Judging& judging, const std::array<Deviation, kSizes>& sizes)
{
  Margins margins;
  addHeight(judging, sizes, margins);
  addUndercut(judging.thickness, sizes[UndercutLeft], margins);
  addUndercut(judging.thickness, sizes[UndercutRight], margins);
  if (judging.kind == "butt")
    addMisalignment(judging.thickness, sizes[Misalignment], margins);
  if (judging.toe_angle && judging.kind != "bead_on_plate")
  {
    addToeAngle(judging.kind, sizes[ToeAngleLeft], margins);
    addToeAngle(judging.kind, sizes[ToeAngleRight], margins);
  }
  return margins;
}
}  // namespace

std::string trueVerdict(const Judging& judging, const std::array<Deviation, kSizes>& sizes)
{
  std::array<bool, 3> met = { true, true, true };
  for (const Margin& margin : marginsOf(judging, sizes))
    met[margin.level] = met[margin.level] && margin.value >= 0.0;
  const std::array<const char*, 3> names = { "B", "C", "D" };
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (met[i])
      return names[i];
  }
  return "fail";
}

double clearanceOf(const Judging& judging, const std::array<Deviation, kSizes>& sizes)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Margin& margin : marginsOf(judging, sizes))
  {
    const double clearance = std::abs(margin.value) / margin.sigma;
    if (std::isnan(clearance))
      return 0.0;
    least = std::min(least, clearance);
  }
  return least;
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
