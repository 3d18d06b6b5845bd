#include "column_medians.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr int kLanes = 8;
using Lanes = Eigen::Array<float, kLanes, 1>;
using Block = std::array<Lanes, kMostMedianRows>;

void exchange(Lanes& a, Lanes& b)
{
  const Lanes least = a.min(b);
  b = a.max(b);
  a = least;
}

void sortRows(Block& block)
{
  for (std::size_t p = 1; p < block.size(); p *= 2)
    for (std::size_t k = p; k >= 1; k /= 2)
      for (std::size_t j = k % p; j + k < block.size(); j += 2 * k)
        for (std::size_t i = j; i < std::min(j + k, block.size() - k); ++i)
          if (i / (2 * p) == (i + k) / (2 * p))
            exchange(block[i], block[i + k]);
}
}  // namespace

void columnMedians(const std::vector<const float*>& rows, std::size_t columns, std::vector<double>& medians)
{
  medians.assign(columns, std::numeric_limits<double>::quiet_NaN());
  Block block;
  const int all = static_cast<int>(columns);
  for (int first = 0; first < all; first += kLanes)
  {
    double* const told = medians.data() + first;
    const int lanes = std::min(kLanes, all - first);
    block.fill(Lanes::Constant(std::numeric_limits<float>::infinity()));
    std::array<int, kLanes> count{};
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (int lane = 0; lane < lanes; ++lane)
      {
        const float value = rows[row][first + lane];
        if (!std::isfinite(value))
          continue;
        block[row][lane] = value;
        ++count[static_cast<std::size_t>(lane)];
      }
    sortRows(block);  // what is not there comes last
    for (int lane = 0; lane < lanes; ++lane)
    {
      const int found = count[static_cast<std::size_t>(lane)];
      if (found == 0)
        continue;
      const auto middle = static_cast<std::size_t>(found / 2);
      const auto above = static_cast<double>(block[middle][lane]);
      told[lane] = found % 2 == 1 ? above : 0.5 * (above + static_cast<double>(block[middle - 1][lane]));
    }
  }
}
}  // namespace weld
}  // namespace weld_profiler
