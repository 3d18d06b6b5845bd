#include "seam_summary.h"

#include <algorithm>
#include <cmath>

#include "ripples.h"
#include "seam_volumes.h"
#include "section_heights.h"
#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kSigmas = 3.0;  // a bead rises by at least so many

bool rises(const Quantity& height)
{
  return height.measured() && height.value > kSigmas * height.sigma;
}

void fillRipples(const SeamSections& sections, WeldResult& result)
{
  std::vector<double> heights, sigmas;
  double between = 0.0;
  for (std::size_t k = 0; k < sections.size(); ++k)
  {
    heights.push_back(kNaN);
    if (!result.sections[k].hasBead())
      continue;
    const SectionShape& shape = sections.shape(k);
    HeightSpan span;
    span.from = 0.5 * (shape.toe_left.q + shape.toe_right.q) - span.half_window;
    span.to = span.from + 2.0 * span.half_window;
    span.step = span.half_window;
    span.energy = shape.energy();
    span.row_bend = sections.profile(k).row_bend;
    const std::vector<HeightNode> nodes = localHeights(sections.profile(k), span);
    if (nodes.size() != 3)
      continue;
    heights.back() = shape.chord().above(nodes[1].q, nodes[1].z);
    sigmas.push_back(std::sqrt(std::max(0.0, square(nodes[1].sigma) - square(nodes[1].between))));
    between += nodes[1].between;
  }
  const Ripples ripples = findRipples(sections.places(), heights, median(sigmas));
  result.ripple_pitch = ripples.pitch;
  result.ripple_height = ripples.height;
  // lines between rows cut crests and troughs off; those of a sine are sqrt(2) its quadratic mean
  if (!sigmas.empty())
    result.ripple_height.sigma =
        std::hypot(result.ripple_height.sigma, 2.0 * std::sqrt(2.0) * between / static_cast<double>(sigmas.size()));
}

SectionStatistics statisticsOf(const char* name, const Quantity WeldSection::*field,
                               const std::vector<WeldSection>& sections)
{
  SectionStatistics result;
  result.name = name;
  double sum = 0.0, squares = 0.0;
  std::vector<double> sigmas;
  for (const WeldSection& section : sections)
  {
    const Quantity& quantity = section.*field;
    if (!quantity.measured())
      continue;
    result.least = result.count == 0 ? quantity.value : std::min(result.least, quantity.value);
    result.largest = result.count == 0 ? quantity.value : std::max(result.largest, quantity.value);
    ++result.count;
    sum += quantity.value;
    squares += square(quantity.value);
    sigmas.push_back(quantity.sigma);
  }
  if (result.count == 0)
    return result;
  const double mean = sum / result.count;
  result.deviation = std::sqrt(std::max(0.0, squares / result.count - mean * mean));
  result.mean = Quantity{ mean, median(sigmas) };  // neighbours err alike: the mean is hardly better than one
  return result;
}

void fillStatistics(WeldResult& result)
{
  const std::pair<const char*, Quantity WeldSection::*> fields[] = {
    { "width", &WeldSection::width },
    { "reinforcement", &WeldSection::reinforcement },
    { "height_left", &WeldSection::height_left },
    { "height_right", &WeldSection::height_right },
    { "toe_angle_left", &WeldSection::toe_angle_left },
    { "toe_angle_right", &WeldSection::toe_angle_right },
    { "undercut_left", &WeldSection::undercut_left },
    { "undercut_right", &WeldSection::undercut_right },
    { "misalignment", &WeldSection::misalignment },
    { "angle", &WeldSection::angle },
    { "area", &WeldSection::area },
    { "incomplete_fill", &WeldSection::incomplete_fill },
    { "leg_left", &WeldSection::leg_left },
    { "leg_right", &WeldSection::leg_right },
    { "throat", &WeldSection::throat },
  };
  for (const auto& field : fields)
    result.statistics.push_back(statisticsOf(field.first, field.second, result.sections));
}
}  // namespace

bool standsOut(const WeldSection& section)
{
  // with its top under spatter a face is known by its toes alone
  return section.hasBead() && (!section.reinforcement.measured() || rises(section.reinforcement) ||
                               (rises(section.height_left) && rises(section.height_right)));
}

void refuseDoubtful(const WeldParams& params, WeldSection& section)
{
  // plates nearly in line meet nowhere in particular
  for (Quantity WeldSection::*size : { &WeldSection::leg_left, &WeldSection::leg_right, &WeldSection::throat })
  {
    if (!((section.*size).sigma <= params.max_width_sigma))
      section.*size = Quantity();
  }
  if (!section.hasBead() || (section.width.sigma <= params.max_width_sigma && standsOut(section)))
    return;
  const WeldSection doubtful = section;
  section = WeldSection();
  section.section = doubtful.section, section.row = doubtful.row, section.stage = doubtful.stage;
  section.s = doubtful.s, section.yaw = doubtful.yaw;
  section.reference = SectionReference::ParentLines;
  // of a bead that does stand out one toe may be certain all the same
  for (SectionPoint WeldSection::*toe : { &WeldSection::toe_left, &WeldSection::toe_right })
  {
    const SectionPoint& point = doubtful.*toe;
    if (standsOut(doubtful) && std::hypot(point.x.sigma, point.y.sigma) <= params.max_width_sigma)
      section.*toe = point;
  }
  section.misalignment = doubtful.misalignment;
  section.angle = doubtful.angle;
}

namespace
{
/// Where no section shows its bead, what lies beside it may not be the parents.
void dropUnfounded(std::vector<WeldSection>& sections)
{
  if (std::any_of(sections.begin(), sections.end(), [](const WeldSection& section) { return section.hasBead(); }))
    return;
  for (WeldSection& section : sections)
    section.misalignment = section.angle = Quantity();
}
}  // namespace

void dropPoresBeyondEnds(WeldResult& result)
{
  const auto has_bead = [](const WeldSection& section) { return section.hasBead(); };
  const auto first = std::find_if(result.sections.begin(), result.sections.end(), has_bead);
  const auto last = std::find_if(result.sections.rbegin(), result.sections.rend(), has_bead);
  const auto beyond = [&](const WeldSpot& spot)
  {
    return spot.kind == WeldSpot::Kind::Pore &&
           (first == result.sections.end() || spot.s < first->s || spot.s > last->s);
  };
  for (std::vector<WeldSpot>* spots : { &result.spots, &result.hollows })
    spots->erase(std::remove_if(spots->begin(), spots->end(), beyond), spots->end());
}

void summarise(const SeamSections& sections, const WeldParams& params, WeldResult& result)
{
  dropUnfounded(result.sections);
  int measured = 0;
  double first = kNaN, last = kNaN;
  for (const WeldSection& section : result.sections)
  {
    if (!section.hasBead())
      continue;
    ++measured;
    first = std::isfinite(first) ? first : section.s;
    last = section.s;
  }
  if (!result.sections.empty())
    result.measured_share = static_cast<double>(measured) / static_cast<double>(result.sections.size());
  const double step = usualStep(result.sections);
  if (measured > 0 && std::isfinite(step))
    result.length = Quantity{ last - first + step, step };  // half a step before the first and behind the last, too
  fillVolumes(sections, params, result);
  fillRipples(sections, result);
  fillStatistics(result);
}
}  // namespace weld
}  // namespace weld_profiler
