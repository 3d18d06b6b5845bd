#include "seam_zones.h"

#include <algorithm>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kSlack = 0.05;  // per metre beyond the sections
}  // namespace

SeamZones::SeamZones(const SeamSections& sections) : sections_(sections)
{
  const std::vector<double>& places = sections.places();
  if (places.size() < 2)
    return;
  begin_ = places.front();
  const double step = (places.back() - begin_) / static_cast<double>(places.size() - 1);
  per_metre_ = 1.0 / step;
  std::size_t k = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    while (k + 1 < places.size() && places[k] < begin_ + static_cast<double>(i) * step)
      ++k;
    first_.push_back(k);
  }
}

std::size_t SeamZones::nearestSection(double s) const
{
  const std::vector<double>& places = sections_.places();
  if (!(s > begin_) || first_.empty())
    return 0;
  const auto step =
      static_cast<std::size_t>(std::min((s - begin_) * per_metre_, static_cast<double>(first_.size() - 1)));
  std::size_t k = first_[step];
  while (k > 0 && places[k - 1] >= s)
    --k;
  while (k < places.size() && places[k] < s)
    ++k;
  return k == places.size() || (k > 0 && s - places[k - 1] < places[k] - s) ? k - 1 : k;
}

Zone SeamZones::zone(std::size_t k, double q) const
{
  const SectionShape& shape = sections_.shape(k);
  const double left = sections_.mappedToe(k, Side::Left), right = sections_.mappedToe(k, Side::Right);
  if (q < left)
    return shape.left.valid() ? Zone::LeftParent : Zone::Nowhere;
  if (q > right)
    return shape.right.valid() ? Zone::RightParent : Zone::Nowhere;
  return left < right && shape.left.valid() && shape.right.valid() ? Zone::Weld : Zone::Nowhere;
}

Line SeamZones::chord(std::size_t k) const
{
  const SectionShape& shape = sections_.shape(k);
  const double left = sections_.mappedToe(k, Side::Left), right = sections_.mappedToe(k, Side::Right);
  const double z = shape.left.line.at(left), slope = (shape.right.line.at(right) - z) / (right - left);
  return Line{ z - slope * left, slope };
}

double SeamZones::flush(std::size_t k, double q) const
{
  const SectionShape& shape = sections_.shape(k);
  switch (zone(k, q))
  {
    case Zone::LeftParent:
      return shape.left.line.at(q);
    case Zone::RightParent:
      return shape.right.line.at(q);
    case Zone::Weld:
      return chord(k).at(q);
    case Zone::Nowhere:
      break;
  }
  return kNaN;
}

double SeamZones::slack(double s) const
{
  const std::vector<double>& places = sections_.places();
  return kSlack * std::max(0.0, std::max(places.front() - s, s - places.back()));
}
}  // namespace weld
}  // namespace weld_profiler
