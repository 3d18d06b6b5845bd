#include "toe_match.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kSameWidth = 1e-4;  // toes whose distance differs by less are the same toes [m]
constexpr double kLeastShare = 0.5;  // of the sections after
constexpr std::size_t kLeastCount = 5;
constexpr double kStationGap = 1.5e-3;  // no toe is told over a longer stretch without sections [m]
constexpr double kLeastSigma = 1e-5;    // of a section's middle [m]
constexpr double kAlike = 3.0;          // neighbouring sections err alike: this many count as one, square root of

bool seen(const SectionPoint& point)
{
  return std::isfinite(point.x.value) && std::isfinite(point.y.value) && std::isfinite(point.z.value);
}

/// A turn that is still to be told makes a line of the distances: their scatter is that about it.
double scatterAboutLine(const std::vector<MotionObservation>& observations)
{
  double count = 0.0, mean = 0.0, distance = 0.0;
  for (const MotionObservation& one : observations)
    count += 1.0, mean += one.shape.y(), distance += one.distance;
  mean /= count, distance /= count;
  double square_sum = 1e-12, product = 0.0;
  for (const MotionObservation& one : observations)
  {
    square_sum += square(one.shape.y() - mean);
    product += (one.shape.y() - mean) * (one.distance - distance);
  }
  std::vector<double> scatter;
  scatter.reserve(observations.size());
  for (const MotionObservation& one : observations)
    scatter.push_back(one.distance - distance - product / square_sum * (one.shape.y() - mean));
  return robustSigma(std::move(scatter));
}

Eigen::Vector3d placeOf(const SectionPoint& point)
{
  return { point.x.value, point.y.value, point.z.value };
}
}  // namespace

ToeMatch::ToeMatch(const WeldResult& before, const PathFrame& path, const WeldResult& after) : path_(path)
{
  for (const WeldSection& section : before.sections)
  {
    if (!section.hasBead() || !seen(section.toe_left) || !seen(section.toe_right))
      continue;
    const PathPlace left = path.locate(section.toe_left.x.value, section.toe_left.y.value, section.s);
    const PathPlace right = path.locate(section.toe_right.x.value, section.toe_right.y.value, section.s);
    stations_.push_back({ section.s, left.q, right.q });
  }
  for (const WeldSection& section : after.sections)
  {
    if (section.hasBead() && seen(section.toe_left) && seen(section.toe_right))
      pairs_.push_back({ placeOf(section.toe_left), placeOf(section.toe_right), section.width.sigma });
  }
}

bool ToeMatch::stationAt(double s, Station& station) const
{
  const auto after = std::lower_bound(stations_.begin(), stations_.end(), s,
                                      [](const Station& a, double value) { return a.s < value; });
  if (after == stations_.begin() || after == stations_.end() || after->s - (after - 1)->s > kStationGap)
    return false;
  const Station &a = *(after - 1), &b = *after;
  const double share = (s - a.s) / (b.s - a.s);
  station = { s, a.left + share * (b.left - a.left), a.right + share * (b.right - a.right) };
  return true;
}

std::vector<MotionObservation> ToeMatch::observe(const Eigen::Isometry3d& motion, const Eigen::Vector3d& about) const
{
  std::vector<MotionObservation> observations;
  double near_s = stations_.empty() ? 0.0 : stations_.front().s;
  std::size_t compared = 0;
  for (const Pair& pair : pairs_)
  {
    const Eigen::Vector3d left = motion * pair.left, right = motion * pair.right, middle = 0.5 * (left + right);
    near_s = path_.locate(middle.x(), middle.y(), near_s).s;
    Station before;
    if (!stationAt(near_s, before))
      continue;
    ++compared;
    const double left_off = path_.locate(left.x(), left.y(), near_s).q - before.left;
    const double right_off = path_.locate(right.x(), right.y(), near_s).q - before.right;
    if (!(std::abs(right_off - left_off) < std::max(kSameWidth, 3.0 * pair.sigma)))
      continue;
    const Eigen::Vector2d along = path_.along(near_s);
    const Eigen::Vector3d across(along.y(), -along.x(), 0.0);
    MotionObservation one;
    one.jacobian << across, (middle - about).cross(across);
    one.distance = 0.5 * (left_off + right_off);
    one.common = CommonError::Toes;
    one.shape = { 1.0, (middle - about).head<2>().dot(along) / kCommonLength, 0.0 };
    observations.push_back(one);
  }
  if (observations.size() < kLeastCount ||
      static_cast<double>(observations.size()) < kLeastShare * static_cast<double>(compared))
    return {};
  const double sigma = kAlike * std::max(kLeastSigma, scatterAboutLine(observations));
  for (MotionObservation& one : observations)
    one.sigma = sigma;
  return observations;
}
}  // namespace weld
}  // namespace weld_profiler
