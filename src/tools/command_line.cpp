#include "tools/command_line.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numeric>
#include <sstream>
#include <utility>

namespace weld_profiler
{
namespace
{
std::size_t editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{ 0 });
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({ replaced, row[j] + 1, row[j - 1] + 1 });
    }
  }
  return row.back();
}

double toNumber(const std::string& name, const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0')
    throw UsageError("--" + name + " is '" + text + "', must be a number");
  return value;
}

int toWholeNumber(const std::string& name, const std::string& text)
{
  const double value = toNumber(name, text);
  if (!(std::abs(value) <= std::numeric_limits<int>::max()) || value != std::floor(value))
    throw UsageError("--" + name + " is '" + text + "', must be a whole number");
  return static_cast<int>(value);
}

std::string toText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}
}  // namespace

CommandLine::CommandLine(std::string name, std::string summary) : name_(std::move(name)), summary_(std::move(summary))
{
}

void CommandLine::add(const std::string& usage, const std::string& help, std::function<void(const std::string&)> set)
{
  const std::size_t space = usage.find(' ');
  Option option;
  option.name = usage.substr(0, space);
  option.placeholder = space == std::string::npos ? "" : usage.substr(space + 1);
  option.help = help;
  option.set = std::move(set);
  options_.push_back(std::move(option));
}

void CommandLine::option(const std::string& usage, std::string& target, const std::string& help)
{
  add(usage, help, [&target](const std::string& text) { target = text; });
  options_.back().default_text = target;
}

void CommandLine::option(const std::string& usage, double& target, const std::string& help)
{
  const std::string name = usage.substr(0, usage.find(' '));
  add(usage, help, [&target, name](const std::string& text) { target = toNumber(name, text); });
  options_.back().default_text = std::isnan(target) ? "" : toText(target);
}

void CommandLine::option(const std::string& usage, int& target, const std::string& help)
{
  const std::string name = usage.substr(0, usage.find(' '));
  add(usage, help, [&target, name](const std::string& text) { target = toWholeNumber(name, text); });
  options_.back().default_text = std::to_string(target);
}

void CommandLine::flag(const std::string& name, bool& target, const std::string& help)
{
  add(name, help, [&target](const std::string&) { target = true; });
}

void CommandLine::required()
{
  options_.back().required = true;
}

void CommandLine::arguments(const std::string& placeholder, std::vector<std::string>& target, const std::string& help)
{
  arguments_placeholder_ = placeholder;
  arguments_help_ = help;
  arguments_ = &target;
}

void CommandLine::example(const std::string& line)
{
  examples_.push_back(line);
}

CommandLine::Option& CommandLine::find(const std::string& name)
{
  const Option* nearest = nullptr;
  std::size_t distance = std::numeric_limits<std::size_t>::max();
  for (Option& option : options_)
  {
    if (option.name == name)
      return option;
    const std::size_t candidate = editDistance(option.name, name);
    if (candidate < distance)
    {
      distance = candidate;
      nearest = &option;
    }
  }
  throw UsageError("unknown option --" + name + (nearest ? ", nearest known: --" + nearest->name : "") + "; see " +
                   name_ + " --help");
}

std::size_t CommandLine::readOption(const std::vector<std::string>& words, std::size_t at)
{
  const std::string word = words[at].substr(2);
  const std::size_t equals = word.find('=');
  Option& option = find(word.substr(0, equals));
  if (option.given)
    throw UsageError("--" + option.name + " is given twice; give it once");
  option.given = true;
  if (option.placeholder.empty())
  {
    if (equals != std::string::npos)
      throw UsageError("--" + option.name + " takes no value");
    option.set("");
    return at + 1;
  }
  if (equals != std::string::npos)
  {
    option.set(word.substr(equals + 1));
    return at + 1;
  }
  if (at + 1 >= words.size() || words[at + 1].rfind("--", 0) == 0)
    throw UsageError("--" + option.name + " needs a value: --" + option.name + " " + option.placeholder);
  option.set(words[at + 1]);
  return at + 2;
}

bool CommandLine::parse(int argc, const char* const* argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (Option& option : options_)
    option.given = false;
  std::vector<std::string> rest;
  for (std::size_t at = 0; at < words.size();)
  {
    const std::string& word = words[at];
    if (word == "--help" || word == "-h")
    {
      std::cout << help();
      return false;
    }
    if (word == "--")
    {
      rest.insert(rest.end(), words.begin() + static_cast<std::ptrdiff_t>(at) + 1, words.end());
      break;
    }
    if (word.rfind("--", 0) == 0)
    {
      at = readOption(words, at);
      continue;
    }
    if (word.size() > 1 && word[0] == '-')
      throw UsageError("unknown option " + word + "; options are written --name, see " + name_ + " --help");
    rest.push_back(word);
    ++at;
  }
  for (const Option& option : options_)
    if (option.required && !option.given)
      throw UsageError("--" + option.name + " " + option.placeholder + " is missing; see " + name_ + " --help");
  if (!arguments_ && !rest.empty())
    throw UsageError("'" + rest.front() + "' is not an option; see " + name_ + " --help");
  if (arguments_ && rest.empty())
    throw UsageError(arguments_placeholder_ + " is missing; see " + name_ + " --help");
  if (arguments_)
    *arguments_ = rest;
  return true;
}
}  // namespace weld_profiler
