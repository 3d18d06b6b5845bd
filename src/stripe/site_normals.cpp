#include "site_normals.h"

#include <algorithm>
#include <array>

#include "axis.h"

namespace weld_profiler
{
namespace
{
using ColumnMoments = SiteNormals::ColumnMoments;

struct MomentsDown
{
  template <class Lanes>
  WELD_PROFILER_KERNEL static void run(const float* top, std::ptrdiff_t pitch, int count, ColumnMoments* sums)
  {
    for (int at = 0; at < count; at += kLanes<Lanes>)
    {
      Lanes gray = {};
      Lanes first = {};
      Lanes second = {};
      Lanes square = {};
      for (int j = 0; j < kTemplateSize; ++j)
      {
        const auto y = static_cast<float>(j - kTemplateReach);
        Lanes value;
        load(top + j * pitch + at, value);
        gray += value;
        first += y * value;
        second += (y * y) * value;
        square += value * value;
      }
      store(gray, sums->gray.data() + at);
      store(first, sums->y.data() + at);
      store(second, sums->yy.data() + at);
      store(square, sums->square.data() + at);
    }
  }
};

struct RunMoments
{
  std::array<float, kMostRunColumns> gray, x, y, xx, xy, yy, square;
};

struct MomentsAlong
{
  template <class Lanes>
  WELD_PROFILER_KERNEL static void run(const ColumnMoments* sums, int count, RunMoments* result)
  {
    for (int at = 0; at < count; at += kLanes<Lanes>)
    {
      Lanes gray = {}, x = {}, y = {}, xx = {}, xy = {}, yy = {}, square = {};
      for (int i = 0; i < kTemplateSize; ++i)
      {
        const auto place = static_cast<float>(i - kTemplateReach);
        Lanes column_gray, column_y, column_yy, column_square;
        load(sums->gray.data() + at + i, column_gray);
        load(sums->y.data() + at + i, column_y);
        load(sums->yy.data() + at + i, column_yy);
        load(sums->square.data() + at + i, column_square);
        gray += column_gray;
        x += place * column_gray;
        xx += (place * place) * column_gray;
        y += column_y;
        xy += place * column_y;
        yy += column_yy;
        square += column_square;
      }
      store(gray, result->gray.data() + at);
      store(x, result->x.data() + at);
      store(y, result->y.data() + at);
      store(xx, result->xx.data() + at);
      store(xy, result->xy.data() + at);
      store(yy, result->yy.data() + at);
      store(square, result->square.data() + at);
    }
  }
};

/// The first moment's direction, where it is defined: see svdNormal().
struct SvdDirection
{
  struct Task
  {
    const float *x, *y, *square;
    float count;  ///< levels of the image to one of 8 bit
    int size;
  };

  WELD_PROFILER_KERNEL static void run(Task task, float* __restrict u, float* __restrict v)
  {
    const float per_count = 1.0F / task.count;
    for (int i = 0; i < task.size; ++i)
    {
      const float a = task.x[i] * per_count;
      const float b = task.y[i] * per_count;
      const float length = std::sqrt(a * a + b * b);
      const float norm = static_cast<float>(kTemplateCoordinates) + task.square[i] * per_count * per_count;
      const float deciding = b == 0.0F ? a : b;
      const float turned = (deciding < 0.0F ? -1.0F : 1.0F) / length;
      const float scale = length > static_cast<float>(kLeastMoment) * norm ? turned : 0.0F;
      u[i] = a * scale;
      v[i] = b * scale;
    }
  }
};

/// The axis of the coordinates' covariance weighted by gray, where it is defined: see pcaNormal().
struct PcaDirection
{
  struct Task
  {
    const float *gray, *x, *y, *xx, *xy, *yy;
    int size;
  };

  WELD_PROFILER_KERNEL static void run(Task task, float* __restrict u, float* __restrict v)
  {
    for (int i = 0; i < task.size; ++i)
    {
      const float gray = task.gray[i];
      const float x = task.x[i] / gray;
      const float y = task.y[i] / gray;
      const float xx = task.xx[i] / gray - x * x;
      const float xy = task.xy[i] / gray - x * y;
      const float yy = task.yy[i] / gray - y * y;
      float across_u;
      float across_v;
      const float length = smallerAxis(xx - yy, 2.0F * xy, across_u, across_v);
      const bool defined = length > static_cast<float>(kLeastAnisotropy) * (xx + yy);
      u[i] = defined ? across_u : 0.0F;
      v[i] = defined ? across_v : 0.0F;
    }
  }
};
}  // namespace

void SiteNormals::measureMoments(const ImageView& image, const Sites& sites)
{
  for (std::vector<float>* values : { &gray_, &x_, &y_, &xx_, &xy_, &yy_, &square_, &u, &v })
    values->resize(sites.size());
  tiles_.reset(image, sites, kTemplateReach);
  while (tiles_.next())
  {
    // All runs down the columns before the first along its row: what was just written reads slowly at other places.
    const std::vector<RowRun>& runs = tiles_.runs();
    sums_.resize(std::max(sums_.size(), runs.size()));
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
      const int from = sites[runs[i].first].u;
      dispatchLanes<MomentsDown>(tiles_.at(from - kTemplateReach, runs[i].row - kTemplateReach), tiles_.pitch(),
                                 sites[runs[i].last].u - from + kTemplateSize, &sums_[i]);
    }
    for (std::size_t i = 0; i < runs.size(); ++i)
      sumAlong(sites, runs[i], sums_[i]);
  }
}

void SiteNormals::sumAlong(const Sites& sites, const RowRun& run, const ColumnMoments& sums)
{
  const int from = sites[run.first].u;
  RunMoments moments;
  dispatchLanes<MomentsAlong>(&sums, sites[run.last].u - from + 1, &moments);
  for (std::size_t i = run.first; i <= run.last; ++i)
  {
    if (sites[i].v != run.row)
      continue;
    const auto at = static_cast<std::size_t>(sites[i].u - from);
    gray_[i] = moments.gray[at];
    x_[i] = moments.x[at];
    y_[i] = moments.y[at];
    xx_[i] = moments.xx[at];
    xy_[i] = moments.xy[at];
    yy_[i] = moments.yy[at];
    square_[i] = moments.square[at];
  }
}

void SiteNormals::measureSvd(const ImageView& image, const Levels& levels, const Sites& sites)
{
  measureMoments(image, sites);
  dispatch<SvdDirection>(SvdDirection::Task{ x_.data(), y_.data(), square_.data(), static_cast<float>(levels.count),
                                             static_cast<int>(sites.size()) },
                         u.data(), v.data());
}

void SiteNormals::measurePca(const ImageView& image, const Levels& /*levels*/, const Sites& sites)
{
  measureMoments(image, sites);
  dispatch<PcaDirection>(PcaDirection::Task{ gray_.data(), x_.data(), y_.data(), xx_.data(), xy_.data(), yy_.data(),
                                             static_cast<int>(sites.size()) },
                         u.data(), v.data());
}
}  // namespace weld_profiler
