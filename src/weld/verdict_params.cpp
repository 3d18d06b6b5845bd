#include "weld_profiler/weld/verdict_params.h"

#include <array>
#include <sstream>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
constexpr double kThickest = 1.0;  // [m]

void requireThickness(const char* name, const std::optional<double>& value)
{
  if (!value || (*value > 0.0 && *value <= kThickest))
    return;
  std::ostringstream text;
  text << name << " is " << *value << ", must be in (0, " << kThickest << "] m, or not given";
  throw ConfigError(text.str());
}
}  // namespace

void VerdictParams::validate() const
{
  requireThickness("thickness", thickness);
  requireThickness("nominal_thickness", nominal_thickness);
  requireOneOf("level", level, std::array<std::string, 4>{ { "B", "C", "D", "" } });
  requireRange("smallest_imperfection", smallest_imperfection, 0.0, 1e-3, "m");
  requireRange("min_length", min_length, 0.0, 0.1, "m");
  requireRange("min_measured_share", min_measured_share, 0.0, 1.0);
}
}  // namespace weld_profiler
