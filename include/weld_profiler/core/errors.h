#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace weld_profiler
{
/// Base of everything this package throws on purpose. what() is one line: thing, value, remedy.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A parameter, calibration or scene that cannot be used. Thrown while building a stage, never while it runs.
class ConfigError : public Error
{
public:
  using Error::Error;
};

/// A file, bag or image that cannot be read or written.
class InputError : public Error
{
public:
  using Error::Error;
};

/// A caller broke a function's precondition (an image without pixels, an unknown encoding). Borders catch and count it.
class PreconditionError : public Error
{
public:
  using Error::Error;
};

/// Throws unless low <= value <= high; a NaN is refused as well.
/// @throws ConfigError "name is VALUE, must be in [low, high] unit"
template <class T>
void requireRange(const std::string& name, T value, T low, T high, const std::string& unit = "")
{
  if (value >= low && value <= high)
    return;
  std::ostringstream text;
  text << name << " is " << +value << ", must be in [" << +low << ", " << +high << "]" << (unit.empty() ? "" : " ")
       << unit;
  throw ConfigError(text.str());
}

/// Throws unless value is one of the names in known (any container of strings).
/// @throws ConfigError "name is 'VALUE', must be one of: a, b, c"
template <class Names>
void requireOneOf(const std::string& name, const std::string& value, const Names& known)
{
  std::string list;
  for (const std::string& candidate : known)
  {
    if (candidate == value)
      return;
    list += (list.empty() ? "" : ", ") + candidate;
  }
  throw ConfigError(name + " is '" + value + "', must be one of: " + list);
}
}  // namespace weld_profiler
