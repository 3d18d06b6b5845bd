#include "weld_profiler/weld/weld_csv.h"

#include <algorithm>
#include <sstream>

#include "weld_csv_columns.h"
#include "weld_csv_number.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
void writeLine(const WeldRecord& record, std::ostream& out)
{
  WeldSection section = record.section;  // columns give access to a field, for the reader too
  const std::vector<MeasuredColumn>& columns = measuredColumns();
  out << section.row;
  writeNumber(out, section.stage * kMm);
  for (std::size_t i = 0; i < kBeforeVerdict; ++i)
    writeValue(out, columns[i].quantity(section), columns[i].scale);
  out << ',' << record.verdict << ',' << section.section;
  writeNumber(out, section.s * kMm);
  writeNumber(out, section.yaw * kDeg);
  for (std::size_t i = kBeforeVerdict; i < columns.size(); ++i)
    writeValue(out, columns[i].quantity(section), columns[i].scale);
  for (const MeasuredColumn& column : columns)
    writeSigma(out, column.quantity(section), column.scale);
  out << ',' << referenceWords()[static_cast<std::size_t>(section.reference)];
  for (const MeasuredColumn& column : laterColumns())
    writeValue(out, column.quantity(section), column.scale);
  for (const MeasuredColumn& column : laterColumns())
    writeSigma(out, column.quantity(section), column.scale);
  out << ',';
  if (!record.verdict.empty())
    out << (record.unverified ? "unverified" : "read");
  out << '\n';
}
}  // namespace

std::vector<std::string> weldCsvColumns()
{
  const std::vector<MeasuredColumn>& measured = measuredColumns();
  const auto after_verdict = measured.begin() + kBeforeVerdict;
  std::vector<std::string> names = { "row", "stage_mm" };
  const auto add = [&names](const MeasuredColumn& column) { names.emplace_back(column.name); };
  const auto add_sigma = [&names](const MeasuredColumn& column)
  { names.push_back(std::string("sigma_") + column.name); };
  std::for_each(measured.begin(), after_verdict, add);
  for (const char* name : { "verdict", "section", "s_mm", "yaw_deg" })
    names.emplace_back(name);
  std::for_each(after_verdict, measured.end(), add);
  std::for_each(measured.begin(), measured.end(), add_sigma);
  names.emplace_back("reference");
  std::for_each(laterColumns().begin(), laterColumns().end(), add);
  std::for_each(laterColumns().begin(), laterColumns().end(), add_sigma);
  names.emplace_back("verdict_source");
  return names;
}

void writeWeldCsv(const std::vector<WeldRecord>& records, std::ostream& out)
{
  std::ostringstream text;
  useCsvNumbers(text);
  const char* separator = "";
  for (const std::string& name : weldCsvColumns())
  {
    text << separator << name;
    separator = ",";
  }
  text << '\n';
  for (const WeldRecord& record : records)
  {
    const std::vector<std::string>& known = verdictWords();
    if (std::find(known.begin(), known.end(), record.verdict) == known.end())
      throw PreconditionError("verdict of section " + std::to_string(record.section.section) + " is '" +
                              record.verdict + "', must be B, C, D, fail, undecided or empty");
    writeLine(record, text);
  }
  out << text.str();
}
}  // namespace weld_profiler
