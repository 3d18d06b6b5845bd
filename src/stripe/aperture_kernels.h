#pragma once

#include "column_track.h"
#include "control_variates.h"
#include "multiversion.h"

namespace weld_profiler
{
/// A value as far as it is sure, from its variance: none of it below two of its sigmas (positive-part James-Stein).
WELD_PROFILER_KERNEL float sureOf(float value, float variance)
{
  const float square = value * value;
  const float rest = 1.0F - 4.0F * variance / (square > 1e-20F ? square : 1e-20F);
  return value * (rest > 0.0F ? rest : 0.0F);
}

WELD_PROFILER_KERNEL float most(float a, float b)
{
  return a > b ? a : b;
}

WELD_PROFILER_KERNEL float least(float a, float b)
{
  return a < b ? a : b;
}

/// Takes off the means over 3, 9 and 27 columns what the line's curvature adds to them, and compares them.
struct TakeBend
{
  struct In
  {
    int count;
    const StretchScatter* learnt;
    const float *n3, *n9, *m3, *m9, *m27;
    float *c3, *c9, *c27, *bend, *square9, *square27;
  };
  WELD_PROFILER_KERNEL static void run(In in)
  {
    constexpr int kStretch = ControlVariates::kStretch;
    constexpr int kReach = 24;
    for (int begin = kReach; begin < in.count - kReach;)
    {
      const int stretch = begin / kStretch;
      const int next = (stretch + 1) * kStretch;
      const int end = next < in.count - kReach ? next : in.count - kReach;
      take(in, begin, end, in.learnt[stretch].variance);
      begin = end;
    }
  }

  /// Half the variance of 3, 9, 27 evenly spread columns times the second derivative is what curvature adds.
  WELD_PROFILER_KERNEL static void take(const In& in, int begin, int end, float v3)
  {
    const float* __restrict n3 = in.n3;
    const float* __restrict n9 = in.n9;
    const float* __restrict m3 = in.m3;
    const float* __restrict m9 = in.m9;
    const float* __restrict m27 = in.m27;
    float* __restrict c3 = in.c3;
    float* __restrict c9 = in.c9;
    float* __restrict c27 = in.c27;
    float* __restrict bend = in.bend;
    float* __restrict square9 = in.square9;
    float* __restrict square27 = in.square27;
    WELD_PROFILER_APART
    for (int i = begin; i < end; ++i)
    {
      const float near = (m3[i - 3] - 2.0F * m3[i] + m3[i + 3]) * (1.0F / 9.0F);
      const float wide = (m9[i - 9] - 2.0F * m9[i] + m9[i + 9]) * (1.0F / 81.0F);
      const float widest = (m9[i - 18] - 2.0F * m9[i] + m9[i + 18]) * (1.0F / 324.0F);
      const float held3 = n3[i - 3] + n3[i] + n3[i + 3];
      const float held9 = least(n9[i - 9], least(n9[i], n9[i + 9]));
      const float held27 = least(n9[i - 18], least(n9[i], n9[i + 18]));
      const float sure3 = sureOf(near, v3 * (6.0F / 81.0F));
      const float sure9 = sureOf(wide, v3 * (2.0F / 6561.0F));
      const float sure27 = sureOf(widest, v3 * (2.0F / 104976.0F));
      const float bend3 = held3 > 8.5F ? sure3 : 0.0F;
      const float bend9 = held9 > 4.5F ? sure9 : 0.0F;
      const float bend27 = held27 > 4.5F ? sure27 : 0.0F;
      const float mean3 = m3[i] - (1.0F / 3.0F) * bend3;
      const float mean9 = m9[i] - (10.0F / 3.0F) * bend9;
      const float mean27 = m27[i] - (91.0F / 3.0F) * bend27;
      const float d9 = mean3 - mean9;
      const float d27 = mean9 - mean27;
      float held = n3[i];
      const float both9 = d9 * d9;
      const float both27 = d27 * d27;
      c3[i] = mean3;
      c9[i] = mean9;
      c27[i] = mean27;
      bend[i] = held27 > 4.5F ? bend27 : bend9;
      square9[i] = held > 0.0F ? both9 : 0.0F;
      square27[i] = held > 0.0F ? both27 : 0.0F;
    }
  }
};

/// Joins the three means, see AlongStripe::join().
struct ChooseAperture
{
  struct In
  {
    int count;
    int max_aperture;
    const StretchScatter* learnt;
    const float* growth;
    const float *weight, *width, *slope, *n3, *n9, *n27, *n81, *c3, *c9, *c27, *seen9, *seen27, *bend, *difference;
    float *row, *sigma, *aperture;
  };
  WELD_PROFILER_KERNEL static void run(In in)
  {
    constexpr int kStretch = ControlVariates::kStretch;
    constexpr int kGuard = ColumnTrack::kGuard;
    for (int begin = kGuard; begin < in.count - kGuard;)
    {
      const int stretch = begin / kStretch;
      const int next = (stretch + 1) * kStretch;
      const int end = next < in.count - kGuard ? next : in.count - kGuard;
      // straight from border to border of the stretches: a step would show in the outline
      const float here = in.growth[stretch];
      const float before = stretch > 0 ? in.growth[stretch - 1] : here;
      const float after = next < in.count ? in.growth[stretch + 1] : here;
      const float change = 0.5F * (after - before) / kStretch;
      choose(in, begin, end, in.learnt[stretch],
             Growth{ 0.5F * (before + here) + change * static_cast<float>(begin - stretch * kStretch), change });
      begin = end;
    }
  }

