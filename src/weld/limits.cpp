#include "weld_profiler/weld/limits.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace
{
constexpr double kThicknessStep = 1e-9;  // thicknesses closer than this are the same [m]
constexpr double kNearCap = 2.0;         // sigmas of the dimension

Quantity dimensionOf(char symbol, const LimitDimensions& dimensions)
{
  const auto exact = [](const std::optional<double>& value) { return value ? Quantity{ *value, 0.0 } : Quantity{}; };
  switch (symbol)
  {
    case 'b':
      return dimensions.b;
    case 'a':
      return dimensions.a;
    case 't':
      return exact(dimensions.t);
    case 's':
      return exact(dimensions.s);
    default:
      return Quantity{ 0.0, 0.0 };
  }
}

bool inRange(const LimitEntry& entry, const std::optional<double>& t)
{
  if (!t)
    return entry.any_thickness;
  return *t > entry.above + kThicknessStep && *t >= entry.from - kThicknessStep && *t <= entry.to + kThicknessStep;
}

bool isOf(const LimitEntry& entry, WeldKind kind)
{
  return std::find(entry.kinds.begin(), entry.kinds.end(), kind) != entry.kinds.end();
}
}  // namespace

const char* name(QualityLevel level)
{
  constexpr std::array<const char*, 3> kNames = { { "B", "C", "D" } };
  return kNames[static_cast<std::size_t>(level)];
}

const std::vector<Imperfection>& imperfections()
{
  static const std::vector<Imperfection> all = { Imperfection::ExcessWeldMetal, Imperfection::Convexity,
                                                 Imperfection::Undercut,        Imperfection::ToeAngle,
                                                 Imperfection::Misalignment,    Imperfection::IncompleteFill,
                                                 Imperfection::SurfacePore };
  return all;
}

const char* name(Imperfection imperfection)
{
  constexpr std::array<const char*, 7> kNames = { { "excess_weld_metal", "convexity", "undercut", "toe_angle",
                                                    "misalignment", "incomplete_fill", "surface_pore" } };
  return kNames[static_cast<std::size_t>(imperfection)];
}

int isoNumber(Imperfection imperfection)
{
  constexpr std::array<int, 7> kNumbers = { { 502, 503, 5011, 505, 507, 511, 2017 } };
  return kNumbers[static_cast<std::size_t>(imperfection)];
}

const char* name(LevelLimit::Rule rule)
{
  constexpr std::array<const char*, 4> kNames = { { "max", "short", "not_permitted", "permitted" } };
  return kNames[static_cast<std::size_t>(rule)];
}

Quantity evaluate(const LevelLimit& limit, const LimitDimensions& dimensions)
{
  const Quantity dimension = dimensionOf(limit.of, dimensions);
  if (!dimension.measured())
    return {};
  const double free = limit.base + limit.factor * dimension.value;
  const double slope_sigma = std::abs(limit.factor) * dimension.sigma;
  return { std::min(free, limit.cap), free - kNearCap * slope_sigma < limit.cap ? slope_sigma : 0.0 };
}

bool LimitEntry::needs(char dimension) const
{
  return std::any_of(levels.begin(), levels.end(), [dimension](const LevelLimit& l) { return l.of == dimension; });
}

const LimitEntry* Limits::find(Imperfection imperfection, WeldKind kind, std::optional<double> t,
                               std::optional<double> s) const
{
  if (t && !(*t >= least_thickness_ - kThicknessStep))
    return nullptr;
  for (const LimitEntry& entry : entries_)
  {
    if (entry.imperfection == imperfection && isOf(entry, kind) && inRange(entry, t) && (t || !entry.needs('t')) &&
        (s || !entry.needs('s')))
      return &entry;
  }
  return nullptr;
}

bool Limits::lacksThickness(Imperfection imperfection, WeldKind kind, std::optional<double> s) const
{
  return find(imperfection, kind, std::nullopt, s) == nullptr &&
         std::any_of(entries_.begin(), entries_.end(),
                     [=](const LimitEntry& entry)
                     {
                       return entry.imperfection == imperfection && isOf(entry, kind) &&
                              std::any_of(entry.levels.begin(), entry.levels.end(),
                                          [](const LevelLimit& limit)
                                          { return limit.rule != LevelLimit::Rule::Permitted; });
                     });
}
}  // namespace weld_profiler
