#include "weld_profiler/ros/weld_markers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace weld_profiler
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kLine = 1.2e-4;  // of a drawn line [m]
constexpr double kText = 1.2e-3;  // height of a letter [m]
constexpr double kMillimetres = 1e3;
constexpr double kDegrees = 57.29577951308232;

struct Colour
{
  float r, g, b;
};

/// Told apart by brightness as well: green, yellow, orange, red, grey.
Colour colourOf(const std::string& verdict)
{
  if (verdict == "B")
    return { 0.1F, 0.75F, 0.3F };
  if (verdict == "C" || verdict == "D")
    return { 0.55F, 0.8F, 0.1F };
  if (verdict == "fail")
    return { 0.9F, 0.1F, 0.1F };
  if (verdict == "undecided")
    return { 1.0F, 0.65F, 0.0F };
  return { 0.6F, 0.6F, 0.6F };
}

Marker marker(const std_msgs::Header& header, const char* space, int id, int type)
{
  Marker one;
  one.header = header;
  one.ns = space;
  one.id = id;
  one.type = type;
  one.action = Marker::ADD;
  one.pose.orientation.w = 1.0;
  one.scale.x = kLine;
  one.color.a = 1.0F;
  return one;
}

void paint(Marker& one, const Colour& colour)
{
  one.color.r = colour.r;
  one.color.g = colour.g;
  one.color.b = colour.b;
}

geometry_msgs::Point pointOf(const SectionPoint& place)
{
  geometry_msgs::Point point;
  point.x = place.x.value;
  point.y = place.y.value;
  point.z = place.z.value;
  return point;
}

geometry_msgs::Point between(const geometry_msgs::Point& a, const geometry_msgs::Point& b, double share)
{
  geometry_msgs::Point point;
  point.x = a.x + share * (b.x - a.x);
  point.y = a.y + share * (b.y - a.y);
  point.z = a.z + share * (b.z - a.z);
  return point;
}

void addColour(Marker& one, const Colour& colour)
{
  std_msgs::ColorRGBA value;
  value.r = colour.r;
  value.g = colour.g;
  value.b = colour.b;
  value.a = 1.0F;
  one.colors.push_back(value);
}

Marker text(const std_msgs::Header& header, int id, const geometry_msgs::Point& at, const std::string& words)
{
  Marker one = marker(header, "text", id, Marker::TEXT_VIEW_FACING);
  one.scale.z = kText;
  one.pose.position = at;
  one.text = words;
  paint(one, { 1.0F, 1.0F, 1.0F });
  return one;
}

std::string line(const char* what, const Quantity& quantity, double scale, const char* unit)
{
  if (!quantity.measured())
    return "";
  char words[96];
  std::snprintf(words, sizeof(words), "%s %.2f +- %.2f %s   ", what, scale * quantity.value, scale * quantity.sigma,
                unit);
  return words;
}

bool drawable(const WeldSection& section)
{
  for (const Quantity* one : { &section.toe_left.x, &section.toe_left.y, &section.toe_left.z, &section.toe_right.x,
                               &section.toe_right.y, &section.toe_right.z })
    if (!std::isfinite(one->value))
      return false;
  return true;
}
}  // namespace

MarkerArray weldMarkers(const WeldEvaluation& evaluation, const std_msgs::Header& header)
{
  MarkerArray all;
  Marker clear = marker(header, "", 0, Marker::SPHERE);
  clear.action = Marker::DELETEALL;
  all.markers.push_back(clear);
  Marker left = marker(header, "toe_left", 0, Marker::LINE_STRIP);
  Marker right = marker(header, "toe_right", 0, Marker::LINE_STRIP);
  const std::vector<WeldSection>& sections = evaluation.result.sections;
  for (std::size_t i = 0; i < sections.size(); ++i)
  {
    if (!drawable(sections[i]))
      continue;
    const bool judged = i < evaluation.section_verdicts.size();
    const Colour colour = colourOf(judged ? evaluation.section_verdicts[i].verdict : "");
    left.points.push_back(pointOf(sections[i].toe_left));
    right.points.push_back(pointOf(sections[i].toe_right));
    addColour(left, colour);
    addColour(right, colour);
  }
  if (left.points.size() < 2)
    return all;
  left.scale.x = right.scale.x = 4.0 * kLine;
  Marker spots = marker(header, "spots", 0, Marker::SPHERE_LIST);
  spots.scale.x = spots.scale.y = spots.scale.z = 5.0 * kLine;
  paint(spots, { 0.2F, 0.5F, 1.0F });
  for (const WeldSpot& spot : evaluation.result.spots)
  {
    geometry_msgs::Point at;
    at.x = spot.x, at.y = spot.y, at.z = spot.z;
    spots.points.push_back(at);
  }
  geometry_msgs::Point above = between(left.points.front(), right.points.front(), 0.5);
  above.z += 4.0 * kText;
  const std::string unverified = evaluation.verdict.unverified ? " (limits not verified)" : "";
  const std::string verdict = evaluation.verdict.verdict.empty() ? "not judged" : evaluation.verdict.verdict;
  all.markers.push_back(left);
  all.markers.push_back(right);
  if (!spots.points.empty())
    all.markers.push_back(spots);
  all.markers.push_back(
      text(header, 0, above, std::string(name(evaluation.result.kind)) + ": " + verdict + unverified));
  return all;
}

MarkerArray sectionMarkers(const WeldSection& section, const std_msgs::Header& header)
{
  MarkerArray all;
  Marker clear = marker(header, "", 0, Marker::SPHERE);
  clear.action = Marker::DELETEALL;
  all.markers.push_back(clear);
  if (!section.hasBead() || !drawable(section))
    return all;
  const geometry_msgs::Point left = pointOf(section.toe_left);
  const geometry_msgs::Point right = pointOf(section.toe_right);
  Marker chord = marker(header, "section", 0, Marker::LINE_LIST);
  paint(chord, { 1.0F, 1.0F, 0.2F });
  const geometry_msgs::Point middle = between(left, right, 0.5);
  chord.points = { left, right };
  geometry_msgs::Point crest = middle;
  if (section.reinforcement.measured())
  {
    const double width = std::max(1e-9, std::hypot(right.x - left.x, right.y - left.y));
    const double rise = (right.z - left.z) / width;
    const double across = section.reinforcement.value / std::sqrt(1.0 + rise * rise);
    crest.z += across;
    crest.x -= across * rise * (right.x - left.x) / width;
    crest.y -= across * rise * (right.y - left.y) / width;
    chord.points.push_back(middle);
    chord.points.push_back(crest);
  }
  Marker toes = marker(header, "section", 1, Marker::SPHERE_LIST);
  toes.scale.x = toes.scale.y = toes.scale.z = 3.0 * kLine;
  paint(toes, { 1.0F, 0.3F, 0.1F });
  toes.points = { left, right };
  geometry_msgs::Point above = crest;
  above.z += 3.0 * kText;
  all.markers.push_back(chord);
  all.markers.push_back(toes);
  all.markers.push_back(text(header, 1, above,
                             line("b", section.width, kMillimetres, "mm") +
                                 line("h", section.reinforcement, kMillimetres, "mm") +
                                 line("toe left", section.toe_angle_left, kDegrees, "deg") +
                                 line("toe right", section.toe_angle_right, kDegrees, "deg")));
  return all;
}
}  // namespace weld_profiler
