#include "weld_profiler/ros/weld_markers.h"

#include <array>
#include <cmath>

#include "marker_shapes.h"

namespace weld_profiler
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kLift = 4e-4;     // lines lie over the points, not among them [m]
constexpr double kToeLine = 8e-4;  // [m]
constexpr double kSpot = 8e-4;     // [m]
constexpr double kLine = 1.3;      // from line to line, in letters' heights
constexpr double kSmall = 0.55;    // letters of what stands below

/// Told apart by brightness as well. @param part  of the limits alone were judged: no level is met for that.
Colour colourOf(const std::string& verdict, bool part)
{
  if (verdict == "B" && !part)
    return { 0.1F, 0.6F, 0.2F };
  if ((verdict == "C" || verdict == "D") && !part)
    return { 0.7F, 0.95F, 0.3F };
  if (verdict == "fail")
    return { 0.6F, 0.0F, 0.0F };
  if (verdict == "undecided")
    return { 1.0F, 0.75F, 0.2F };
  return { 0.8F, 0.8F, 0.8F };
}

Eigen::Vector3d placeOf(const SectionPoint& point)
{
  return { point.x.value, point.y.value, point.z.value + kLift };
}

/// A toe line: from section to section where both have the toe.
Marker toeLine(const WeldEvaluation& evaluation, SectionPoint WeldSection::*toe, const std_msgs::Header& header,
               const char* space)
{
  Marker line = marker(header, space, 0, Marker::LINE_LIST);
  line.scale.x = kToeLine;
  const std::vector<WeldSection>& sections = evaluation.result.sections;
  const bool part = !evaluation.verdict.lacks_thickness.empty();
  for (std::size_t i = 1; i < sections.size(); ++i)
  {
    const Eigen::Vector3d before = placeOf(sections[i - 1].*toe), here = placeOf(sections[i].*toe);
    if (!before.allFinite() || !here.allFinite())
      continue;
    const bool judged = i < evaluation.section_verdicts.size();
    Marker colour;
    paint(colour, colourOf(judged ? evaluation.section_verdicts[i].verdict : "", part));
    for (const Eigen::Vector3d& end : { before, here })
    {
      line.points.push_back(pointOf(end));
      line.colors.push_back(colour.color);
    }
  }
  return line;
}

Marker spotsOf(const WeldResult& result, const std_msgs::Header& header)
{
  Marker spots = marker(header, "spots", 0, Marker::SPHERE_LIST);
  spots.scale.x = spots.scale.y = spots.scale.z = kSpot;
  paint(spots, { 0.2F, 0.5F, 1.0F });
  for (const WeldSpot& spot : result.spots)
    spots.points.push_back(pointOf({ spot.x, spot.y, spot.z + kLift }));
  return spots;
}

/// Kind and verdict, above the drawing of the middle section, and below them what was not judged: a marker a line, for
/// rviz sets lines of one marker far apart.
std::vector<Marker> verdictTexts(const WeldEvaluation& evaluation, const WeldSection& middle,
                                 const std_msgs::Header& header)
{
  const WeldVerdict& verdict = evaluation.verdict;
  Eigen::Vector3d above = 0.5 * (placeOf(middle.toe_left) + placeOf(middle.toe_right));
  above.z() += marker_size::kAbove + 0.6 * marker_size::kDrawing;
  std::vector<Marker> lines = { text(header, 0, above,
                                     std::string(name(evaluation.result.kind)) + ": " + verdict.headline() +
                                         (verdict.unverified ? " (limits not verified)" : "")) };
  if (verdict.lacks_thickness.empty())
    return lines;
  lines.front().pose.position.z += kLine * marker_size::kText;
  lines.push_back(text(header, 1, above, verdict.lacking()));
  lines.back().scale.z = kSmall * marker_size::kText;
  return lines;
}
}  // namespace

const WeldSection* middleSection(const WeldResult& result)
{
  const WeldSection* found = nullptr;
  if (result.sections.empty())
    return found;
  const double middle = 0.5 * (result.sections.front().s + result.sections.back().s);
  for (const WeldSection& section : result.sections)
    if (section.hasBead() && (found == nullptr || std::abs(section.s - middle) < std::abs(found->s - middle)))
      found = &section;
  return found;
}

MarkerArray weldMarkers(const WeldEvaluation& evaluation, const std_msgs::Header& header)
{
  MarkerArray all;
  all.markers.push_back(clearing(header));
  const WeldSection* middle = evaluation.result.hasWeld() ? middleSection(evaluation.result) : nullptr;
  if (middle == nullptr)
    return all;
  for (Marker& drawn : std::array<Marker, 3>{ toeLine(evaluation, &WeldSection::toe_left, header, "toe_left"),
                                              toeLine(evaluation, &WeldSection::toe_right, header, "toe_right"),
                                              spotsOf(evaluation.result, header) })
    if (!drawn.points.empty())
      all.markers.push_back(drawn);
  for (const Marker& line : verdictTexts(evaluation, *middle, header))
    all.markers.push_back(line);
  return all;
}
}  // namespace weld_profiler
