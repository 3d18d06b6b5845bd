#include "weld_profiler/weld/grinding_csv.h"

#include <locale>
#include <sstream>

namespace weld_profiler
{
void writePassesCsv(const GrindingPlan& plan, std::ostream& out)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(9);
  text << "pass,point,x_m,y_m,z_m,qx,qy,qz,qw,removal_m\n";
  for (std::size_t pass = 0; pass < plan.passes.size(); ++pass)
    for (std::size_t i = 0; i < plan.passes[pass].points.size(); ++i)
    {
      const GrindingPoint& point = plan.passes[pass].points[i];
      const Eigen::Vector3d& p = point.pose.position;
      const Eigen::Quaterniond& q = point.pose.orientation;
      text << pass << ',' << i << ',' << p.x() << ',' << p.y() << ',' << p.z() << ',' << q.x() << ',' << q.y() << ','
           << q.z() << ',' << q.w() << ',' << point.removal << '\n';
    }
  out << text.str();
}
}  // namespace weld_profiler
