#include "comparison/simd_sum.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define WELD_PROFILER_X86 1
#endif

namespace weld_profiler
{
namespace comparison
{
namespace
{
std::uint64_t plainSum(const std::uint8_t* bytes, std::size_t count)
{
  constexpr std::size_t kBlock = 4096;  // 32 bits hold the sum of a block
  std::uint64_t sum = 0;
  for (std::size_t begin = 0; begin < count; begin += kBlock)
  {
    const std::size_t end = begin + kBlock < count ? begin + kBlock : count;
    std::uint32_t part = 0;
    for (std::size_t i = begin; i < end; ++i)
      part += bytes[i];
    sum += part;
  }
  return sum;
}

#ifdef WELD_PROFILER_X86
__attribute__((target("avx2"))) std::uint64_t avx2Sum(const std::uint8_t* bytes, std::size_t count)
{
  const __m256i zero = _mm256_setzero_si256();
  __m256i a = zero, b = zero, c = zero, d = zero;
  std::size_t i = 0;
  for (; i + 128 <= count; i += 128)
  {
    const auto* at = reinterpret_cast<const __m256i*>(bytes + i);
    a = _mm256_add_epi64(a, _mm256_sad_epu8(_mm256_loadu_si256(at), zero));
    b = _mm256_add_epi64(b, _mm256_sad_epu8(_mm256_loadu_si256(at + 1), zero));
    c = _mm256_add_epi64(c, _mm256_sad_epu8(_mm256_loadu_si256(at + 2), zero));
    d = _mm256_add_epi64(d, _mm256_sad_epu8(_mm256_loadu_si256(at + 3), zero));
  }
  a = _mm256_add_epi64(_mm256_add_epi64(a, b), _mm256_add_epi64(c, d));
  alignas(32) std::uint64_t lanes[4];
  _mm256_store_si256(reinterpret_cast<__m256i*>(lanes), a);
  return lanes[0] + lanes[1] + lanes[2] + lanes[3] + plainSum(bytes + i, count - i);
}

std::uint64_t sse2Sum(const std::uint8_t* bytes, std::size_t count)
{
  const __m128i zero = _mm_setzero_si128();
  __m128i a = zero, b = zero, c = zero, d = zero;
  std::size_t i = 0;
  for (; i + 64 <= count; i += 64)
  {
    const auto* at = reinterpret_cast<const __m128i*>(bytes + i);
    a = _mm_add_epi64(a, _mm_sad_epu8(_mm_loadu_si128(at), zero));
    b = _mm_add_epi64(b, _mm_sad_epu8(_mm_loadu_si128(at + 1), zero));
    c = _mm_add_epi64(c, _mm_sad_epu8(_mm_loadu_si128(at + 2), zero));
    d = _mm_add_epi64(d, _mm_sad_epu8(_mm_loadu_si128(at + 3), zero));
  }
  a = _mm_add_epi64(_mm_add_epi64(a, b), _mm_add_epi64(c, d));
  alignas(16) std::uint64_t lanes[2];
  _mm_store_si128(reinterpret_cast<__m128i*>(lanes), a);
  return lanes[0] + lanes[1] + plainSum(bytes + i, count - i);
}
#endif

using Sum = std::uint64_t (*)(const std::uint8_t*, std::size_t);

struct Path
{
  Sum sum;
  const char* name;
};

Path choose()
{
#ifdef WELD_PROFILER_X86
  if (__builtin_cpu_supports("avx2"))
    return Path{ avx2Sum, "AVX2" };
  return Path{ sse2Sum, "SSE2" };
#else
  return Path{ plainSum, "plain" };
#endif
}

const Path& path()
{
  static const Path chosen = choose();
  return chosen;
}
}  // namespace

std::uint64_t simdSum(const std::uint8_t* bytes, std::size_t count)
{
  return path().sum(bytes, count);
}

const char* simdSumPath()
{
  return path().name;
}
}  // namespace comparison
}  // namespace weld_profiler
