#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "weld_profiler/weld/weld_section.h"

namespace weld_profiler
{
/// A line of weld.csv.
struct WeldRecord
{
  WeldSection section;
  std::string verdict;      ///< B, C, D, fail, undecided; empty = not judged, no bead
  bool unverified = false;  ///< the verdict rests on a limit that was not read
};

/// Columns of weld.csv, in order: those that every weld.csv has, then `angle_deg, incomplete_fill_mm`, their sigmas and
/// `verdict_source` (`read`, `unverified`; empty = no verdict).
std::vector<std::string> weldCsvColumns();

/// Writes a line a section after the header: mm and degrees, a decimal point whatever the locale, an empty field for
/// what was not measured. The stream's state tells whether it could be written; give it a file that appears whole or
/// not at all (AtomicFile).
/// @throws PreconditionError for a verdict that weld.csv does not know.
void writeWeldCsv(const std::vector<WeldRecord>& records, std::ostream& out);

/// Reads a weld.csv back. Columns are found by name; unknown ones are passed over; those after the sigmas may be
/// missing. A file without any sigma column states exact values: their sigma is 0.
/// @throws InputError naming file, line, column, value and remedy.
std::vector<WeldRecord> readWeldCsv(const std::string& path);

/// @param origin  stands for the file in messages.
std::vector<WeldRecord> parseWeldCsv(const std::string& text, const std::string& origin);
}  // namespace weld_profiler
