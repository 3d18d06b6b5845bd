#include <sstream>

#include "tools/command_line.h"

namespace weld_profiler
{
namespace
{
// Breaks text at spaces so that it fits a terminal, each further line indented.
std::string wrapped(const std::string& text, std::size_t indent)
{
  constexpr std::size_t kWidth = 100;
  std::istringstream words(text);
  std::string line;
  std::string result;
  for (std::string word; words >> word;)
  {
    if (!line.empty() && indent + line.size() + 1 + word.size() > kWidth)
    {
      result += line + "\n" + std::string(indent, ' ');
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return result + line;
}

std::string helpLine(const std::string& left, const std::string& text)
{
  constexpr std::size_t kColumn = 26;
  const std::string gap =
      left.size() + 2 < kColumn ? std::string(kColumn - left.size() - 2, ' ') : "\n" + std::string(kColumn, ' ');
  return "  " + left + gap + wrapped(text, kColumn) + "\n";
}
}  // namespace

std::string CommandLine::synopsis() const
{
  std::string line = "usage: " + name_;
  for (const Option& option : options_)
  {
    const std::string text = "--" + option.name + (option.placeholder.empty() ? "" : " " + option.placeholder);
    line += option.required ? " " + text : " [" + text + "]";
  }
  return wrapped(line + " " + arguments_placeholder_, 4) + "\n";
}

std::string CommandLine::help() const
{
  std::string text = synopsis() + "\n" + summary_ + "\n\n";
  if (arguments_)
    text += helpLine(arguments_placeholder_, arguments_help_);
  for (const Option& option : options_)
  {
    const std::string left = "--" + option.name + (option.placeholder.empty() ? "" : " " + option.placeholder);
    const std::string remark = option.required               ? " (required)"
                               : option.default_text.empty() ? ""
                                                             : " (default " + option.default_text + ")";
    text += helpLine(left, option.help + remark);
  }
  text += helpLine("--help", "this text");
  text += "\nexamples:\n";
  for (const std::string& line : examples_)
    text += "  " + line + "\n";
  return text +
         "\nexit status: 0 good; 1 bad input, one line on standard error; 2 usage; 3 ran, but the result is poor;\n"
         "130 interrupted\n";
}
}  // namespace weld_profiler
