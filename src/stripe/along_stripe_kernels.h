#pragma once

#include <algorithm>
#include <cmath>

#include "column_track.h"
#include "control_variates.h"
#include "lanes.h"
#include "multiversion.h"

namespace weld_profiler
{
// The loops of AlongStripe, one slot after another. Every array holds a value a slot.

/// sum[i] = values[i - lag] + values[i] + values[i + lag]; 27 neighbours are three times three times three.
struct SumOfThree
{
  WELD_PROFILER_KERNEL static void run(const float* __restrict values, int lag, int count, float* __restrict sum)
  {
    for (int i = lag; i < count - lag; ++i)
      sum[i] = values[i - lag] + values[i] + values[i + lag];
  }
};

struct LeverOfOne
{
  WELD_PROFILER_KERNEL static void run(const float* __restrict weights, int count, float* __restrict lever)
  {
    for (int i = 1; i < count - 1; ++i)
      lever[i] = weights[i + 1] - weights[i - 1];
  }
};

/// Sums of distances times weights, from those of the next shorter stretch.
struct LeverOfThree
{
  WELD_PROFILER_KERNEL static void run(const float* __restrict shorter, const float* __restrict weights, int lag,
                                       int count, float* __restrict lever)
  {
    const auto arm = static_cast<float>(lag);
    for (int i = lag; i < count - lag; ++i)
      lever[i] = shorter[i - lag] + shorter[i] + shorter[i + lag] + arm * (weights[i + lag] - weights[i - lag]);
  }
};

/// Mean of what a sum holds, moved along the line's slope to the middle where columns are missing on one side.
struct MeanOf
{
  WELD_PROFILER_KERNEL static void run(const float* __restrict sum, const float* __restrict weights,
                                       const float* __restrict lever, const float* __restrict slope, int count,
                                       float* __restrict mean)
  {
    for (int i = 0; i < count; ++i)
    {
      const float weight = weights[i] > 1.0F ? weights[i] : 1.0F;
      mean[i] = (sum[i] - slope[i] * lever[i]) / weight;
    }
  }
};

/// Mean of the columns held.
struct MeanHeld
{
  WELD_PROFILER_KERNEL static void run(const float* __restrict sum, const float* __restrict weights, int count,
                                       float* __restrict mean)
  {
    for (int i = 0; i < count; ++i)
      mean[i] = sum[i] / (weights[i] > 1.0F ? weights[i] : 1.0F);
  }
};

struct Settling
{
  WELD_PROFILER_KERNEL static void run(int count, const float* __restrict weight, const float* __restrict core,
                                       const float* __restrict spread, float* __restrict moved, float* __restrict wide)
  {
    constexpr float kLeast = 0.2F;
    constexpr float kMost = 2.0F;
    for (int i = 0; i < count; ++i)
    {
      float held = weight[i];
      float seen = spread[i];
      float shift = core[i];
      const float low = seen < kMost ? seen : kMost;
      const float square = low > kLeast ? low : kLeast;
      moved[i] = held > 0.0F ? shift : 0.0F;
      wide[i] = held > 0.0F ? square : 0.0F;
    }
  }
};

/// The reference line follows the columns; where nothing was measured it goes on as far off as it was around.
struct SettleReference
{
  struct In
  {
    int count;
    const float *sum3, *sum9, *sum27, *moved3, *moved9, *wide27;
    float *v, *sigma;
  };
  WELD_PROFILER_KERNEL static void run(In in)
  {
    constexpr int kGuard = ColumnTrack::kGuard;
    const float* __restrict sum3 = in.sum3;
    const float* __restrict sum9 = in.sum9;
    const float* __restrict sum27 = in.sum27;
    const float* __restrict moved3 = in.moved3;
    const float* __restrict moved9 = in.moved9;
    const float* __restrict wide27 = in.wide27;
    float* __restrict v = in.v;
    float* __restrict sigma = in.sigma;
    WELD_PROFILER_APART
    for (int i = kGuard; i < in.count - kGuard; ++i)
    {
      float n3 = sum3[i];
      float n9 = sum9[i];
      float n27 = sum27[i];
      const float near = moved3[i] / (n3 > 1.0F ? n3 : 1.0F);
      const float around = moved9[i] / (n9 > 1.0F ? n9 : 1.0F);
      const float square = wide27[i] / (n27 > 1.0F ? n27 : 1.0F);
      const float scale = n27 > 0.0F ? square : 1.0F;
      v[i] += n3 > 0.0F ? near : around;
      sigma[i] *= __builtin_sqrtf(scale);
    }
  }
};

/// Slope of the reference line and, of each column, the centre's row, what reflectance feigns of it, and flanks minus
/// core.
struct PrepareColumns
{
  struct In
  {
    int count;
    const float *v, *sigma, *light, *weight, *core, *flanks;
    float *slope, *held_slope, *feigned, *difference, *offset;
  };
  WELD_PROFILER_KERNEL static void run(In in)
  {
    const float* __restrict v = in.v;
    const float* __restrict sigma = in.sigma;
    const float* __restrict light = in.light;
    const float* __restrict weight = in.weight;
    const float* __restrict core = in.core;
    const float* __restrict flanks = in.flanks;
    float* __restrict slope = in.slope;
    float* __restrict held_slope = in.held_slope;
    float* __restrict feigned = in.feigned;
    float* __restrict difference = in.difference;
    float* __restrict offset = in.offset;
    WELD_PROFILER_APART
    for (int i = 4; i < in.count - 4; ++i)
    {
      const float rise = (v[i + 4] - v[i - 4]) * 0.125F;
      float held = weight[i];
      float held_before = weight[i - 1];
      float held_after = weight[i + 1];
      float here = light[i];
      float left = light[i - 1];
      float right = light[i + 1];
      float middle = core[i];
      const float apart = flanks[i] - middle;
      const float row = v[i] + middle;
      // At an end the column itself stands in for the neighbour that is missing.
      const float before = held_before > 0.0F ? left : here;
      const float after = held_after > 0.0F ? right : here;
      const float whole = (before + after) * (held_before + held_after);
      const float change = 2.0F * (after - before) / (whole > 1e-3F ? whole : 1e-3F);
      const float there = sigma[i] * sigma[i] * rise / (1.0F + rise * rise) * change;
      slope[i] = rise;
      held_slope[i] = held > 0.0F ? rise : 0.0F;
      feigned[i] = held > 0.0F ? there : 0.0F;
      difference[i] = held > 0.0F ? apart : 0.0F;
      offset[i] = held > 0.0F ? row : 0.0F;
    }
  }
};

/// Applies what was learnt, straight from the middle of one stretch to the middle of the next.
struct Correct
{
  WELD_PROFILER_KERNEL static void run(int count, int stretches, const StretchScatter* learnt,
                                       const float* __restrict feigned, const float* __restrict difference,
                                       float* __restrict offset)
  {
    constexpr int kStretch = ControlVariates::kStretch;
    for (int s = -1; s < stretches; ++s)
    {
      const StretchScatter& a = learnt[s < 0 ? 0 : s];
      const StretchScatter& b = learnt[s + 1 < stretches ? s + 1 : stretches - 1];
      const int begin = s * kStretch + kStretch / 2;
      const int first = begin < 0 ? 0 : begin;
      const int last = begin + kStretch < count ? begin + kStretch : count;
      for (int i = first; i < last; ++i)
      {
        const float share = static_cast<float>(i - begin) * (1.0F / kStretch);
        const float flanks = a.flanks + share * (b.flanks - a.flanks);
        const float there = a.feigned + share * (b.feigned - a.feigned);
        const float lean = a.lean + share * (b.lean - a.lean);
        offset[i] += flanks * (difference[i] - lean) - there * feigned[i];
      }
    }
  }
};

/// Farthest distance of a centre from the reference line, in half widths.
struct FarthestOff
{
  WELD_PROFILER_KERNEL static void run(int count, const float* held, const float* row, const float* v,
                                       const float* sigma, float* farthest)
  {
    constexpr int kGuard = ColumnTrack::kGuard;
    Lanes8 most{};
    for (int i = kGuard; i < count - kGuard; i += kLanes<Lanes8>)
    {
      Lanes8 columns, to, from, width;
      load(held + i, columns);
      load(row + i, to);
      load(v + i, from);
      load(sigma + i, width);
      const Lanes8 off = (to - from) / width;
      const Lanes8 size = off < 0.0F ? -off : off;
      const Lanes8 counted = columns > 0.0F ? size : Lanes8{};
      most = counted > most ? counted : most;
    }
    *farthest = 0.0F;
    for (int k = 0; k < kLanes<Lanes8>; ++k)
      *farthest = most[k] > *farthest ? most[k] : *farthest;
  }
};
}  // namespace weld_profiler

#include "aperture_kernels.h"
