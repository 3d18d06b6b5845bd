#include "measuring.h"

#include <algorithm>
#include <cmath>

#include "kind_model.h"
#include "said.h"
#include "seam_maps.h"
#include "seam_summary.h"
#include "seam_volumes.h"
#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kRoughStep = 3.5e-4;    // between the sections that path and strays are found with [m]
constexpr double kNearlyAll = 0.9;       // of the sections: when fewer were measured it is said
constexpr double kLeastStanding = 0.04;  // of the sections must show a bead beyond doubt
constexpr int kFewRows = 60;             // so few are all looked at
constexpr double kLargeSpot = 1e-3;      // [m]
constexpr double kLeastScore = 0.3;      // of a kind, else the weld is of none

std::vector<SectionShape> shapesOf(const SeamSections& sections)
{
  std::vector<SectionShape> shapes;
  for (std::size_t k = 0; k < sections.size(); ++k)
    shapes.push_back(sections.shape(k));
  return shapes;
}

void add(std::string& reason, const std::string& more)
{
  reason += (reason.empty() ? "" : "; ") + more;
}
}  // namespace

/// One section a row, where the row crosses the path; with a step those that lie a step apart.
std::vector<double> Measuring::sectionPlaces(const WeldPath& path, double step) const
{
  std::vector<double> places;
  double next = -INFINITY;
  for (const double y : grid_.row_y)
  {
    const double s = path.sAt(y);
    if (y < found_.from_y || y > found_.to_y || s < next - 1e-9 || (!places.empty() && !(s > places.back())))
      continue;
    places.push_back(s);
    next = step > 0.0 ? s + step : -INFINITY;
  }
  return places;
}

WeldPath Measuring::refinedPath(const SeamSections& sections) const
{
  std::vector<PathSample> samples;
  for (std::size_t k = 0; k < sections.size(); ++k)
  {
    const SectionShape& shape = sections.shape(k);
    if (!shape.whole())
      continue;
    const WeldPathPoint& place = sections.profile(k).place;
    const double q = 0.5 * (shape.toe_left.q + shape.toe_right.q);
    samples.push_back(PathSample{ place.x + std::cos(place.yaw) * q, place.y + std::sin(place.yaw) * q,
                                  std::hypot(shape.toe_left.sigma, shape.toe_right.sigma) });
  }
  // toes less certain than the rows show them tell the path worse
  std::vector<double> sigmas;
  sigmas.reserve(samples.size());
  for (const PathSample& sample : samples)
    sigmas.push_back(sample.sigma);
  return samples.empty() || !(median(std::move(sigmas)) < kRowToeSigma)
             ? *found_.path
             : WeldPath(samples, found_.from_y, found_.to_y, kPathReach);
}

void Measuring::measureRoughly()
{
  const SectionSampler sampler(grid_, *found_.path);
  const SeamGuess guess(grid_, found_.track, *found_.path);
  SeamSections rough(sampler, guess, params_);
  // however far apart sections are asked for: a path through a few of them is not known well enough to measure along
  const std::vector<double> places = sectionPlaces(*found_.path, grid_.rows < kFewRows ? 0.0 : kRoughStep);
  rough.measureRoughly(places);
  strays_ = findStrays(grid_, sampler, SeamSurface(rough), {});
  // large ones drag along the median of the sections, which points are held against
  if (std::max(strays_.widest_pit, strays_.widest_ball) > kLargeSpot)
  {
    // a face that falls into a pit may pass for one that ends at its toe there
    if (strays_.widest_pit > kLargeSpot)
      rough.measure(places, strays_.masked);
    strays_ = findStrays(grid_, sampler, SeamSurface(rough, sampler, strays_.masked), strays_.masked);
  }
  path_ = std::make_unique<WeldPath>(refinedPath(rough));
}

void Measuring::measureFinally()
{
  sampler_ = std::make_unique<SectionSampler>(grid_, *path_);
  guess_ = std::make_unique<SeamGuess>(grid_, found_.track, *path_);
  blurred_ = params_;
  // between rows that cross a toe obliquely its kink is blurred
  const double oblique = std::abs(std::sin(path_->at(0.5 * path_->length()).yaw)) * grid_.pitch;
  if (oblique > blurred_.edge_blur)
    blurred_.edge_blur = oblique;
  sections_ = std::make_unique<SeamSections>(*sampler_, *guess_, blurred_);
  sections_->measure(sectionPlaces(*path_, params_.section_step), strays_.masked);
  for (std::vector<WeldSpot>* spots : { &strays_.spots, &strays_.hollows })
    for (WeldSpot& spot : *spots)
      spot.s = path_->locate(spot.x, spot.y, spot.s).s;
}

/// False when the weld is of no kind.
bool Measuring::chooseKind(WeldResult& result) const
{
  const SeamEvidence evidence = seamEvidence(shapesOf(*sections_));
  result.scores = scoreKinds(evidence, params_);
  if (!evidence.angle.measured())
    add(result.reason, "no section shows both toes: a parent is not in view, or no face rises from it");
  if (params_.kind != "auto")
  {
    for (const KindScore& score : result.scores)
    {
      if (params_.kind != name(score.kind))
        continue;
      result.kind = score.kind;
      if (score.score < kLeastScore)
        add(result.reason, "the parents do not lie as in a weld of kind " + params_.kind + ", which was asked for");
    }
    return true;
  }
  if (result.scores.front().score >= kLeastScore)
  {
    result.kind = result.scores.front().kind;
    return true;
  }
  add(result.reason, said("the parents lie as in no known kind of weld: offset ", 1e3 * evidence.offset.value,
                          " mm, angle ", 57.29578 * evidence.angle.value, " deg"));
  return false;
}

