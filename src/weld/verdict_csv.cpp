#include "weld_profiler/weld/verdict_csv.h"

#include <sstream>

#include "weld_csv_columns.h"
#include "weld_csv_number.h"

namespace weld_profiler
{
namespace
{
constexpr const char* kHeader =
    "imperfection,level,value_mm,sigma_mm,limit_mm,margin_mm,length_mm,decision,source,edition,iso_6520,rule,side,s_mm,"
    "sigma_margin_mm,measured_mm,value_deg,sigma_deg,limit_deg,margin_deg,sigma_margin_deg\n";

/// A text as one field: what would end it is replaced.
std::string field(std::string text)
{
  for (char& letter : text)
  {
    if (letter == ',')
      letter = ';';
    else if (letter == '\n' || letter == '\r' || letter == '"')
      letter = ' ';
  }
  return text;
}

const char* sourceOf(bool stated, bool unverified)
{
  return !stated ? "" : (unverified ? "unverified" : "read");
}

/// Value, sigma, limit and margin, or four empty fields.
void writeSizes(const VerdictRow& row, bool here, double scale, std::ostream& out)
{
  const Quantity none;
  writeValue(out, here ? row.value : none, scale);
  writeSigma(out, here ? row.value : none, scale);
  writeValue(out, here ? row.limit : none, scale);
  writeValue(out, here ? row.margin : none, scale);
}

void writeRow(const VerdictRow& row, std::ostream& out)
{
  const bool angle = row.imperfection == Imperfection::ToeAngle;
  const Quantity none;
  const bool stated = !row.edition.empty();
  out << name(row.imperfection) << ',' << name(row.level);
  writeSizes(row, !angle, kMm, out);
  writeNumber(out, row.length * kMm);
  out << ',' << name(row.decision) << ',' << sourceOf(stated, !row.verified) << ',' << field(row.edition) << ','
      << isoNumber(row.imperfection) << ',' << (stated ? name(row.rule) : "") << ',' << row.side;
  writeNumber(out, row.s * kMm);
  writeSigma(out, angle ? none : row.margin, kMm);
  writeNumber(out, row.measured * kMm);
  writeSizes(row, angle, kDeg, out);
  writeSigma(out, angle ? row.margin : none, kDeg);
  out << '\n';
}
}  // namespace

void writeVerdictCsv(const WeldVerdict& verdict, std::ostream& out)
{
  std::ostringstream text;
  useCsvNumbers(text);
  text << kHeader;
  for (const VerdictRow& row : verdict.rows)
    writeRow(row, text);
  for (const QualityLevel level : kQualityLevels)
  {
    const auto index = static_cast<std::size_t>(level);
    const Decision decision = verdict.levels[index];
    const bool stated = decision != Decision::NotMeasured && decision != Decision::NotJudged;
    text << "weld," << name(level) << ",,,,";
    writeNumber(text, verdict.length * kMm);
    text << ',' << name(decision) << ',' << sourceOf(stated, verdict.unverified_levels[index]) << ",,,,,,,,,,,,\n";
  }
  out << text.str();
}
}  // namespace weld_profiler
