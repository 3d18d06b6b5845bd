#pragma once

#include <cstddef>
#include <vector>

namespace weld_profiler
{
namespace weld
{
/// Things sorted by the bin they lie in, within a bin in the order they came.
template <class Thing>
class Binned
{
public:
  /// @param each  calls its argument with bin and thing, for each thing; it is called twice.
  template <class Each>
  void fill(std::size_t bins, Each&& each)
  {
    first_.assign(bins + 1, 0);
    each([this](std::size_t bin, const Thing&) { ++first_[bin + 1]; });
    for (std::size_t bin = 1; bin < first_.size(); ++bin)
      first_[bin] += first_[bin - 1];
    things_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    each([this, &next](std::size_t bin, const Thing& thing) { things_[next[bin]++] = thing; });
  }

  /// Of the things in neighbouring bins, in order: from the first of one bin to behind the last of another.
  const Thing* begin(std::size_t bin) const { return things_.data() + first_[bin]; }
  const Thing* end(std::size_t bin) const { return things_.data() + first_[bin + 1]; }

private:
  std::vector<std::size_t> first_;  ///< of each bin, and one more
  std::vector<Thing> things_;
};
}  // namespace weld
}  // namespace weld_profiler
