#include "group_sums.h"

#include <algorithm>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "multiversion.h"
#include "pixels.h"

namespace weld_profiler
{
namespace
{
constexpr int kLanes = 16;  // groups that a step works on at once

/// Where rows are skipped the processor does not guess the next one by itself.
void fetch(const std::uint8_t* bytes, std::size_t count)
{
  constexpr std::size_t kLine = 64;
  for (std::size_t i = 0; i < count; i += kLine)
    __builtin_prefetch(bytes + i);
}

template <class Pixel>
std::uint16_t sumOf(const Pixel* pixels, int shift)
{
  std::uint32_t sum = 0;
  for (int k = 0; k < kGroup; ++k)
    sum += pixels[k];
  return static_cast<std::uint16_t>(sum >> shift);
}

#if defined(__SSE2__)
/// Eight bytes each, in order; all but the last few groups of a row.
int sumPlain(const std::uint8_t* pixels, int groups, std::uint16_t* sums)
{
  const __m128i zero = _mm_setzero_si128();
  int group = 0;
  for (; group + 8 <= groups; group += 8)
  {
    const auto* from = reinterpret_cast<const __m128i*>(pixels + static_cast<std::ptrdiff_t>(group) * kGroup);
    const auto sad = [&](int i) { return _mm_sad_epu8(_mm_loadu_si128(from + i), zero); };
    const __m128i low = _mm_packs_epi32(sad(0), sad(1));
    const __m128i high = _mm_packs_epi32(sad(2), sad(3));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(sums + group), _mm_packs_epi32(low, high));
  }
  return group;
}

WELD_PROFILER_AVX2 int sumAvx2(const std::uint8_t* pixels, int groups, std::uint16_t* sums)
{
  const __m256i zero = _mm256_setzero_si256();
  const __m256i order = _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7);
  int group = 0;
  for (; group + 16 <= groups; group += 16)
  {
    const auto* from = reinterpret_cast<const __m256i*>(pixels + static_cast<std::ptrdiff_t>(group) * kGroup);
    const __m256i a = _mm256_sad_epu8(_mm256_loadu_si256(from), zero);
    const __m256i b = _mm256_sad_epu8(_mm256_loadu_si256(from + 1), zero);
    const __m256i c = _mm256_sad_epu8(_mm256_loadu_si256(from + 2), zero);
    const __m256i d = _mm256_sad_epu8(_mm256_loadu_si256(from + 3), zero);
    const __m256i mixed = _mm256_packs_epi32(_mm256_packs_epi32(a, b), _mm256_packs_epi32(c, d));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(sums + group), _mm256_permutevar8x32_epi32(mixed, order));
  }
  return group;
}

int sumWide(const std::uint8_t* pixels, int groups, std::uint16_t* sums)
{
  return vectorPath() == VectorPath::Avx2 ? sumAvx2(pixels, groups, sums) : sumPlain(pixels, groups, sums);
}
#else
int sumWide(const std::uint8_t* /*pixels*/, int /*groups*/, std::uint16_t* /*sums*/)
{
  return 0;
}
#endif

int sumWide(const std::uint16_t* /*pixels*/, int /*groups*/, std::uint16_t* /*sums*/)
{
  return 0;
}
}  // namespace

template <class Pixel>
void GroupSums::sumRow(const Pixel* pixels, std::uint16_t* sums) const
{
  for (int group = sumWide(pixels, groups_ - 1, sums); group + 1 < groups_; ++group)
    sums[group] = sumOf(pixels + static_cast<std::ptrdiff_t>(group) * kGroup, shift_);
  sums[groups_ - 1] = sumOf(pixels + last_column_, shift_);
}

void GroupSums::layOut(const ImageView& image, int row_step)
{
  groups_ = (image.width + kGroup - 1) / kGroup;
  rows_ = (image.height + row_step - 1) / row_step;
  row_step_ = row_step;
  last_column_ = image.width - kGroup;
  shift_ = image.bit_depth == 8 ? 0 : 3;
  per_level_ = static_cast<float>(kGroup) / static_cast<float>(1 << shift_);
  const int padded = (groups_ + kLanes - 1) / kLanes * kLanes;
  stride_ = static_cast<std::size_t>(padded);
  sums_.resize(stride_ * static_cast<std::size_t>(rows_));
}

void GroupSums::sum(const ImageView& image, int first, int last, int every)
{
  const std::size_t row_bytes = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.bit_depth / 8);
  withPixel(image,
            [&](auto pixel)
            {
              for (int i = first; i < last; i += every)
              {
                if (i + every < last)
                  fetch(image.data + static_cast<std::size_t>((i + every) * row_step_) * image.step, row_bytes);
                sumRow(image.row<decltype(pixel)>(i * row_step_), sums_.data() + static_cast<std::size_t>(i) * stride_);
              }
            });
}
}  // namespace weld_profiler
