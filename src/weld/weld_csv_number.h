#pragma once

#include <cmath>
#include <iomanip>
#include <locale>
#include <ostream>

#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
constexpr int kCsvDecimals = 6;  // nanometres, microdegrees

/// Makes a stream write numbers as our CSV files have them.
inline void useCsvNumbers(std::ostream& out)
{
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(kCsvDecimals);
}

/// A comma, and the value if it is finite.
inline void writeNumber(std::ostream& out, double value)
{
  out << ',';
  if (std::isfinite(value))
    out << value;
}

inline void writeValue(std::ostream& out, const Quantity& quantity, double scale)
{
  writeNumber(out, quantity.measured() ? quantity.value * scale : std::nan(""));
}

inline void writeSigma(std::ostream& out, const Quantity& quantity, double scale)
{
  writeNumber(out, quantity.measured() ? quantity.sigma * scale : std::nan(""));
}
}  // namespace weld_profiler