void Measuring::fillSections(WeldResult& result)
{
  const KindModel& model = kindModel(result.kind);
  for (std::size_t k = 0; k < sections_->size(); ++k)
  {
    const SectionValues values = sectionValues(sections_->profile(k), sections_->shape(k), blurred_);
    WeldSection section = values.section;
    undercut_left_.push_back(values.undercut_width_left);
    undercut_right_.push_back(values.undercut_width_right);
    section.section = static_cast<int>(k);
    section.stage = scan_.rows[static_cast<std::size_t>(section.row)].stage;
    const bool certain = section.width.sigma <= params_.max_width_sigma;
    // a yaw that is not certain foreshortens by its square's half
    const double yaw_sigma = path_->yawSigma(sections_->profile(k).place.y);
    section.width.sigma = std::hypot(section.width.sigma, 0.5 * section.width.value * square(yaw_sigma));
    model.measure(sections_->shape(k), section);
    standing_out_ += standsOut(section) ? 1 : 0;
    path_doubtful_ = path_doubtful_ || (certain && section.width.sigma > params_.max_width_sigma);
    refuseDoubtful(params_, section);
    result.sections.push_back(section);
    result.path.push_back(sections_->profile(k).place);
  }
}

void Measuring::fillResultMaps(WeldResult& result) const
{
  const SeamZones zones(*sections_);
  const double margin = 2.5 * grid_.pitch;
  const SeamView view{ scan_,
                       grid_,
                       *path_,
                       *sampler_,
                       *sections_,
                       zones,
                       strays_,
                       found_.from_y > grid_.row_y.front() + margin,
                       found_.to_y < grid_.row_y.back() - margin };
  fillMaps(view, undercut_left_, undercut_right_, params_, result);
}

/// A section or two in many may rise by chance.
bool Measuring::standsOutEnough(std::size_t sections) const
{
  return standing_out_ > 0 && static_cast<double>(standing_out_) >= kLeastStanding * static_cast<double>(sections);
}

void Measuring::sayWhatIsMissing(WeldResult& result) const
{
  const auto all = result.sections.size();
  const auto told = static_cast<std::size_t>(std::count_if(
      result.sections.begin(), result.sections.end(), [](const WeldSection& section) { return section.hasBead(); }));
  if (told == 0)
    add(result.reason, path_doubtful_      ? "no section's width is certain enough: the weld's direction is not known"
                       : standing_out_ > 0 ? "no section's width is certain enough: the face is too flat at a toe"
                                           : "no section could be measured");
  else if (static_cast<double>(told) < kNearlyAll * static_cast<double>(all))
    add(result.reason, std::to_string(all - told) + " of " + std::to_string(all) +
                           " sections could not be measured: a toe is hidden, too flat or not in view there");
  if (all == 1 && params_.section_step > 0.0)
    add(result.reason,
        said("section_step ", 1e3 * params_.section_step, " mm is more than the ",
             1e3 * (path_->sAt(found_.to_y) - path_->sAt(found_.from_y)),
             " mm of weld that were seen: one section fits, which tells no length, no volume and no grinding; take "
             "a smaller one, or 0 for a section a row"));
  const double seen = all > 1 ? result.sections.back().s - result.sections.front().s + usualStep(result.sections) : 0.0;
  if (told > 0 && result.volume_length < kNearlyAll * seen)
    add(result.reason,
        said("the volumes are of ", 1e3 * result.volume_length, " mm of weld, ", 1e3 * seen, " mm were seen"));
}

WeldResult Measuring::operator()()
{
  WeldResult result;
  result.rows = static_cast<std::uint32_t>(scan_.rows.size());
  result.cells = scan_.cells;
  result.labels.assign(scan_.rows.size() * scan_.cells, static_cast<std::uint8_t>(WeldLabel::Unknown));
  result.removal.assign(result.labels.size(), std::numeric_limits<float>::quiet_NaN());
  result.target = result.removal;
  grid_ = makeGrid(scan_);
  found_ = findWeld(grid_, params_);
  result.reason = found_.reason;
  result.other_beads = found_.others;
  if (!found_.path)
    return result;
  measureRoughly();
  measureFinally();
  if (!chooseKind(result))
    return result;
  fillSections(result);
  if (!standsOutEnough(result.sections.size()) && params_.kind == "auto")
  {
    add(result.reason, "no section could be measured");
    result.kind = WeldKind::None;
    result.sections.clear(), result.path.clear();
    return result;
  }
  summarise(*sections_, params_, result);
  fillResultMaps(result);
  result.spots = strays_.spots;
  result.hollows = strays_.hollows;
  result.unseen_pores = strays_.unseen;
  dropPoresBeyondEnds(result);
  sayWhatIsMissing(result);
  return result;
}
}  // namespace weld
}  // namespace weld_profiler
