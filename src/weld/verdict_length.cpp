#include "verdict_length.h"

#include <algorithm>
#include <sstream>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
constexpr double kGap = 3.0;       // usual steps
constexpr std::size_t kAbout = 5;  // steps before and after one that tell what is usual

std::vector<double> stepsOf(const std::vector<double>& s)
{
  std::vector<double> steps;
  for (std::size_t i = 1; i < s.size(); ++i)
  {
    steps.push_back(s[i] - s[i - 1]);
    if (steps.back() > 0.0)
      continue;
    std::ostringstream text;
    text << "section " << i << " lies at s = " << s[i] << " m after " << s[i - 1] << " m, s must rise";
    throw PreconditionError(text.str());
  }
  return steps;
}

/// The median of the steps about one: steps may change along the weld.
double usualStep(const std::vector<double>& steps, std::size_t index)
{
  const std::size_t first = index < kAbout ? 0 : index - kAbout;
  const std::size_t last = std::min(steps.size(), index + kAbout + 1);
  std::vector<double> about(steps.begin() + first, steps.begin() + last);
  std::nth_element(about.begin(), about.begin() + about.size() / 2, about.end());
  return about[about.size() / 2];
}

/// Weighted length to the left of any point, of stretches whose ends are known.
class LengthBefore
{
public:
  explicit LengthBefore(const std::vector<Stretch>& stretches)
  {
    for (const Stretch& stretch : stretches)
    {
      points_.push_back({ stretch.begin, stretch.weight, 0.0 });
      points_.push_back({ stretch.end, -stretch.weight, 0.0 });
    }
    std::sort(points_.begin(), points_.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    double slope = 0.0;
    for (std::size_t i = 0; i < points_.size(); ++i)
    {
      points_[i].total = i == 0 ? 0.0 : points_[i - 1].total + slope * (points_[i].x - points_[i - 1].x);
      slope += points_[i].slope;
      points_[i].slope = slope;
    }
  }

  double at(double x) const
  {
    auto after = std::upper_bound(points_.begin(), points_.end(), x,
                                  [](double value, const Point& point) { return value < point.x; });
    if (after == points_.begin())
      return 0.0;
    --after;
    return after->total + after->slope * (x - after->x);
  }

private:
  struct Point
  {
    double x;
    double slope;  ///< from here on
    double total;  ///< to the left
  };
  std::vector<Point> points_;
};
}  // namespace

std::vector<Stretch> cellsOf(const std::vector<double>& s)
{
  const std::vector<double> steps = stepsOf(s);
  std::vector<double> half;  // of each step, on either side of its middle
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const double usual = usualStep(steps, i);
    half.push_back(0.5 * (steps[i] < kGap * usual ? steps[i] : usual));
  }
  std::vector<Stretch> cells;
  for (std::size_t i = 0; i < s.size(); ++i)
  {
    const double before = half.empty() ? 0.0 : half[i == 0 ? 0 : i - 1];
    const double after = half.empty() ? 0.0 : half[std::min(i, half.size() - 1)];
    cells.push_back({ s[i] - before, s[i] + after, 1.0 });
  }
  return cells;
}

std::vector<Stretch> gapsBetween(const std::vector<Stretch>& cells, double weight)
{
  std::vector<Stretch> gaps;
  for (std::size_t i = 1; i < cells.size(); ++i)
  {
    if (cells[i].begin > cells[i - 1].end)
      gaps.push_back({ cells[i - 1].end, cells[i].begin, weight });
  }
  return gaps;
}

double mostWithin(const std::vector<Stretch>& stretches, double window)
{
  const LengthBefore before(stretches);
  // the length in a window that slides is piecewise linear: it is largest where an end of the window meets a stretch's
  double most = 0.0;
  for (const Stretch& stretch : stretches)
    for (const double begin : { stretch.begin, stretch.end - window, stretch.begin - window, stretch.end })
      most = std::max(most, before.at(begin + window) - before.at(begin));
  return most;
}
}  // namespace weld_profiler
