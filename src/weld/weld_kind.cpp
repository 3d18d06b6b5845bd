#include "weld_profiler/weld/weld_section.h"

namespace weld_profiler
{
const char* name(WeldKind kind)
{
  switch (kind)
  {
    case WeldKind::Butt:
      return "butt";
    case WeldKind::Fillet:
      return "fillet";
    case WeldKind::BeadOnPlate:
      return "bead_on_plate";
    case WeldKind::None:
      break;
  }
  return "none";
}
}  // namespace weld_profiler
