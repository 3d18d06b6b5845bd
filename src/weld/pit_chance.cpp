#include "pit_chance.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kChance = 0.01;  // of one pit that outliers made in a scan
constexpr double kWidest = 6e-4;  // outliers are not wider in a row [m]
}  // namespace

bool PitChance::inOneRow(const std::vector<std::size_t>& pit) const
{
  const auto cells = static_cast<std::size_t>(grid_.cells);
  const auto [first, last] = std::minmax_element(pit.begin(), pit.end());
  return *first / cells == *last / cells;
}

void PitChance::look(const std::vector<std::size_t>& pit)
{
  const auto size = static_cast<double>(pit.size());
  if (pit.size() >= fewest_ && !(inOneRow(pit) && size * grid_.spacing < kWidest))
    return;
  count_ += 1.0;
  points_ += size;
}

bool PitChance::mayMake(const std::vector<std::size_t>& pit) const
{
  return inOneRow(pit) || count_ * std::exp(-static_cast<double>(pit.size()) * count_ / points_) > kChance;
}
}  // namespace weld
}  // namespace weld_profiler
