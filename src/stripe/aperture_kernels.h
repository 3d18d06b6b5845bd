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
    for (int i = begin; i < end; ++i)
    {
      const float near = (m3[i - 3] - 2.0F * m3[i] + m3[i + 3]) * (1.0F / 9.0F);
      const float wide = (m9[i - 9] - 2.0F * m9[i] + m9[i + 9]) * (1.0F / 81.0F);
      const float widest = (m9[i - 18] - 2.0F * m9[i] + m9[i + 18]) * (1.0F / 324.0F);
      const float bend3 = n3[i - 3] + n3[i] + n3[i + 3] > 8.5F ? sureOf(near, v3 * (6.0F / 81.0F)) : 0.0F;
      const bool holds9 = n9[i - 9] > 4.5F && n9[i] > 4.5F && n9[i + 9] > 4.5F;
      const bool holds27 = n9[i - 18] > 4.5F && n9[i] > 4.5F && n9[i + 18] > 4.5F;
      const float bend9 = holds9 ? sureOf(wide, v3 * (2.0F / 6561.0F)) : 0.0F;
      const float bend27 = holds27 ? sureOf(widest, v3 * (2.0F / 104976.0F)) : 0.0F;
      c3[i] = m3[i] - (1.0F / 3.0F) * bend3;
      c9[i] = m9[i] - (10.0F / 3.0F) * bend9;
      c27[i] = m27[i] - (91.0F / 3.0F) * bend27;
      bend[i] = holds27 ? bend27 : bend9;
      const float d9 = c3[i] - c9[i];
      const float d27 = c9[i] - c27[i];
      square9[i] = n3[i] > 0.0F ? d9 * d9 : 0.0F;
      square27[i] = n3[i] > 0.0F ? d27 * d27 : 0.0F;
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
      choose(in, begin, end, in.learnt[stretch]);
      begin = end;
    }
  }

  /// Share of the shorter mean, from the squared difference seen and that which noise makes.
  WELD_PROFILER_KERNEL static float shareOf(float seen, float noise)
  {
    constexpr float kTau = 2.2F;
    constexpr float kFull = 1.05F;  // a clear difference takes the shorter mean alone
    const float share = kFull * (1.0F - kTau * noise / (seen > 1e-20F ? seen : 1e-20F));
    return share < 0.0F ? 0.0F : (share > 1.0F ? 1.0F : share);
  }

  WELD_PROFILER_KERNEL static void choose(const In& in, int begin, int end, const StretchScatter& learnt)
  {
    constexpr float kAlone = 1.0F / 9.0F;  // what one column's own difference counts for beside the mean around it
    constexpr float kSeenByChance = 1.4F;
    constexpr float kSkew = 0.8F;          // of a column's cut through a curved, oblique stripe
    constexpr float kDisturbed = 9.0F;     // flanks and core differ by three sigmas
    const float v3 = learnt.variance;
    const float noise9 = (1.0F - learnt.grain / 3.0F) * v3;
    const float noise27 = (2.0F / 9.0F) * learnt.grain * v3;
    const float only3 = in.max_aperture < 9 ? 1.0F : 0.0F;
    const float only9 = in.max_aperture < 27 ? 1.0F : 0.0F;
    const float* __restrict c3 = in.c3;
    const float* __restrict c9 = in.c9;
    const float* __restrict c27 = in.c27;
    float* __restrict row = in.row;
    float* __restrict sigma = in.sigma;
    float* __restrict aperture = in.aperture;
    for (int i = begin; i < end; ++i)
    {
      const float n3 = in.n3[i] > 1.0F ? in.n3[i] : 1.0F;
      const float n9 = in.n9[i] > 1.0F ? in.n9[i] : 1.0F;
      const float n27 = in.n27[i] > 1.0F ? in.n27[i] : 1.0F;
      const float n81 = in.n81[i] > 1.0F ? in.n81[i] : 1.0F;
      const float d9 = c3[i] - c9[i];
      const float d27 = c9[i] - c27[i];
      const float around9 = in.seen9[i] / n27;
      const float around27 = in.seen27[i] / n81;
      const float seen9 = around9 > kAlone * d9 * d9 ? around9 : kAlone * d9 * d9;
      const float seen27 = around27 > kAlone * d27 * d27 ? around27 : kAlone * d27 * d27;
      const float chosen3 = shareOf(seen9, noise9);
      const float chosen9 = shareOf(seen27, noise27);
      const float share3 = chosen3 > only3 ? chosen3 : only3;
      const float share9 = chosen9 > only9 ? chosen9 : only9;
      const float longer = c27[i] + share9 * d27;
      const float middle = longer + share3 * (c3[i] - longer);
      const float p9 = learnt.grain / n9;
      const float p27 = learnt.grain / n27;
      const float p_longer = p27 + share9 * share9 * (p9 - p27);
      const float p = p_longer + share3 * share3 * (1.0F / n3 - p_longer);
      const float left9 = seen9 > kSeenByChance * noise9 ? seen9 - kSeenByChance * noise9 : 0.0F;
      const float left27 = seen27 > kSeenByChance * noise27 ? seen27 - kSeenByChance * noise27 : 0.0F;
      const float bias = (1.0F - share3) * (1.0F - share3) * (left9 + (1.0F - share9) * (1.0F - share9) * left27);
      const float square = in.slope[i] * in.slope[i];
      const float skew = kSkew * in.bend[i] * square / ((1.0F + square) * (1.0F + square)) * in.width[i] * in.width[i];
      const float off = in.difference[i] - learnt.lean;
      const float apart = off * off;
      const float disturbed = apart > kDisturbed * learnt.difference ? 0.5F * apart : 0.0F;
      const float columns = share3 >= 1.0F ? n3 : (share9 >= 1.0F ? n9 : n27);
      row[i] = middle - skew;
      sigma[i] = __builtin_sqrtf(3.0F * learnt.told * p + bias + disturbed);
      aperture[i] = in.weight[i] > 0.0F ? columns : 0.0F;
    }
  }
};
}  // namespace weld_profiler
