#pragma once

#include <optional>
#include <string>

#include "weld/weld_case.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// Tells one build from another: the content of this program and of the package's libraries that it has loaded. What
/// another build measured is not mixed with what this one does.
std::string buildMark();

/// Writes what a weld told, whole or not at all. @throws InputError naming the path.
void saveCase(const WeldCase& weld, const std::string& path, const std::string& mark);

/// @return nothing when there is no such file, or it was written by another build or is not whole.
std::optional<WeldCase> loadCase(const std::string& path, const std::string& mark);
}  // namespace weld_accuracy
}  // namespace weld_profiler
