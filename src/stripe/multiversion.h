#pragma once

#include <atomic>

/// Vector code with run-time dispatch. A kernel is a struct with a static function run() marked WELD_PROFILER_KERNEL,
/// of plain loops that the compiler vectorises, lanes being neighbouring columns:
///
///   struct RaiseTo
///   {
///     WELD_PROFILER_KERNEL static void run(const std::uint8_t* row, int count, std::uint8_t* __restrict highest)
///     {
///       for (int i = 0; i < count; ++i)
///         highest[i] = std::max(highest[i], row[i]);
///     }
///   };
///   dispatch<RaiseTo>(row, count, highest);
///
/// run() is compiled once for each path; whatever it calls in its loops must be WELD_PROFILER_KERNEL too, or a
/// function that is inlined anyway. Sums along a row do not vectorise (that would change their order); sums down the
/// rows do. Worth it from some hundred operations a call on. Other processors (ARM has its vectors always) and
/// compilers have the plain path only.
#if defined(__GNUC__)
#define WELD_PROFILER_KERNEL inline __attribute__((always_inline))
#else
#define WELD_PROFILER_KERNEL inline
#endif

/// Before a loop over arrays that do not overlap, where they are too many for the compiler to test that at run time.
#if defined(__clang__)
#define WELD_PROFILER_APART _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define WELD_PROFILER_APART _Pragma("GCC ivdep")
#else
#define WELD_PROFILER_APART
#endif

#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
#define WELD_PROFILER_AVX2 __attribute__((target("avx2,fma")))
#else
#define WELD_PROFILER_AVX2
#endif

namespace weld_profiler
{
/// What a kernel is compiled for. Results differ by rounding alone: the wider path multiplies and adds in one.
enum class VectorPath
{
  Plain,  ///< what every processor of the architecture has
  Avx2    ///< with FMA
};

/// The widest that this processor has.
inline VectorPath widestVectorPath()
{
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return VectorPath::Avx2;
#endif
  return VectorPath::Plain;
}

/// The path that dispatch() takes, in all threads: the widest, until a test or benchmark that compares paths sets
/// another.
inline std::atomic<VectorPath>& vectorPath()
{
  static std::atomic<VectorPath> path{ widestVectorPath() };
  return path;
}

template <class Kernel, class... Arguments>
WELD_PROFILER_AVX2 void runAvx2(Arguments... arguments)
{
  Kernel::run(arguments...);
}

/// Runs a kernel on the widest path. Arguments are copied: pointers, numbers, small structs of them.
template <class Kernel, class... Arguments>
void dispatch(Arguments... arguments)
{
  if (vectorPath().load(std::memory_order_relaxed) == VectorPath::Avx2)
    runAvx2<Kernel>(arguments...);
  else
    Kernel::run(arguments...);
}
}  // namespace weld_profiler
