#include "weld/found_tables.h"

#include <algorithm>
#include <cstdio>

namespace weld_profiler
{
namespace weld_accuracy
{
void reportShares(const std::vector<WeldCase>& welds, comparison::Report& report)
{
  report.table("found", "true sections that lie in the scan, and the share of them that was measured");
  for (const char* kind : { "butt", "fillet", "bead_on_plate" })
  {
    for (std::size_t at = 0; at < 3; ++at)
    {
      double inside = 0.0, found = 0.0;
      for (const WeldCase& weld : welds)
      {
        inside += weld.kind == kind ? weld.shares.inside[at] : 0;
        found += weld.kind == kind ? weld.shares.inside_found[at] : 0;
      }
      if (inside > 0.0)
        report.row({ { "kind", kind },
                     { "sections", at == 0 ? "low" : (at == 1 ? "h < 0.5 mm" : "high") },
                     { "n", inside, 0 },
                     { "measured %", 100.0 * found / inside, 2 } });
    }
  }
}

void reportSpots(const std::vector<WeldCase>& welds, comparison::Report& report)
{
  report.table("spots", "spatter wholly in the scan by its diameter seen from above; mean |error| of what is told");
  int false_spatter = 0, false_pores = 0;
  for (std::size_t at = 0; at < kSpotClasses.size(); ++at)
  {
    SpotClass sum;
    for (const WeldCase& weld : welds)
    {
      const SpotClass& of = weld.spots.classes[at];
      sum.inside += of.inside, sum.found += of.found, sum.diameter += of.diameter, sum.height += of.height;
    }
    if (sum.inside == 0)
      continue;
    report.row({ { "from mm", 1e3 * kSpotClasses[at], 1 },
                 { "n", static_cast<double>(sum.inside), 0 },
                 { "found %", 100.0 * sum.found / sum.inside, 1 },
                 { "diameter mm", 1e3 * sum.diameter / std::max(1, sum.found), 3 },
                 { "height mm", 1e3 * sum.height / std::max(1, sum.found), 4 } });
  }
  for (const WeldCase& weld : welds)
    false_spatter += weld.spots.false_spatter, false_pores += weld.spots.false_pores;
  std::printf("told where there is none: %d balls of spatter, %d pores\n", false_spatter, false_pores);
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
