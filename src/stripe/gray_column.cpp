#include "gray_column.h"

namespace weld_profiler
{
namespace
{
template <class Pixel>
void read(const ImageView& image, const Levels& levels, const Centre& centre, GrayColumn& column)
{
  for (int i = 0; i < column.size(); ++i)
  {
    const int v = column.first_row + i;
    const double level = image.row<Pixel>(v)[centre.cell];
    const auto at = static_cast<std::size_t>(i);
    column.gray[at] = std::min(level, levels.saturation) - centre.background - centre.gradient * (v - centre.v);
    column.clipped[at] = level >= levels.saturation ? 1 : 0;
  }
}
}  // namespace

void readColumn(const ImageView& image, const Levels& levels, const Centre& centre, int middle, int half,
                GrayColumn& column)
{
  column.first_row = std::max(0, middle - half);
  const int last = std::min(image.height - 1, middle + half);
  const auto rows = static_cast<std::size_t>(std::max(0, last - column.first_row + 1));
  column.gray.resize(rows);
  column.clipped.resize(rows);
  withPixel(image, [&](auto pixel) { read<decltype(pixel)>(image, levels, centre, column); });
}
}  // namespace weld_profiler
