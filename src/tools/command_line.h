#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace weld_profiler
{
/// The command line itself is wrong (not the data it names): exit status 2. what() is one line.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Declares the options of a command, reads them, and explains them with --help.
/// An option is `--name VALUE` or `--name=VALUE`, a flag `--name`; `--` ends the options.
class CommandLine
{
public:
  /// @param name     as typed.
  /// @param summary  what the command does, a few lines for a person who has never used it.
  CommandLine(std::string name, std::string summary);

  /// Declares an option whose value goes to target; what target holds now is the default that --help shows.
  /// @param usage  "name VALUE", e.g. "out DIR".
  void option(const std::string& usage, std::string& target, const std::string& help);
  void option(const std::string& usage, double& target, const std::string& help);
  void option(const std::string& usage, int& target, const std::string& help);
  void flag(const std::string& name, bool& target, const std::string& help);

  /// The last declared option must be given.
  void required();

  /// What is not an option, at least one; without this call such words are a usage error.
  void arguments(const std::string& placeholder, std::vector<std::string>& target, const std::string& help);

  /// A line that can be typed, shown by --help.
  void example(const std::string& line);

  /// @return false when --help was asked for and printed on standard output.
  /// @throws UsageError naming the option and, for an unknown one, the nearest known.
  bool parse(int argc, const char* const* argv);

  const std::string& name() const { return name_; }
  std::string help() const;

private:
  struct Option
  {
    std::string name;
    std::string placeholder;  ///< empty = a flag
    std::string help;
    std::string default_text;
    bool required = false;
    bool given = false;
    std::function<void(const std::string&)> set;
  };

  void add(const std::string& usage, const std::string& help, std::function<void(const std::string&)> set);
  Option& find(const std::string& name);
  std::size_t readOption(const std::vector<std::string>& words, std::size_t at);
  std::string synopsis() const;

  std::string name_;
  std::string summary_;
  std::vector<Option> options_;
  std::vector<std::string> examples_;
  std::string arguments_placeholder_;
  std::string arguments_help_;
  std::vector<std::string>* arguments_ = nullptr;
};
}  // namespace weld_profiler
