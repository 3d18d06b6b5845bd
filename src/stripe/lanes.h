#pragma once

#include <cstring>

#include "multiversion.h"

namespace weld_profiler
{
/// Eight neighbouring columns at once, for kernels whose sums the compiler would not keep in registers by itself. On a
/// path with narrower vectors the compiler takes two of them. Never a parameter or result by value: how it is passed
/// depends on the path.
constexpr int kLanes = 8;
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));

WELD_PROFILER_KERNEL void load(const float* from, Lanes& to)
{
  std::memcpy(&to, from, sizeof(to));
}

WELD_PROFILER_KERNEL void store(const Lanes& from, float* to)
{
  std::memcpy(to, &from, sizeof(from));
}
}  // namespace weld_profiler
