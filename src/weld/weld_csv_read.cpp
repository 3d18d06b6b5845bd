#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "weld_csv_columns.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/weld/weld_csv.h"

namespace weld_profiler
{
namespace
{
constexpr const char* kRemedy = "; the file is damaged or no weld.csv, write it again";

std::vector<std::string> split(const std::string& line)
{
  std::vector<std::string> fields(1);
  for (const char letter : line)
  {
    if (letter == ',')
      fields.emplace_back();
    else
      fields.back() += letter;
  }
  return fields;
}

/// The header: which column holds what.
class Header
{
public:
  Header(const std::string& line, const std::string& origin) : fields_(split(line))
  {
    for (std::size_t i = 0; i < fields_.size(); ++i)
    {
      if (!index_.emplace(fields_[i], i).second)
        throw InputError(origin + ": column " + fields_[i] + " stands there twice" + kRemedy);
    }
    const std::vector<std::string> all = weldCsvColumns();
    const auto later = std::find(all.begin(), all.end(), "reference") + 1;
    const bool sigmas = std::any_of(fields_.begin(), fields_.end(),
                                    [](const std::string& field) { return field.rfind("sigma_", 0) == 0; });
    for (auto name = all.begin(); name != later; ++name)
    {
      if (index_.count(*name) == 0 && (sigmas || name->rfind("sigma_", 0) != 0))
        throw InputError(origin + ": column " + *name + " is missing" + kRemedy);
    }
  }

  std::size_t size() const { return fields_.size(); }
  bool has(const std::string& name) const { return index_.count(name) != 0; }
  std::size_t at(const std::string& name) const { return index_.at(name); }

private:
  std::vector<std::string> fields_;
  std::map<std::string, std::size_t> index_;
};

/// A line of the file and where it stands.
class Line
{
public:
  Line(const Header& header, const std::string& text, std::string place)
    : header_(header), fields_(split(text)), place_(std::move(place))
  {
    if (fields_.size() != header.size())
      throw InputError(place_ + " has " + std::to_string(fields_.size()) + " fields, must have " +
                       std::to_string(header.size()) + kRemedy);
  }

  const std::string& text(const std::string& column) const { return fields_[header_.at(column)]; }

  /// NaN if the field is empty.
  double number(const std::string& column, bool may_be_empty = true) const
  {
    const std::string& field = text(column);
    if (field.empty() && may_be_empty)
      return std::numeric_limits<double>::quiet_NaN();
    std::istringstream stream(field);
    stream.imbue(std::locale::classic());
    double value = 0.0;
    const bool tight = !field.empty() && field.front() != ' ' && field.front() != '\t';
    if (!tight || !(stream >> value) || stream.peek() != std::istringstream::traits_type::eof())
      throw failure(column, may_be_empty ? "a number or empty" : "a number");
    return value;
  }

  int wholeNumber(const std::string& column) const
  {
    const double value = number(column, false);
    if (!(value >= 0.0 && value <= 1e9 && value == static_cast<int>(value)))
      throw failure(column, "a whole number from 0");
    return static_cast<int>(value);
  }

  std::size_t word(const std::string& column, const std::vector<std::string>& known) const
  {
    const auto found = std::find(known.begin(), known.end(), text(column));
    if (found != known.end())
      return static_cast<std::size_t>(found - known.begin());
    std::string list;
    for (const std::string& candidate : known)
      list += (list.empty() ? "" : ", ") + (candidate.empty() ? "empty" : candidate);
    throw failure(column, "one of: " + list);
  }

  void quantity(const MeasuredColumn& column, WeldSection& section) const
  {
    if (!header_.has(column.name))
      return;
    const std::string sigma_name = std::string("sigma_") + column.name;
    const double value = number(column.name);
    const bool exact = !header_.has(sigma_name);
    const double sigma = exact ? 0.0 : number(sigma_name);
    if (std::isnan(value))
      return;
    if (!(sigma >= 0.0))
      throw failure(sigma_name, "a number from 0: " + std::string(column.name) + " is measured");
    column.quantity(section) = { value / column.scale, sigma / column.scale };
  }

private:
  InputError failure(const std::string& column, const std::string& remedy) const
  {
    return InputError(place_ + ": " + column + " is '" + text(column) + "', must be " + remedy + kRemedy);
  }

  const Header& header_;
  std::vector<std::string> fields_;
  std::string place_;
};

WeldRecord recordOf(const Header& header, const Line& line)
{
  WeldRecord record;
  WeldSection& section = record.section;
  section.row = line.wholeNumber("row");
  section.section = line.wholeNumber("section");
  section.stage = line.number("stage_mm", false) / kMm;
  section.s = line.number("s_mm", false) / kMm;
  section.yaw = line.number("yaw_deg", false) / kDeg;
  section.reference = static_cast<SectionReference>(line.word("reference", referenceWords()));
  for (const std::vector<MeasuredColumn>* columns : { &measuredColumns(), &laterColumns() })
    for (const MeasuredColumn& column : *columns)
      line.quantity(column, section);
  record.verdict = verdictWords()[line.word("verdict", verdictWords())];
  if (header.has("verdict_source"))
    record.unverified = sourceWords()[line.word("verdict_source", sourceWords())] == "unverified";
  return record;
}
}  // namespace

std::vector<WeldRecord> parseWeldCsv(const std::string& text, const std::string& origin)
{
  if (text.empty() || text.back() != '\n')
    throw InputError(origin + (text.empty() ? " is empty" : " ends within a line") + kRemedy);
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
  {
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    lines.push_back(line);
  }
  const Header header(lines.front(), origin);
  std::vector<WeldRecord> records;
  for (std::size_t i = 1; i < lines.size(); ++i)
    records.push_back(recordOf(header, Line(header, lines[i], origin + ": line " + std::to_string(i + 1))));
  return records;
}

std::vector<WeldRecord> readWeldCsv(const std::string& path)
{
  std::ostringstream content;
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path) || !(content << stream.rdbuf() || stream.peek() == EOF))
    throw InputError("cannot read " + path + ": no such file or not readable, check the path");
  return parseWeldCsv(content.str(), path);
}
}  // namespace weld_profiler
