#include "weld/compare_sections.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
constexpr double kPi = 3.141592653589793;
constexpr double kHigh = 0.5e-3;
constexpr double kSteep = 20.0 * kPi / 180.0;
constexpr double kBeside = 2.0e-3;    // of plate that a section needs beside its toes to lie inside the scan [m]
constexpr double kWidestCell = 2e-4;  // beside a hole a point does not stand for all of it [m]

Deviation deviation(const Quantity& measured, double truth)
{
  return Deviation{ measured.measured() ? measured.value : kNaN, measured.measured() ? measured.sigma : kNaN, truth };
}

std::array<Deviation, kSizes> deviations(const WeldSection& measured, const WeldTruth& truth)
{
  std::array<Deviation, kSizes> sizes;
  sizes[Width] = deviation(measured.width, truth.width);
  sizes[Reinforcement] = deviation(measured.reinforcement, truth.reinforcement);
  sizes[HeightLeft] = deviation(measured.height_left, truth.height_left);
  sizes[HeightRight] = deviation(measured.height_right, truth.height_right);
  sizes[UndercutLeft] = deviation(measured.undercut_left, truth.undercut_left);
  sizes[UndercutRight] = deviation(measured.undercut_right, truth.undercut_right);
  sizes[Misalignment] = deviation(measured.misalignment, truth.misalignment);
  sizes[ToeAngleLeft] = deviation(measured.toe_angle_left, truth.toe_angle_left);
  sizes[ToeAngleRight] = deviation(measured.toe_angle_right, truth.toe_angle_right);
  sizes[Angle] = deviation(measured.angle, truth.angle);
  sizes[Area] = deviation(measured.area, truth.area);
  sizes[IncompleteFill] = deviation(measured.incomplete_fill, truth.incomplete_fill);
  sizes[LegLeft] = deviation(measured.leg_left, truth.leg_left);
  sizes[LegRight] = deviation(measured.leg_right, truth.leg_right);
  sizes[Throat] = deviation(measured.throat, truth.throat);
  return sizes;
}

/// Where a measured section lies, seen from above.
std::pair<double, double> placeOf(const WeldResult& result, std::size_t index)
{
  const WeldSection& section = result.sections[index];
  if (section.toe_left.x.measured() && section.toe_right.x.measured())
    return { 0.5 * (section.toe_left.x.value + section.toe_right.x.value),
             0.5 * (section.toe_left.y.value + section.toe_right.y.value) };
  return { result.path[index].x, result.path[index].y };
}

/// Whether a true section's toes, and so much of the plates beside them, lie between the scan's first and last row.
bool liesInScan(const WeldTruth& truth, const Scan& scan, double beside)
{
  const double first = scan.rows.front().stage, last = scan.rows.back().stage;
  for (const auto& ends :
       { std::make_pair(truth.toe_left, truth.toe_right), std::make_pair(truth.toe_right, truth.toe_left) })
  {
    const double across = ends.first[1] - ends.second[1];
    const double level = std::hypot(ends.first[0] - ends.second[0], across);
    const double y = ends.first[1] + beside * across / level;
    if (!(y >= std::min(first, last) && y <= std::max(first, last)))
      return false;
  }
  return true;
}

double medianStep(std::vector<double> places)
{
  std::sort(places.begin(), places.end());
  std::vector<double> steps;
  for (std::size_t i = 1; i < places.size(); ++i)
    steps.push_back(places[i] - places[i - 1]);
  if (steps.empty())
    return 0.0;
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

/// Stretches of weld that the told volume is of, ends included: half a step beyond the first and last. After
/// docs/weld.md it goes on over 2 mm, and over 4 mm more where the sections in between show the width.
std::vector<std::pair<double, double>> measuredStretches(const std::vector<SectionCase>& sections)
{
  std::vector<double> all(sections.size());
  std::transform(sections.begin(), sections.end(), all.begin(), [](const SectionCase& section) { return section.s; });
  const double step = medianStep(all);
  std::vector<std::pair<double, double>> stretches;
  double last = kNaN;
  int between = 0, wide = 0;
  for (const SectionCase& section : sections)
  {
    if (!(section.sizes[Area].sigma == section.sizes[Area].sigma))
    {
      ++between, wide += section.hasBead() ? 1 : 0;
      continue;
    }
    const double most = std::max(2.5 * step, 2e-3) + (between > 0 && wide == between ? 4e-3 : 0.0);
    if (stretches.empty() || !(section.s - last < most))
      stretches.emplace_back(section.s - 0.5 * step, section.s);
    stretches.back().second = section.s + 0.5 * step;
    last = section.s, between = wide = 0;
  }
  return stretches;
}

/// The line across the path through a section, seen from above.
struct Border
{
  double x = 0.0, y = 0.0, along_x = 0.0, along_y = 0.0;

  explicit Border(const WeldTruth& truth)
    : x(0.5 * (truth.toe_left[0] + truth.toe_right[0])),
      y(0.5 * (truth.toe_left[1] + truth.toe_right[1])),
      along_x(-std::sin(truth.yaw)),
      along_y(std::cos(truth.yaw))
  {
  }

  double ahead(const CloudPoint& point) const { return (point.x - x) * along_x + (point.y - y) * along_y; }
};

/// Height above the target over the points of the stretch whose sections lie wholly in the scan.
void addRemoval(const MeasuredWeld& weld, Volumes& volumes)
{
  std::vector<WeldTruth> inside = weld.simulated.weldSections();
  inside.erase(std::remove_if(inside.begin(), inside.end(),
                              [&](const WeldTruth& truth) { return !liesInScan(truth, weld.scan, kBeside); }),
               inside.end());
  if (inside.empty())
    return;
  const Border begin(inside.front()), end(inside.back());
  volumes.removal = volumes.true_removal = volumes.unknown_removal = 0.0;
  for (std::size_t r = 1; r + 1 < weld.scan.rows.size(); ++r)
  {
    const Profile& row = weld.scan.rows[r];
    const double along = 0.5 * std::abs(weld.scan.rows[r + 1].stage - weld.scan.rows[r - 1].stage);
    for (std::size_t i = 1; i + 1 < row.points.size(); ++i)
    {
      const CloudPoint& point = row.points[i];
      if (begin.ahead(point) < 0.0 || end.ahead(point) > 0.0)
        continue;
      const double across = 0.5 * std::abs(row.points[i + 1].x - row.points[i - 1].x);
      const double area = std::min(across, kWidestCell) * along;
      const double truth = weld.simulated.removalHeight(point.x, point.y) * area;
      const double value = static_cast<double>(weld.result.removal[r * weld.scan.cells + point.cell]) * area;
      volumes.true_removal += truth;
      (std::isfinite(value) ? volumes.removal : volumes.unknown_removal) += std::isfinite(value) ? value : truth;
    }
  }
}
}  // namespace

