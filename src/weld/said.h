#pragma once

#include <sstream>
#include <string>

namespace weld_profiler
{
namespace weld
{
/// Words and numbers one behind the other, numbers with three digits.
template <class... Parts>
std::string said(const Parts&... parts)
{
  std::ostringstream out;
  out.precision(3);
  (out << ... << parts);
  return out.str();
}
}  // namespace weld
}  // namespace weld_profiler
