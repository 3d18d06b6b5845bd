#pragma once

#include <optional>
#include <string>

namespace weld_profiler
{
/// How a weld is judged.
struct VerdictParams
{
  std::optional<double> thickness;          ///< of the plate, t [m], > 0..1; none = not given
  std::optional<double> nominal_thickness;  ///< of a butt weld, s [m], > 0..1; none = the plate's
  std::string level;                        ///< asked for: B, C or D; empty = none
  bool judge_toe_angle = false;             ///< no. 505 decides too
  std::string limits_file;                  ///< table of limits; empty = the shipped one
  double smallest_imperfection = 5e-5;      ///< what "not permitted" and lengths count from [m], 0..0.001
  double min_length = 1e-3;                 ///< sizes are running medians over this length of weld [m], 0..0.1
  double min_measured_share = 0.9;          ///< of the weld's length, for a pass, 0..1

  /// @throws ConfigError naming field, value and range.
  void validate() const;

  /// Offers the fields to a visitor (core/yaml_fields.h). In a file, 0 stands for a thickness that is not given.
  template <class Visitor>
  void visit(Visitor&& v)
  {
    visitThickness(v, "thickness", thickness);
    visitThickness(v, "nominal_thickness", nominal_thickness);
    v("level", level);
    v("judge_toe_angle", judge_toe_angle);
    v("limits_file", limits_file);
    v("smallest_imperfection", smallest_imperfection);
    v("min_length", min_length);
    v("min_measured_share", min_measured_share);
  }

private:
  template <class Visitor>
  static void visitThickness(Visitor& v, const char* name, std::optional<double>& thickness)
  {
    double value = thickness.value_or(0.0);
    v(name, value);
    if (value == 0.0)
      thickness.reset();
    else
      thickness = value;  // a NaN too: validate() refuses it
  }
};
}  // namespace weld_profiler
