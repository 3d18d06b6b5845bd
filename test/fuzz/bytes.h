#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace weld_profiler
{
namespace fuzz
{
/// Decisions out of a fuzzer's bytes; zeros when they are used up, so that every input means something.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  std::uint8_t next()
  {
    if (left_ == 0)
      return 0;
    --left_;
    return *data_++;
  }

  /// low <= result <= high
  int between(int low, int high)
  {
    const unsigned range = static_cast<unsigned>(high - low) + 1U;
    unsigned value = next();
    if (range > 256U)
      value = value << 8U | next();
    return low + static_cast<int>(value % range);
  }

  /// low <= result <= high
  double real(double low, double high) { return low + (high - low) * next() / 255.0; }
  bool oneIn(int count) { return between(0, count - 1) == count - 1; }

  template <class Item, std::size_t kCount>
  const Item& pick(const Item (&items)[kCount])
  {
    return items[between(0, static_cast<int>(kCount) - 1)];
  }

private:
  const std::uint8_t* data_;
  std::size_t left_;
};
}  // namespace fuzz
}  // namespace weld_profiler
