#pragma once

#include <string>
#include <vector>

#include "kinds.h"

namespace weld_profiler
{
namespace paper_tables
{
/// The paper's Table 1: Eq. 12's sigma of both coordinates, of the middle frame of each kind; beside it the same of the
/// truth and of truths that were spoilt, and what the paper prints. Markdown, as all tables here.
std::string spreadTable(const std::vector<Kind>& kinds, const std::vector<Entry>& entries);

/// The paper's Table 2: median time a frame, one thread.
std::string timeTable(const std::vector<Kind>& kinds, const std::vector<Entry>& entries);

/// Against the truth, over all frames of each kind: RMS error across the stripe, centres more than 1 px off, cells
/// without a measured centre.
std::string errorTable(const std::vector<Kind>& kinds, const std::vector<Entry>& entries);
}  // namespace paper_tables
}  // namespace weld_profiler
