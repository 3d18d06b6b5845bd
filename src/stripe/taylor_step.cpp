#include "taylor_step.h"

#include <cmath>

#include "axis.h"
#include "multiversion.h"

namespace weld_profiler
{
namespace
{
constexpr int kMoves = 2;                ///< pixels that an initial point may be off
constexpr double kBetweenPixels = 0.55;  ///< accepted where the step swings between two pixels: a second-order step to
                                         ///< a centre half-way between them is a little longer than 1/2 from either
constexpr double kFarthest =
    1.0;  ///< rows that the step may take the line off its initial point; beyond, the normal is wrong

struct Slopes
{
  const float *x, *y, *xx, *xy, *yy;
};

/// hessianNormal() of many sites, where there may be a maximum across: not where the larger eigenvalue is a valley's.
struct HessianNormals
{
  WELD_PROFILER_KERNEL static void run(Slopes at, int size, float* __restrict u, float* __restrict v)
  {
    for (int i = 0; i < size; ++i)
    {
      float across_u;
      float across_v;
      smallerAxis(at.xx[i] - at.yy[i], 2.0F * at.xy[i], across_u, across_v);
      const bool ridge = at.xx[i] + at.yy[i] < 0.0F;
      u[i] = ridge ? across_u : 0.0F;
      v[i] = ridge ? across_v : 0.0F;
    }
  }
};

struct Normals
{
  const float *u, *v;
};

/// taylorStep() of many sites; curvature 0 where there is no normal.
struct Steps
{
  WELD_PROFILER_KERNEL static void run(Slopes at, Normals normal, float* __restrict t, float* __restrict curvature,
                                       int size)
  {
    for (int i = 0; i < size; ++i)
    {
      const float u = normal.u[i];
      const float v = normal.v[i];
      curvature[i] = u * u * at.xx[i] + 2.0F * u * v * at.xy[i] + v * v * at.yy[i];
      t[i] = -(u * at.x[i] + v * at.y[i]) / curvature[i];
    }
  }
};
}  // namespace

TaylorStep taylorStep(const Derivatives& d, const TemplateNormal& n)
{
  TaylorStep step;
  const double slope = n.u * d.x + n.v * d.y;
  step.curvature = n.u * n.u * d.xx + 2.0 * n.u * n.v * d.xy + n.v * n.v * d.yy;
  step.maximum = step.curvature < 0.0;
  step.t = step.maximum ? -slope / step.curvature : 0.0;
  return step;
}

void TaylorSteps::settle(const Task& task, const Sites& sites, std::vector<Centre>& centres)
{
  begin(task, sites);
  for (int move = 0; move <= kMoves && !sites_.empty(); ++move)
  {
    measure(task);
    std::size_t left = 0;
    for (std::size_t i = 0; i < sites_.size(); ++i)
    {
      if (step(task, i, centres[sites_[i].centre]) != Outcome::Moved)
        continue;
      sites_[left] = sites_[i];
      before_[left] = before_[i];
      u_[left] = u_[i];
      v_[left] = v_[i];
      ++left;
    }
    sites_.resize(left);
  }
}

void TaylorSteps::begin(const Task& task, const Sites& sites)
{
  sites_.clear();
  for (std::vector<float>* values : { &u_, &v_, &t_, &curvature_ })
    values->resize(sites.size());
  before_.resize(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (!task.kernel.holds(task.image, sites[i].u, sites[i].v))
      continue;
    before_[sites_.size()] = sites[i].v;
    if (task.normals != nullptr)
    {
      u_[sites_.size()] = task.normals->u[i];
      v_[sites_.size()] = task.normals->v[i];
    }
    sites_.push_back(sites[i]);
  }
}

void TaylorSteps::measure(const Task& task)
{
  derivatives_.measure(task.image, task.kernel, sites_);
  const Slopes slopes{ derivatives_.x.data(), derivatives_.y.data(), derivatives_.xx.data(), derivatives_.xy.data(),
                       derivatives_.yy.data() };
  const auto size = static_cast<int>(sites_.size());
  if (task.normals == nullptr)
    dispatch<HessianNormals>(slopes, size, u_.data(), v_.data());
  dispatch<Steps>(slopes, Normals{ u_.data(), v_.data() }, t_.data(), curvature_.data(), size);
}

TaylorSteps::Outcome TaylorSteps::step(const Task& task, std::size_t i, Centre& centre)
{
  if (!(curvature_[i] < 0.0F))
    return Outcome::Failed;
  const double t = t_[i];
  const double u = u_[i];
  const double v = v_[i];
  Site& site = sites_[i];
  const int next = site.v + (t * v > 0.0 ? 1 : -1);
  const bool swings = next == before_[i];
  if (!(std::abs(t) <= (swings ? kBetweenPixels : kHalfPixel)))
  {
    before_[i] = site.v;
    site.v = next;
    return swings || !task.kernel.holds(task.image, site.u, next) ? Outcome::Failed : Outcome::Moved;
  }
  const double row = site.v + t * v - centre.slope * t * u;
  if (std::abs(row - centre.v) > kFarthest)
    return Outcome::Failed;
  centre.u = centre.cell + t * u;
  centre.v = site.v + t * v;
  centre.normal_u = u;
  centre.normal_v = v;
  const double sigma = task.noise * task.kernel.noiseGain() / -static_cast<double>(curvature_[i]);
  centre.read_sigma = sigma * std::sqrt(1.0 + centre.slope * centre.slope);
  return Outcome::Settled;
}
}  // namespace weld_profiler
