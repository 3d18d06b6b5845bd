#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/csv_fields.h"

namespace weld_profiler
{
/// A CSV file with a header; an empty field is NaN.
struct CsvTable
{
  std::vector<std::map<std::string, double>> rows;

  std::vector<double> measured(const std::string& column) const
  {
    std::vector<double> values;
    for (const auto& row : rows)
      if (std::isfinite(row.at(column)))
        values.push_back(row.at(column));
    return values;
  }
};

inline CsvTable csvTable(const std::string& text)
{
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = csvFields(line);
  CsvTable table;
  while (std::getline(lines, line))
  {
    const std::vector<std::string> fields = csvFields(line);
    EXPECT_EQ(fields.size(), names.size()) << line;
    std::map<std::string, double> row;
    for (std::size_t i = 0; i < std::min(fields.size(), names.size()); ++i)
    {
      char* end = nullptr;
      const double value = std::strtod(fields[i].c_str(), &end);
      row[names[i]] = fields[i].empty() || *end != '\0' ? std::nan("") : value;
    }
    table.rows.push_back(row);
  }
  return table;
}
}  // namespace weld_profiler
