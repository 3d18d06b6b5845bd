#pragma once

#include "section_shape.h"

namespace weld_profiler
{
namespace weld
{
/// Makes the covariances of the parents of one row honest, which no neighbouring section evens out: little of a parent
/// may be in view, and what is taken for one may be a part of the face.
///  - Of a short piece the residuals tell the noise badly: they are as correlated as the longer parent's at least, and
///    a piece of a few independent points is uncertain by more.
///  - A bend that is there beyond doubt goes on beyond the piece: the line is wrong by that much where the weld is.
void widenParents(const SectionProfile& profile, SectionShape& shape);
}  // namespace weld
}  // namespace weld_profiler
