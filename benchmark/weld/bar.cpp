#include "weld/bar.h"

#include <cmath>
#include <cstdio>

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
std::string format(const char* how, double a, double b = 0.0)
{
  char text[120];
  std::snprintf(text, sizeof text, how, a, b);
  return text;
}
}  // namespace

bool Bar::met() const
{
  return std::isfinite(measured) && !(measured < least) && !(measured > most);
}

std::string Bar::limits() const
{
  if (std::isfinite(least) && std::isfinite(most))
    return format("%g .. %g", least, most);
  return std::isfinite(least) ? format(">= %g", least) : format("<= %g", most);
}

void printBars(const std::vector<Bar>& bars)
{
  std::printf("\n%-52s %10s  %-11s %-8s %-6s %s\n", "bar", "measured", "asked", "", "", "");
  for (const Bar& bar : bars)
    std::printf("%-52s %10.4g  %-11s %-8s %-6s %s\n", bar.what.c_str(), bar.measured, bar.limits().c_str(),
                bar.unit.c_str(), bar.met() ? "met" : "MISSED", bar.detail.c_str());
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
