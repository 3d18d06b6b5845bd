#pragma once

#include <string>
#include <vector>

#include "verdict_rows.h"
#include "weld_profiler/weld/verdict.h"

namespace weld_profiler
{
/// What a reader of a verdict must know, a line each: what was not judged or not measured, what stays open.
/// @param verdict  but for its notes.
std::vector<std::string> verdictNotes(const WeldJudge& judge, const WeldToJudge& weld, const VerdictRows& made,
                                      const WeldVerdict& verdict);
}  // namespace weld_profiler
