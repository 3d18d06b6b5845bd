#pragma once

#include <string>
#include <vector>

#include "weld_profiler/weld/weld_csv.h"

namespace weld_profiler
{
/// A measured column of weld.csv and where its value stands.
struct MeasuredColumn
{
  const char* name;
  double scale;  ///< from SI to the column's unit
  Quantity& (*quantity)(WeldSection&);
};

/// The measured columns of every weld.csv, in order; the first ten stand before `verdict`.
const std::vector<MeasuredColumn>& measuredColumns();
constexpr std::size_t kBeforeVerdict = 10;

/// Those that stand after `reference`.
const std::vector<MeasuredColumn>& laterColumns();

/// Words of the columns that hold no number.
const std::vector<std::string>& verdictWords();
const std::vector<std::string>& referenceWords();  ///< in the order of SectionReference
const std::vector<std::string>& sourceWords();

constexpr double kMm = 1e3;   // millimetres a metre
constexpr double kMm2 = 1e6;  // square millimetres a square metre
constexpr double kDeg = 57.29577951308232;
}  // namespace weld_profiler
