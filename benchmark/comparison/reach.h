#pragma once

#include <string>

namespace weld_profiler
{
namespace comparison
{
/// Columns, centred on its cell, whose pixels move the centre that a method measures on a straight stripe: found by
/// disturbing one column after the other. A column counts when it moves the centre by more than a hundredth of what
/// the column moves it by that counts most.
int columnsByDisturbing(const std::string& method, double sigma, double degrees);
}  // namespace comparison
}  // namespace weld_profiler
