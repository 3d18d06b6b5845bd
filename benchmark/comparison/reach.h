#pragma once

#include <string>

namespace weld_profiler
{
namespace comparison
{
/// Columns, centred on its cell, that a method that does not tell measures a centre of a straight stripe over. One for
/// methods that look at a column at a time (neighbours only steer their window); else those whose pixels move the
/// centre, found by disturbing one column after the other: a column counts when it moves the centre by more than a
/// hundredth of what the column moves it by that counts most.
int columnsUsed(const std::string& method, double sigma, double degrees);
/// The same, disturbing in any case.
int columnsByDisturbing(const std::string& method, double sigma, double degrees);
}  // namespace comparison
}  // namespace weld_profiler
