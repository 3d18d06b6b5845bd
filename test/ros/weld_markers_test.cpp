#include "weld_profiler/ros/weld_markers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "weld/ideal_scan.h"

namespace weld_profiler
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

const Marker* find(const MarkerArray& array, const std::string& space, int type)
{
  for (const Marker& marker : array.markers)
    if (marker.ns == space && marker.type == type)
      return &marker;
  return nullptr;
}

bool says(const MarkerArray& array, const std::string& words)
{
  for (const Marker& marker : array.markers)
    if (marker.type == Marker::TEXT_VIEW_FACING && marker.text.find(words) != std::string::npos)
      return true;
  return false;
}

/// First of all a deletion; then nothing that rviz would refuse, or draw over another of the same name.
void expectDrawable(const MarkerArray& array)
{
  ASSERT_FALSE(array.markers.empty());
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
  std::set<std::pair<std::string, int>> names;
  for (std::size_t i = 1; i < array.markers.size(); ++i)
  {
    const Marker& marker = array.markers[i];
    EXPECT_TRUE(names.emplace(marker.ns, marker.id).second) << marker.ns << " " << marker.id;
    EXPECT_EQ(marker.header.frame_id, "scan");
    EXPECT_GT(marker.color.a, 0.0F);
    EXPECT_TRUE(std::isfinite(marker.pose.position.x + marker.pose.position.y + marker.pose.position.z));
    for (const geometry_msgs::Point& point : marker.points)
      ASSERT_TRUE(std::isfinite(point.x + point.y + point.z)) << marker.ns;
    EXPECT_TRUE(marker.type != Marker::LINE_LIST || marker.points.size() % 2 == 0);
    EXPECT_TRUE(marker.colors.empty() || marker.colors.size() == marker.points.size());
  }
}

std_msgs::Header header()
{
  std_msgs::Header made;
  made.frame_id = "scan";
  return made;
}

struct Measured
{
  explicit Measured(const std::function<double(double, double)>& surface, int rows = 60, double thickness = 0.008)
  {
    IdealScanner scanner;
    scanner.rows = rows;
    scan = scanner(surface);
    WeldSettings settings;
    if (thickness > 0.0)
      settings.judging.thickness = thickness;
    evaluation = WeldEvaluator(settings).evaluate(scan);
  }
  Scan scan;
  WeldEvaluation evaluation;
};
}  // namespace

TEST(WeldMarkers, ShowToesOverTheSurfaceAndTheVerdict)
{
  const Measured weld((IdealWeld()));
  const MarkerArray drawn = weldMarkers(weld.evaluation, header());
  expectDrawable(drawn);
  for (const char* side : { "toe_left", "toe_right" })
  {
    const Marker* line = find(drawn, side, Marker::LINE_LIST);
    ASSERT_NE(line, nullptr) << side;
    EXPECT_GE(line->points.size(), 2U * 55U);
    for (const geometry_msgs::Point& point : line->points)
    {
      EXPECT_NEAR(std::abs(point.x), 0.004, 1e-4);
      EXPECT_GT(point.z, 2e-4) << "among the points it would not be seen";
    }
  }
  EXPECT_TRUE(says(drawn, "bead_on_plate: B (limits not verified)"));
}

TEST(WeldMarkers, SayWithoutAThicknessThatNotAllWasJudgedAndShowNoLevel)
{
  const auto colourOf = [](const MarkerArray& drawn)
  { return find(drawn, "toe_left", Marker::LINE_LIST)->colors.at(50); };
  const Measured whole((IdealWeld())), part(IdealWeld(), 60, 0.0);
  const MarkerArray drawn = weldMarkers(part.evaluation, header());
  expectDrawable(drawn);
  EXPECT_TRUE(says(drawn, "bead_on_plate: not fully judged, B by what was judged (limits not verified)"));
  EXPECT_TRUE(says(drawn, "no plate thickness given, not judged: undercut"));
  EXPECT_FALSE(says(drawn, "\n")) << "rviz sets lines of one marker far apart";
  EXPECT_EQ(colourOf(drawn).r, colourOf(drawn).g) << "grey: not judged";
  const MarkerArray judged = weldMarkers(whole.evaluation, header());
  EXPECT_GT(colourOf(judged).g, 2.0F * colourOf(judged).r) << "green";
  EXPECT_FALSE(says(judged, "judged"));
}

TEST(WeldMarkers, ConnectNothingBetweenTacks)
{
  IdealWeld first, second;
  first.begin = 0.001, first.end = 0.007;
  second.begin = 0.013, second.end = 0.019;
  const Measured tacks([&](double x, double y) { return first(x, y) + second(x, y); }, 100);
  const MarkerArray drawn = weldMarkers(tacks.evaluation, header());
  expectDrawable(drawn);
  const Marker* line = find(drawn, "toe_left", Marker::LINE_LIST);
  ASSERT_NE(line, nullptr);
  for (std::size_t i = 0; i + 1 < line->points.size(); i += 2)
    EXPECT_LT(line->points[i + 1].y - line->points[i].y, 1e-3);
}

TEST(WeldMarkers, OfNoWeldAreADeletion)
{
  const Measured plate([](double, double) { return 0.0; });
  EXPECT_EQ(weldMarkers(plate.evaluation, header()).markers.size(), 1u);
  EXPECT_EQ(middleSection(plate.evaluation.result), nullptr);
  const WeldSection nothing;
  EXPECT_EQ(sectionMarkers(nothing, plate.scan.rows[3], header()).markers.size(), 1u);
}

TEST(SectionMarkers, DrawTheProfileWithItsDimensionsAboveItsPlace)
{
  IdealWeld shape;
  shape.undercut = 0.0003;
  const Measured weld(shape);
  const WeldSection* middle = middleSection(weld.evaluation.result);
  ASSERT_NE(middle, nullptr);
  EXPECT_NEAR(middle->row, 30, 2);
  const MarkerArray drawn = sectionMarkers(*middle, weld.scan.rows[static_cast<std::size_t>(middle->row)], header());
  expectDrawable(drawn);
  const Marker* profile = find(drawn, "section", Marker::LINE_LIST);
  ASSERT_NE(profile, nullptr);
  ASSERT_GT(profile->points.size(), 600U) << "15 mm of 42 um, two ends each";
  double low = 1.0, high = -1.0;
  for (const geometry_msgs::Point& point : profile->points)
  {
    low = std::min(low, point.z), high = std::max(high, point.z);
    EXPECT_NEAR(point.y, middle->toe_left.y.value, 1e-4) << "over its place";
  }
  EXPECT_NEAR(high - low, 3.0 * (0.0015 + 0.0003), 1e-4) << "enlarged 3:1";
  EXPECT_GT(low, 0.01) << "clear of the cloud";
  EXPECT_TRUE(says(drawn, "b 8.0"));
  EXPECT_TRUE(says(drawn, "h 1.5"));
  EXPECT_TRUE(says(drawn, "5011 0.30") || says(drawn, "5011 0.29"));
  EXPECT_TRUE(says(drawn, "deg"));
  EXPECT_FALSE(says(drawn, "a ")) << "no throat";
}

TEST(SectionMarkers, SayNothingOfWhatWasNotMeasured)
{
  const Measured weld((IdealWeld()));
  WeldSection section = *middleSection(weld.evaluation.result);
  section.reinforcement = section.toe_angle_left = section.undercut_right = Quantity();
  const MarkerArray drawn = sectionMarkers(section, Profile(), header());
  expectDrawable(drawn);
  EXPECT_FALSE(says(drawn, "nan"));
  EXPECT_FALSE(says(drawn, "h "));
}
}  // namespace weld_profiler
