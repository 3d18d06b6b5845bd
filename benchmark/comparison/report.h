#pragma once

#include <string>
#include <vector>

namespace weld_profiler
{
namespace comparison
{
/// One named value of a row.
struct Field
{
  Field(std::string field_key, std::string value);
  Field(std::string field_key, const char* value);
  /// @param decimals  printed; the file keeps six digits. NaN is printed as - and written as null.
  Field(std::string field_key, double value, int decimals = 2);

  std::string key, printed, json;
};
using Row = std::vector<Field>;

/// One line of the acceptance table: lower is better unless said otherwise.
struct Acceptance
{
  std::string what;
  double value = 0.0, bar = 0.0, stretch = 0.0;
  bool higher_is_better = false;
  std::string unit, detail;
};

/// Collects what was measured, prints it as it comes, and writes all of it as JSON.
class Report
{
public:
  /// Begins a table; rows that follow belong to it.
  void table(const std::string& name, const std::string& title);
  enum Printing
  {
    Printed,
    Silent  ///< to the file alone
  };
  void row(const Row& fields, Printing printing = Printed);
  void accept(const Acceptance& acceptance);

  /// The acceptance lines, one each.
  void printAcceptance() const;
  /// @throws std::runtime_error when the file cannot be written.
  void write(const std::string& path) const;

private:
  struct Table
  {
    std::string name, title;
    std::vector<Row> rows;
    std::vector<std::string> head;  ///< keys of the row printed last
  };
  std::vector<Table> tables_;
  std::vector<Acceptance> accepted_;
};
}  // namespace comparison
}  // namespace weld_profiler
