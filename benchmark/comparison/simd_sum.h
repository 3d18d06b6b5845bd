#pragma once

#include <cstddef>
#include <cstdint>

namespace weld_profiler
{
namespace comparison
{
/// The sum of bytes, as fast as this processor reads them: what the time of a frame is held against.
/// AVX2 or SSE2 (psadbw) on x86-64, chosen at run time; elsewhere what the compiler makes of the loop.
std::uint64_t simdSum(const std::uint8_t* bytes, std::size_t count);
/// Which of them simdSum() takes.
const char* simdSumPath();
}  // namespace comparison
}  // namespace weld_profiler
