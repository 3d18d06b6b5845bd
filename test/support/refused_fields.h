#pragma once

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
/// Values that a field of parameters must not have.
template <class Params>
struct FieldRefusal
{
  std::string field;
  std::vector<std::function<void(Params&)>> bad;
};

template <class Value, class Field, class Params>
FieldRefusal<Params> refusal(const std::string& field, Field Params::*member, const std::vector<Value>& values)
{
  FieldRefusal<Params> result{ field, {} };
  for (const Value& value : values)
    result.bad.push_back([member, value](Params& params) { params.*member = value; });
  return result;
}

/// Each value alone is refused, by an error that names the field and what it must be.
/// @param check  throws it.
template <class Params, class Check>
void expectRefused(const std::vector<FieldRefusal<Params>>& refusals, Check&& check)
{
  for (const FieldRefusal<Params>& refused : refusals)
    for (const auto& spoil : refused.bad)
    {
      Params params;
      spoil(params);
      try
      {
        check(params);
        ADD_FAILURE() << refused.field << " was accepted";
      }
      catch (const ConfigError& error)
      {
        EXPECT_NE(std::string(error.what()).find(refused.field), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("must be"), std::string::npos) << error.what();
      }
    }
}
}  // namespace weld_profiler
