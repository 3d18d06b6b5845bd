#include "tools/stripe_csv.h"

#include <iomanip>
#include <locale>
#include <sstream>

namespace weld_profiler
{
std::string stripeCsv(const Stripe& stripe)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "u_px,v_px,normal_rad,intensity,width_px,sigma_px,flags,cell\n" << std::fixed;
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    const StripePoint point = stripe[i];
    text << std::setprecision(4) << point.u << ',' << point.v << ',' << std::setprecision(6) << point.normal_angle
         << ',' << std::setprecision(2) << point.intensity << ',' << std::setprecision(4) << point.width << ','
         << std::setprecision(5) << point.sigma << ',' << +point.flags << ',' << point.cell << '\n';
  }
  return text.str();
}
}  // namespace weld_profiler