  struct Growth
  {
    float first, change;  ///< at the first slot, from slot to slot
  };

  /// Share of the shorter mean, from the squared difference seen and that which noise makes.
  WELD_PROFILER_KERNEL static float shareOf(float seen, float noise)
  {
    constexpr float kTau = 2.2F;
    constexpr float kFull = 1.05F;  // a clear difference takes the shorter mean alone
    const float share = kFull * (1.0F - kTau * noise / (seen > 1e-20F ? seen : 1e-20F));
    return share < 0.0F ? 0.0F : (share > 1.0F ? 1.0F : share);
  }

  WELD_PROFILER_KERNEL static void choose(const In& in, int begin, int end, const StretchScatter& learnt,
                                          const Growth& growing)
  {
    constexpr float kAlone = 1.0F / 9.0F;  // what one column's own difference counts for beside the mean around it
    constexpr float kSeenByChance = 1.4F;
    constexpr float kSkew = 0.8F;  // of a column's cut through a curved, oblique stripe
    // What taking off the curvature, itself a difference of means over 9 columns, adds to the variance of a mean: that
    // of 9 columns is (1 + 2 * 10 / 243, -10 / 243 twice) of them, that of 27 (1 / 3 + 2 * 91 / 972, 1 / 3 twice, -91 /
    // 972 twice).
    constexpr float kBent9 = 1.175F;
    constexpr float kBent27 = 1.53F;
    constexpr float kGrowing = 1.6F;     // of a column's cut through an oblique stripe that becomes wider
    constexpr float kDisturbed = 16.0F;  // flanks and core differ by four sigmas
    const float v3 = learnt.variance;
    const float told = learnt.told;
    const float grain = learnt.grain;
    const float lean = learnt.lean;
    const float disturbing = kDisturbed * learnt.difference;
    const float noise9 = (1.0F - learnt.grain / 3.0F) * v3;
    const float noise27 = (2.0F / 9.0F) * learnt.grain * v3;
    const float only3 = in.max_aperture < 9 ? 1.0F : 0.0F;
    const float only9 = in.max_aperture < 27 ? 1.0F : 0.0F;
    const float* __restrict weights = in.weight;
    const float* __restrict widths = in.width;
    const float* __restrict slopes = in.slope;
    const float* __restrict differences = in.difference;
    const float* __restrict held3 = in.n3;
    const float* __restrict held9 = in.n9;
    const float* __restrict held27 = in.n27;
    const float* __restrict held81 = in.n81;
    const float* __restrict mean3 = in.c3;
    const float* __restrict mean9 = in.c9;
    const float* __restrict mean27 = in.c27;
    const float* __restrict sum9 = in.seen9;
    const float* __restrict sum27 = in.seen27;
    const float* __restrict bends = in.bend;
    float* __restrict row = in.row;
    float* __restrict sigma = in.sigma;
    float* __restrict aperture = in.aperture;
    WELD_PROFILER_APART
    for (int i = begin; i < end; ++i)
    {
      float c3 = mean3[i];
      float c9 = mean9[i];
      float c27 = mean27[i];
      const float n3 = most(held3[i], 1.0F);
      const float n9 = most(held9[i], 1.0F);
      const float n27 = most(held27[i], 1.0F);
      const float n81 = most(held81[i], 1.0F);
      const float d9 = c3 - c9;
      const float d27 = c9 - c27;
      const float around9 = sum9[i] / n27;
      const float around27 = sum27[i] / n81;
      const float seen9 = most(around9, kAlone * d9 * d9);
      const float seen27 = most(around27, kAlone * d27 * d27);
      const float chosen3 = shareOf(seen9, noise9);
      const float chosen9 = shareOf(seen27, noise27);
      const float share3 = most(chosen3, only3);
      const float share9 = most(chosen9, only9);
      const float longer = c27 + share9 * d27;
      const float middle = longer + share3 * (c3 - longer);
      const float bend = bends[i];
      const float more9 = bend != 0.0F ? kBent9 : 1.0F;
      const float more27 = bend != 0.0F ? kBent27 : 1.0F;
      const float p9 = more9 * grain / n9;
      const float p27 = more27 * grain / n27;
      const float p_longer = p27 + share9 * share9 * (p9 - p27);
      const float p = p_longer + share3 * share3 * (1.0F / n3 - p_longer);
      const float left9 = most(seen9 - kSeenByChance * noise9, 0.0F);
      const float left27 = most(seen27 - kSeenByChance * noise27, 0.0F);
      const float bias = (1.0F - share3) * (1.0F - share3) * (left9 + (1.0F - share9) * (1.0F - share9) * left27);
      float width = widths[i];
      float slope = slopes[i];
      const float growth = growing.first + growing.change * static_cast<float>(i - begin);
      const float square = slope * slope;
      const float part = 1.0F / (1.0F + square);
      const float skew = (kSkew * bend * square * part + kGrowing * growth * slope) * part * width * width;
      const float off = differences[i] - lean;
      const float apart = off * off;
      const float half = 0.5F * apart;
      const float disturbed = apart > disturbing ? half : 0.0F;
      const float columns9 = share9 >= 1.0F ? n9 : n27;
      const float columns = share3 >= 1.0F ? n3 : columns9;
      float held = weights[i];
      row[i] = middle - skew;
      sigma[i] = __builtin_sqrtf(3.0F * told * p + bias + disturbed);
      aperture[i] = held > 0.0F ? columns : 0.0F;
    }
  }
};
}  // namespace weld_profiler
