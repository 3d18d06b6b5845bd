#include "limits_node.h"

#include <sstream>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
std::string shown(const YAML::Node& node)
{
  std::ostringstream text;
  text << node;
  std::string line = text.str();
  for (char& letter : line)
    letter = letter == '\n' ? ' ' : letter;
  return line;
}

template <class T>
T as(const YAML::Node& node, const std::string& name, const char* type)
{
  try
  {
    return node.as<T>();
  }
  catch (const YAML::Exception&)
  {
    throw ConfigError(name + " is '" + shown(node) + "', must be " + type);
  }
}
}  // namespace

LimitsNode::LimitsNode(const YAML::Node& node, std::string place) : node_(node), place_(std::move(place))
{
  if (!node_.IsMap())
    throw ConfigError(place_ + " is '" + shown(node_) + "', must hold `key: value` lines");
}

bool LimitsNode::has(const std::string& key) const
{
  return node_[key].IsDefined() && !node_[key].IsNull();
}

YAML::Node LimitsNode::child(const std::string& key, const std::string& remedy) const
{
  if (!has(key))
    throw ConfigError(nameOf(key) + " is missing, add " + remedy);
  return node_[key];
}

double LimitsNode::number(const std::string& key, double low, double high) const
{
  const auto value = as<double>(child(key, "a number"), nameOf(key), "a number");
  requireRange(nameOf(key), value, low, high);
  return value;
}

std::string LimitsNode::text(const std::string& key) const
{
  const YAML::Node node = child(key, "a text");
  if (!node.IsScalar() || node.Scalar().empty())
    throw ConfigError(nameOf(key) + " is '" + shown(node) + "', must be a text");
  return node.Scalar();
}

bool LimitsNode::flag(const std::string& key) const
{
  return has(key) && as<bool>(node_[key], nameOf(key), "true or false");
}

void LimitsNode::refuseUnknown(const std::set<std::string>& known) const
{
  std::string list;
  for (const std::string& key : known)
    list += (list.empty() ? "" : ", ") + key;
  for (const auto& entry : node_)
  {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : shown(entry.first);
    if (known.count(key) == 0)
      throw ConfigError(nameOf(key) + " is not known, must be one of: " + list);
  }
}
}  // namespace weld_profiler
