#pragma once

#include <vector>

#include "weld_profiler/weld/limits.h"
#include "weld_profiler/weld/weld_section.h"

namespace weld_profiler
{
/// The size of an imperfection, or of one side of it, in a section.
struct ImperfectionSize
{
  Imperfection imperfection;
  const char* side;  ///< `left`, `right` or empty
  Quantity value;
};

/// The sizes that a section of this kind has, measured or not; always the same ones in the same order for a kind.
std::vector<ImperfectionSize> sizesOf(WeldKind kind, const WeldSection& section);

/// The height that is judged as excess weld metal: above the chord, or, where the plates are misaligned beyond 2 sigma,
/// the largest of those above the chord and above either plate.
Quantity judgedHeight(const WeldSection& section);

/// Whether a section's verdict waits for this imperfection when there is a limit for it.
bool decidesSections(Imperfection imperfection, bool judge_toe_angle);
}  // namespace weld_profiler
