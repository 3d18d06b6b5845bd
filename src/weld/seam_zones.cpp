#include "seam_zones.h"

#include <algorithm>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kSlack = 0.05;  // per metre beyond the sections
constexpr double kEarly = 1e-6;  // of a step: rounding leads to no section behind the nearest
}  // namespace

SeamZones::SeamZones(const SeamSections& sections) : sections_(sections)
{
  const std::vector<double>& places = sections.places();
  across_.reserve(places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
    across_.push_back(acrossOf(sections, k));
  if (places.size() < 2)
    return;
  begin_ = places.front();
  const double step = (places.back() - begin_) / static_cast<double>(places.size() - 1);
  per_metre_ = 1.0 / step;
  last_step_ = static_cast<double>(places.size() - 1);
  std::size_t k = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double s = begin_ + (static_cast<double>(i) - kEarly) * step;
    while (k + 1 < places.size() && !(s - places[k] < places[k + 1] - s))
      ++k;
    nearest_.push_back(k);
  }
}

SeamZones::Across SeamZones::acrossOf(const SeamSections& sections, std::size_t k)
{
  const SectionShape& shape = sections.shape(k);
  Across across;
  across.left = sections.mappedToe(k, Side::Left), across.right = sections.mappedToe(k, Side::Right);
  across.left_parent = shape.left.line, across.right_parent = shape.right.line;
  const double z = shape.left.line.at(across.left);
  const double slope = (shape.right.line.at(across.right) - z) / (across.right - across.left);
  across.chord = Line{ z - slope * across.left, slope };
  across.before = shape.left.valid() ? Zone::LeftParent : Zone::Nowhere;
  across.behind = shape.right.valid() ? Zone::RightParent : Zone::Nowhere;
  const bool whole = across.left < across.right && shape.left.valid() && shape.right.valid();
  across.between = whole ? Zone::Weld : Zone::Nowhere;
  return across;
}

double SeamZones::slack(double s) const
{
  const std::vector<double>& places = sections_.places();
  return kSlack * std::max(0.0, std::max(places.front() - s, s - places.back()));
}
}  // namespace weld
}  // namespace weld_profiler