Stature statureOf(const WeldTruth& truth)
{
  const double flank = kPi - std::max(truth.toe_angle_left, truth.toe_angle_right);
  if (!(flank >= kSteep))
    return Stature::Low;
  if (truth.reinforcement >= kHigh)
    return Stature::High;
  return truth.kind == "fillet" ? Stature::LowFillet : Stature::Low;
}

std::vector<SectionCase> compareSections(const MeasuredWeld& weld)
{
  std::vector<SectionCase> sections;
  for (std::size_t i = 0; i < weld.result.sections.size(); ++i)
  {
    const auto place = placeOf(weld.result, i);
    const std::optional<WeldTruth> truth = weld.simulated.weldSection(place.first, place.second);
    if (!truth)
      continue;
    SectionCase section;
    section.s = truth->s;
    section.stature = statureOf(*truth);
    section.sizes = deviations(weld.result.sections[i], *truth);
    const SectionVerdict verdict = weld.judge.judge(weld.result.kind, weld.result.sections[i]);
    section.verdict = verdict.waits_for.empty() ? verdict.verdict : "";
    section.true_verdict = trueVerdict(weld.judging, section.sizes);
    section.clearance = clearanceOf(weld.judging, section.sizes);
    sections.push_back(std::move(section));
  }
  return sections;
}

Shares compareShares(const MeasuredWeld& weld, const std::vector<SectionCase>& sections)
{
  const std::vector<WeldTruth> truths = weld.simulated.weldSections();
  std::vector<double> places, found;
  for (const WeldTruth& truth : truths)
    places.push_back(truth.s);
  for (const SectionCase& section : sections)
  {
    if (section.hasBead())
      found.push_back(section.s);
  }
  std::sort(found.begin(), found.end());
  const double near = 0.55 * medianStep(places);  // half a step, and some for unequal ones
  Shares shares;
  for (const WeldTruth& truth : truths)
  {
    const auto at = static_cast<std::size_t>(statureOf(truth));
    const auto first = std::lower_bound(found.begin(), found.end(), truth.s - near);
    const bool measured = first != found.end() && *first <= truth.s + near;
    if (!liesInScan(truth, weld.scan, 0.0))
      continue;
    ++shares.toes[at], shares.toes_found[at] += measured ? 1 : 0;
    if (liesInScan(truth, weld.scan, kBeside))
      ++shares.inside[at], shares.inside_found[at] += measured ? 1 : 0;
  }
  return shares;
}

Volumes compareVolumes(const MeasuredWeld& weld, const std::vector<SectionCase>& sections)
{
  Volumes volumes;
  if (!weld.result.hasWeld())
    return volumes;
  volumes.measured = weld.result.volume.value;
  volumes.truth = volumes.length = 0.0;
  for (const auto& stretch : measuredStretches(sections))
  {
    volumes.truth += weld.simulated.weldVolume(stretch.first, stretch.second);
    volumes.length += stretch.second - stretch.first;
  }
  addRemoval(weld, volumes);
  return volumes;
}

std::array<std::array<long, 5>, 5> compareLabels(const MeasuredWeld& weld)
{
  std::array<std::array<long, 5>, 5> counts{};
  for (std::size_t r = 0; r < weld.scan.rows.size(); ++r)
  {
    for (const CloudPoint& point : weld.scan.rows[r].points)
    {
      const auto truth = static_cast<std::size_t>(weld.simulated.surfaceLabel(point.x, point.y));
      const std::size_t at = r * weld.scan.cells + point.cell;
      const std::size_t label = weld.result.labels.empty() ? 0 : weld.result.labels[at];
      ++counts[truth][std::min<std::size_t>(label, 4)];
    }
  }
  return counts;
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
