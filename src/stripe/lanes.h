#pragma once

#include <cstdint>
#include <cstring>

#include "multiversion.h"

namespace weld_profiler
{
/// Neighbouring columns at once, for kernels whose sums the compiler would not keep in registers by itself; as many as
/// a register of the path holds. Never a parameter or result by value: how it is passed depends on the path.
using Lanes4 = float __attribute__((vector_size(4 * sizeof(float))));
using Lanes8 = float __attribute__((vector_size(8 * sizeof(float))));

constexpr int kMostLanes = 8;

template <class Lanes>
constexpr int kLanes = static_cast<int>(sizeof(Lanes) / sizeof(float));

template <class Lanes>
WELD_PROFILER_KERNEL void load(const float* from, Lanes& to)
{
  std::memcpy(&to, from, sizeof(to));
}

template <class Lanes>
WELD_PROFILER_KERNEL void store(const Lanes& from, float* to)
{
  std::memcpy(to, &from, sizeof(from));
}

/// Grey levels of neighbouring pixels.
template <class Pixel, class Lanes>
WELD_PROFILER_KERNEL void loadPixels(const Pixel* from, Lanes& to)
{
  typedef Pixel Raw __attribute__((vector_size(kLanes<Lanes> * sizeof(Pixel))));
  typedef std::int32_t Whole __attribute__((vector_size(kLanes<Lanes> * sizeof(std::int32_t))));
  Raw raw;
  std::memcpy(&raw, from, sizeof(raw));
  to = __builtin_convertvector(__builtin_convertvector(raw, Whole), Lanes);
}

template <class Kernel>
struct InEightLanes
{
  template <class... Arguments>
  WELD_PROFILER_KERNEL static void run(Arguments... arguments)
  {
    Kernel::template run<Lanes8>(arguments...);
  }
};

/// dispatch() for a kernel whose run() is a template of the lanes.
template <class Kernel, class... Arguments>
void dispatchLanes(Arguments... arguments)
{
  if (vectorPath().load(std::memory_order_relaxed) == VectorPath::Avx2)
    runAvx2<InEightLanes<Kernel>>(arguments...);
  else
    Kernel::template run<Lanes4>(arguments...);
}
}  // namespace weld_profiler
