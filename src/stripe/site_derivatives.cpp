#include "site_derivatives.h"

#include <algorithm>
#include <array>

#include "lanes.h"

namespace weld_profiler
{
namespace
{
/// The one-dimensional factors of a separable kernel.
struct Factors
{
  const float *smooth, *first, *second;
};

struct DownTheColumns
{
  /// The factors are even (smooth, second) or odd (first): rows above and below the middle are taken together.
  /// @param factors  from the middle one on.
  /// @param count    columns; a whole vector is computed of the last ones.
  struct Task
  {
    const float* middle;
    std::ptrdiff_t pitch;
    int count, reach;
    Factors factors;
    SiteDerivatives::Sums sums;
  };

  template <class Lanes>
  WELD_PROFILER_KERNEL static void run(Task task)
  {
    for (int at = 0; at < task.count; at += kLanes<Lanes>)
    {
      Lanes middle;
      load(task.middle + at, middle);
      Lanes smooth = task.factors.smooth[0] * middle;
      Lanes first = {};
      Lanes second = task.factors.second[0] * middle;
      const float* above = task.middle + at;
      const float* below = above;
      for (int j = 1; j <= task.reach; ++j)
      {
        above -= task.pitch;
        below += task.pitch;
        Lanes a;
        Lanes b;
        load(above, a);
        load(below, b);
        const Lanes both = a + b;
        smooth += task.factors.smooth[j] * both;
        first += task.factors.first[j] * (b - a);
        second += task.factors.second[j] * both;
      }
      store(smooth, task.sums.smooth + at);
      store(first, task.sums.first + at);
      store(second, task.sums.second + at);
    }
  }
};

struct RunDerivatives
{
  std::array<float, kMostRunColumns> x, y, xx, xy, yy;
};

struct AlongTheRow
{
  struct Task
  {
    SiteDerivatives::Sums sums;
    Factors factors;
    int count, taps;
  };

  template <class Lanes>
  WELD_PROFILER_KERNEL static void run(Task task, RunDerivatives* result)
  {
    for (int at = 0; at < task.count; at += kLanes<Lanes>)
    {
      Lanes x = {};
      Lanes y = {};
      Lanes xx = {};
      Lanes xy = {};
      Lanes yy = {};
      for (int j = 0; j < task.taps; ++j)
      {
        Lanes smooth;
        Lanes first;
        Lanes second;
        load(task.sums.smooth + at + j, smooth);
        load(task.sums.first + at + j, first);
        load(task.sums.second + at + j, second);
        x += task.factors.first[j] * smooth;
        y += task.factors.smooth[j] * first;
        xx += task.factors.second[j] * smooth;
        xy += task.factors.first[j] * first;
        yy += task.factors.smooth[j] * second;
      }
      store(x, result->x.data() + at);
      store(y, result->y.data() + at);
      store(xx, result->xx.data() + at);
      store(xy, result->xy.data() + at);
      store(yy, result->yy.data() + at);
    }
  }
};
}  // namespace

void SiteDerivatives::measure(const ImageView& image, const DerivativeKernel& kernel, const Sites& sites)
{
  kernel.copyFactors(factors_);
  for (std::vector<float>* values : { &x, &y, &xx, &xy, &yy })
    values->resize(sites.size());
  tiles_.reset(image, sites, kernel.reach());
  while (tiles_.next())
  {
    // All runs down the columns before the first along its row: what was just written reads slowly at other places.
    const std::vector<RowRun>& runs = tiles_.runs();
    for (std::size_t i = 0; i < runs.size(); ++i)
      sumDown(sites, runs[i], kernel.reach(), sumsOf(i, kernel.reach()));
    for (std::size_t i = 0; i < runs.size(); ++i)
      sumAlong(sites, runs[i], kernel.reach(), sumsOf(i, kernel.reach()));
  }
}

SiteDerivatives::Sums SiteDerivatives::sumsOf(std::size_t run, int reach)
{
  // The pass along the row reads a vector beyond the last column's neighbourhood.
  const std::size_t size = kMostRunColumns + 2 * static_cast<std::size_t>(reach) + 2 * kMostLanes;
  sums_.resize(std::max(sums_.size(), 3 * size * tiles_.runs().size()));
  float* first = sums_.data() + 3 * size * run;
  return { first, first + size, first + 2 * size };
}

void SiteDerivatives::sumDown(const Sites& sites, const RowRun& run, int reach, const Sums& sums)
{
  const int from = sites[run.first].u - reach;
  const int count = sites[run.last].u + reach - from + 1;
  const int taps = 2 * reach + 1;
  const float* middle = factors_.data() + reach;
  dispatchLanes<DownTheColumns>(DownTheColumns::Task{
      tiles_.at(from, run.row), tiles_.pitch(), count, reach, { middle, middle + taps, middle + 2 * taps }, sums });
}

void SiteDerivatives::sumAlong(const Sites& sites, const RowRun& run, int reach, const Sums& sums)
{
  const int from = sites[run.first].u;
  const int count = sites[run.last].u - from + 1;
  const int taps = 2 * reach + 1;
  const float* factors = factors_.data();
  RunDerivatives result;
  dispatchLanes<AlongTheRow>(AlongTheRow::Task{ sums, { factors, factors + taps, factors + 2 * taps }, count, taps },
                             &result);
  for (std::size_t i = run.first; i <= run.last; ++i)
  {
    if (sites[i].v != run.row)
      continue;
    const auto at = static_cast<std::size_t>(sites[i].u - from);
    x[i] = result.x[at];
    y[i] = result.y[at];
    xx[i] = result.xx[at];
    xy[i] = result.xy[at];
    yy[i] = result.yy[at];
  }
}
}  // namespace weld_profiler
