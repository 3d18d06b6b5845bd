#include "weld_profiler/scan/csv.h"

#include <limits>
#include <locale>

#include "weld_profiler/scan/cloud_record.h"

namespace weld_profiler
{
void writeCsv(const Scan& scan, std::ostream& out)
{
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<float>::max_digits10);
  out << "row,cell,x_m,y_m,z_m,intensity,sigma_m,stage_m,time_s,flags\n";
  for (std::size_t row = 0; row < scan.rows.size(); ++row)
    for (const CloudPoint& point : scan.rows[row].points)
    {
      const CloudRecord p = cloudRecord(scan.rows[row], point, scan.rows.front().stamp);
      out << row << ',' << point.cell << ',' << p.x << ',' << p.y << ',' << p.z << ',' << p.intensity << ',' << p.sigma
          << ',' << p.stage << ',' << p.time << ',' << static_cast<int>(p.flags) << '\n';
    }
}
}  // namespace weld_profiler
