#include "comparison/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace weld_profiler
{
namespace comparison
{
namespace
{
std::string format(const char* how, int decimals, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, how, decimals, value);
  return text;
}

std::string quoted(const std::string& text)
{
  std::string out = "\"";
  for (const char letter : text)
  {
    if (letter == '"' || letter == '\\')
      out += '\\';
    out += letter;
  }
  return out + '"';
}

std::string number(double value)
{
  return std::isfinite(value) ? format("%.*g", 6, value) : "null";
}

const char* verdictOf(const Acceptance& line)
{
  const double sign = line.higher_is_better ? -1.0 : 1.0;
  if (!(sign * line.value <= sign * line.bar))
    return "MISSED";
  return sign * line.value <= sign * line.stretch ? "stretch" : "met";
}

void printLine(const std::vector<std::string>& texts, const std::vector<std::string>& head)
{
  std::printf("%-26s", texts.front().c_str());
  for (std::size_t i = 1; i < texts.size(); ++i)
    std::printf("  %*s", head[i] == "method" ? 20 : static_cast<int>(std::max<std::size_t>(head[i].size(), 8)),
                texts[i].c_str());
  std::printf("\n");
}

void writeRow(std::ofstream& file, const Row& row)
{
  file << "{";
  for (std::size_t i = 0; i < row.size(); ++i)
    file << (i > 0 ? ", " : "") << quoted(row[i].key) << ": " << row[i].json;
  file << "}";
}
}  // namespace

Field::Field(std::string field_key, std::string value)
  : key(std::move(field_key)), printed(std::move(value)), json(quoted(printed))
{
}

Field::Field(std::string field_key, const char* value) : Field(std::move(field_key), std::string(value)) {}

Field::Field(std::string field_key, double value, int decimals)
  : key(std::move(field_key)),
    printed(std::isfinite(value) ? format("%.*f", decimals, value) : "-"),
    json(number(value))
{
}

void Report::table(const std::string& name, const std::string& title)
{
  tables_.push_back(Table{ name, title, {}, {} });
  std::printf("\n== %s: %s\n", name.c_str(), title.c_str());
  std::fflush(stdout);
}

void Report::row(const Row& fields, Printing printing)
{
  Table& table = tables_.back();
  table.rows.push_back(fields);
  if (printing == Silent)
    return;
  std::vector<std::string> head, values;
  for (const Field& field : fields)
  {
    head.push_back(field.key);
    values.push_back(field.printed);
  }
  if (head != table.head)
    printLine(head, head);
  printLine(values, head);
  std::fflush(stdout);
  table.head = head;
}

void Report::accept(const Acceptance& acceptance)
{
  accepted_.push_back(acceptance);
}

void Report::printAcceptance() const
{
  std::printf("\n== acceptance\n%-74s %10s %10s %10s  %s\n", "what", "measured", "bar", "stretch", "");
  for (const Acceptance& line : accepted_)
    std::printf("%-74s %10.4g %s%9.4g %s%9.4g  %-7s %s %s\n", line.what.c_str(), line.value,
                line.higher_is_better ? ">" : "<", line.bar, line.higher_is_better ? ">" : "<", line.stretch,
                verdictOf(line), line.unit.c_str(), line.detail.c_str());
}

void Report::write(const std::string& path) const
{
  std::ofstream file(path);
  file << "{\n\"tables\": {\n";
  for (std::size_t t = 0; t < tables_.size(); ++t)
  {
    file << quoted(tables_[t].name) << ": {\"title\": " << quoted(tables_[t].title) << ", \"rows\": [\n";
    for (std::size_t r = 0; r < tables_[t].rows.size(); ++r)
    {
      writeRow(file, tables_[t].rows[r]);
      file << (r + 1 < tables_[t].rows.size() ? ",\n" : "\n");
    }
    file << (t + 1 < tables_.size() ? "]},\n" : "]}\n");
  }
  file << "},\n\"acceptance\": [\n";
  for (std::size_t i = 0; i < accepted_.size(); ++i)
  {
    const Acceptance& line = accepted_[i];
    writeRow(file, { { "what", line.what },
                     { "value", line.value },
                     { "bar", line.bar },
                     { "stretch", line.stretch },
                     { "better", line.higher_is_better ? "higher" : "lower" },
                     { "verdict", verdictOf(line) },
                     { "unit", line.unit },
                     { "detail", line.detail } });
    file << (i + 1 < accepted_.size() ? ",\n" : "\n");
  }
  file << "]\n}\n";
  file.flush();
  if (!file)
    throw std::runtime_error("cannot write '" + path + "'");
}
}  // namespace comparison
}  // namespace weld_profiler
