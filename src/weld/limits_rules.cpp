#include "limits_rules.h"

#include <algorithm>
#include <cmath>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
std::string nameOf(const std::string& origin, std::size_t index)
{
  return origin + ": entries[" + std::to_string(index) + "]";
}

bool has(const LimitEntry& entry, WeldKind kind)
{
  return std::find(entry.kinds.begin(), entry.kinds.end(), kind) != entry.kinds.end();
}

bool overlap(const LimitEntry& a, const LimitEntry& b)
{
  if (a.imperfection != b.imperfection ||
      std::none_of(a.kinds.begin(), a.kinds.end(), [&b](WeldKind kind) { return has(b, kind); }))
    return false;
  const auto starts_after = [](const LimitEntry& later, const LimitEntry& first)
  { return later.above >= first.to || later.from > first.to; };
  return !starts_after(a, b) && !starts_after(b, a);
}

/// How much a level allows, the larger the more, with all dimensions at x.
double allowance(const LimitEntry& entry, QualityLevel level, double x)
{
  const LevelLimit& limit = entry.at(level);
  if (limit.rule == LevelLimit::Rule::Permitted)
    return std::numeric_limits<double>::infinity();
  if (limit.rule == LevelLimit::Rule::NotPermitted)
    return 0.0;
  const double value = std::min(limit.base + (limit.of != 0 ? limit.factor * x : 0.0), limit.cap);
  return entry.least ? -value : value;
}

/// An imperfection of any length that the better level takes, and the next only if it is short.
void requireOrderOfLengths(const LimitEntry& entry, const std::string& where)
{
  for (const auto& [better, next] :
       { std::make_pair(QualityLevel::B, QualityLevel::C), std::make_pair(QualityLevel::C, QualityLevel::D) })
  {
    const LevelLimit& limit = entry.at(better);
    const bool allows_nothing = limit.base == 0.0 && limit.factor == 0.0;
    if (limit.rule == LevelLimit::Rule::Limit && !allows_nothing && entry.at(next).rule == LevelLimit::Rule::Short)
      throw ConfigError(where + "." + name(better) + " allows any length, " + name(next) +
                        " only short ones, must not allow more: give " + name(better) +
                        " `short: true`, or take it from " + name(next));
  }
}

void requireOrder(const LimitEntry& entry, const std::string& where)
{
  const bool of_thickness = entry.needs('t');
  const double least = of_thickness ? std::max(entry.above, entry.from) : 0.0;
  const double most = of_thickness ? std::min(entry.to, 1.0) : 1.0;
  constexpr int kSteps = 200;
  for (int i = 0; i <= kSteps; ++i)
  {
    // finer where formulas meet their caps
    const double x = least + (most - least) * std::pow(static_cast<double>(i) / kSteps, 3.0);
    for (const auto& pair :
         { std::make_pair(QualityLevel::B, QualityLevel::C), std::make_pair(QualityLevel::C, QualityLevel::D) })
      if (allowance(entry, pair.first, x) > allowance(entry, pair.second, x) + 1e-12)
        throw ConfigError(where + "." + name(pair.first) + " allows more than " + name(pair.second) + " at " +
                          std::to_string(x * 1e3) + " mm, must allow less: check base, factor and cap");
  }
}

void requireKind(const LimitEntry& entry, const std::string& where)
{
  const bool fillet = has(entry, WeldKind::Fillet);
  const bool other = has(entry, WeldKind::Butt) || has(entry, WeldKind::BeadOnPlate);
  if (entry.imperfection == Imperfection::ExcessWeldMetal && fillet)
    throw ConfigError(where + ".kinds has fillet, must not: 502 is of butt welds, a fillet weld has 503");
  if ((entry.imperfection == Imperfection::Misalignment || entry.imperfection == Imperfection::IncompleteFill) &&
      fillet)
    throw ConfigError(where + ".kinds has fillet, must not: " + std::to_string(isoNumber(entry.imperfection)) +
                      " is not measured on fillet welds");
  if (entry.imperfection == Imperfection::Convexity && other)
    throw ConfigError(where + ".kinds has butt or bead_on_plate, must not: 503 is of fillet welds, these have 502");
}
}  // namespace

void requireConsistent(const std::vector<LimitEntry>& entries, const std::string& origin)
{
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    requireKind(entries[i], nameOf(origin, i));
    requireOrder(entries[i], nameOf(origin, i));
    requireOrderOfLengths(entries[i], nameOf(origin, i));
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(entries[i], entries[j]))
        throw ConfigError(nameOf(origin, i) + " is for the same welds as entries[" + std::to_string(j) +
                          "], remove one of them or change kinds or thickness");
  }
}
}  // namespace weld_profiler
