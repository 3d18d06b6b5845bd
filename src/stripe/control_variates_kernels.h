#pragma once

#include "lanes.h"
#include "multiversion.h"

namespace weld_profiler
{
// The loops of ControlVariates, over slots.
namespace control_variates
{
constexpr int kReach = 15;  // slots that a fifth difference reaches to either side
constexpr float kUnknown = 1e9F;
constexpr double kFew = 4.0;

struct RoughnessOf
{
  WELD_PROFILER_KERNEL static void run(const float* __restrict values, const float* __restrict columns, int count,
                                       float* __restrict rough)
  {
    constexpr float kScale = 1.0F / 15.874508F;  // variance of one value: 1 / sqrt(252)
    constexpr float kWhole = 3.0F * 6.0F - 0.5F;
    for (int i = kReach; i < count - kReach; ++i)
    {
      const float held =
          columns[i - 15] + columns[i - 9] + columns[i - 3] + columns[i + 3] + columns[i + 9] + columns[i + 15];
      const float value = (values[i - 15] - values[i + 15]) - 5.0F * (values[i - 9] - values[i + 9]) +
                          10.0F * (values[i - 3] - values[i + 3]);
      rough[i] = held > kWhole ? value * kScale : kUnknown;
    }
  }
};

/// Fifth differences of single columns that lie side by side.
struct FinenessOf
{
  WELD_PROFILER_KERNEL static void run(const float* __restrict values, int count, float* __restrict fine)
  {
    constexpr float kScale = 1.0F / 15.874508F;
    for (int i = kReach; i < count - kReach; ++i)
      fine[i] = ((values[i - 2] - values[i + 3]) - 5.0F * (values[i - 1] - values[i + 2]) +
                 10.0F * (values[i] - values[i + 1])) *
                kScale;
  }
};

struct MagnitudeOf
{
  WELD_PROFILER_KERNEL static void run(const float* values, int begin, int end, double* mean)
  {
    Lanes8 sums{};
    Lanes8 counts{};
    const Lanes8 one = Lanes8{} + 1.0F;
    for (int i = begin; i + kLanes<Lanes8> <= end; i += kLanes<Lanes8>)
    {
      Lanes8 value;
      load(values + i, value);
      const Lanes8 size = value < 0.0F ? -value : value;
      sums += size < 0.5F * kUnknown ? size : Lanes8{};
      counts += size < 0.5F * kUnknown ? one : Lanes8{};
    }
    double sum = 0.0;
    double count = 0.0;
    for (int k = 0; k < kLanes<Lanes8>; ++k)
    {
      sum += sums[k];
      count += counts[k];
    }
    *mean = count >= kFew ? sum / count : 0.0;
  }
};

struct MomentsOf
{
  static constexpr int kSums = 12;
  struct In
  {
    const float *e, *f, *d, *lean, *fine, *uneven, *light, *width;
    int begin, end;
    float most_e, most_d;
  };
  WELD_PROFILER_KERNEL static void run(In in, double* moments)
  {
    Lanes8 sums[kSums] = {};
    for (int i = in.begin; i + kLanes<Lanes8> <= in.end; i += kLanes<Lanes8>)
    {
      Lanes8 e, f, d, lean, fine, uneven, light, width;
      load(in.e + i, e);
      load(in.f + i, f);
      load(in.d + i, d);
      load(in.lean + i, lean);
      load(in.fine + i, fine);
      load(in.uneven + i, uneven);
      load(in.light + i, light);
      load(in.width + i, width);
      const Lanes8 one = Lanes8{} + 1.0F;
      const Lanes8 near = e < in.most_e ? one : Lanes8{};
      const Lanes8 nearer = e > -in.most_e ? near : Lanes8{};
      const Lanes8 close = d < in.most_d ? nearer : Lanes8{};
      const Lanes8 used = d > -in.most_d ? close : Lanes8{};
      e = used > 0.0F ? e : Lanes8{};
      f = used > 0.0F ? f : Lanes8{};
      d = used > 0.0F ? d : Lanes8{};
      fine = used > 0.0F ? fine : Lanes8{};
      uneven = used > 0.0F ? uneven : Lanes8{};
      sums[0] += used;
      sums[1] += e * e;
      sums[2] += e * f;
      sums[3] += e * d;
      sums[4] += f * f;
      sums[5] += f * d;
      sums[6] += d * d;
      sums[7] += used * lean;
      sums[8] += fine * fine;
      sums[9] += uneven * uneven;
      sums[10] += used * light;
      sums[11] += used * width * width;
    }
    for (int s = 0; s < kSums; ++s)
    {
      moments[s] = 0.0;
      for (int k = 0; k < kLanes<Lanes8>; ++k)
        moments[s] += sums[s][k];
    }
  }
};
}  // namespace control_variates
}  // namespace weld_profiler
