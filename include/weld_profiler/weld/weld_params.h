#pragma once

#include <string>

namespace weld_profiler
{
/// Everything the measuring of a weld can be told. Immutable once a WeldMeasurer is built from it. SI.
struct WeldParams
{
  std::string kind = "auto";          ///< auto, butt, fillet, bead_on_plate
  std::string target = "flush";       ///< what grinding is to leave: flush (with the parents), rest (rest_height above)
  double rest_height = 2e-4;          ///< left standing normal to the toes' chord, with target rest [m], 0..0.01
  double section_step = 0.0;          ///< between sections along the path [m], 0..0.1; 0 = one a row
  double min_width = 1.5e-3;          ///< narrowest bead looked for [m]
  double max_width = 0.040;           ///< widest bead looked for [m]
  double min_height = 5e-5;           ///< lowest bead looked for [m]
  double parent_length = 0.012;       ///< of each parent beside the weld that its line is fitted to [m]
  double min_parent_length = 2e-3;    ///< a shorter piece of it counts as none [m]
  double flatness = 3e-5;             ///< by which a parent may leave a straight line [m]
  double undercut_reach = 2.5e-3;     ///< undercuts are looked for this far outside a toe [m]
  double face_length = 1.2e-3;        ///< of the face at a toe that is continued to the parent line [m]
  double edge_blur = 1.2e-4;          ///< nearer to a kink the profile is blurred by stripe and lens [m]
  double max_gap = 5e-4;              ///< longest break in a section that counts as seen [m]
  double max_bridge = 2e-3;           ///< longest stretch of a toe under spatter that is told from both sides [m]
  double max_width_sigma = 2.5e-4;    ///< a width less certain counts as not measured [m]
  double same_plate_offset = 2e-5;    ///< parents nearer than this to one plane are one plate: bead_on_plate [m]
  double same_plate_angle_deg = 0.2;  ///< and at less than this angle [deg]

  /// @throws ConfigError naming field, value and range.
  void validate() const;

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("kind", kind);
    v("target", target);
    v("rest_height", rest_height);
    v("section_step", section_step);
    v("min_width", min_width);
    v("max_width", max_width);
    v("min_height", min_height);
    v("parent_length", parent_length);
    v("min_parent_length", min_parent_length);
    v("flatness", flatness);
    v("undercut_reach", undercut_reach);
    v("face_length", face_length);
    v("edge_blur", edge_blur);
    v("max_gap", max_gap);
    v("max_bridge", max_bridge);
    v("max_width_sigma", max_width_sigma);
    v("same_plate_offset", same_plate_offset);
    v("same_plate_angle_deg", same_plate_angle_deg);
  }
};
}  // namespace weld_profiler
