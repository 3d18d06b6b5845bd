#include "weld_profiler/weld/weld_params.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/core/yaml_fields.h"

namespace weld_profiler
{
namespace
{
/// Expects a refusal that names the field.
void expectRefused(const std::string& name, const std::function<void(WeldParams&)>& spoil)
{
  WeldParams params;
  spoil(params);
  try
  {
    params.validate();
    ADD_FAILURE() << name << " was not refused";
  }
  catch (const ConfigError& error)
  {
    EXPECT_EQ(std::string(error.what()).rfind(name, 0), 0u) << error.what();
  }
}
}  // namespace

TEST(WeldParams, DefaultsAreValid)
{
  EXPECT_NO_THROW(WeldParams().validate());
}

TEST(WeldParams, EveryNumberRefusesNanAndNonsense)
{
  WeldParams names;
  int numbers = 0;
  names.visit(
      [&numbers](const char* name, auto& value)
      {
        using Field = std::decay_t<decltype(value)>;
        if constexpr (std::is_same<Field, double>::value)
        {
          ++numbers;
          for (const double bad : { std::nan(""), -1.0, 1e9 })
          {
            expectRefused(name,
                          [&](WeldParams& params)
                          {
                            params.visit(
                                [&](const std::string& field, auto& target)
                                {
                                  if constexpr (std::is_same<std::decay_t<decltype(target)>, double>::value)
                                    target = field == name ? bad : target;
                                });
                          });
          }
        }
      });
  EXPECT_EQ(numbers, 16);
}

TEST(WeldParams, RefusesUnknownNames)
{
  expectRefused("kind", [](WeldParams& params) { params.kind = "lap"; });
  expectRefused("target", [](WeldParams& params) { params.target = "mirror"; });
}

TEST(WeldParams, RefusesLimitsThatCross)
{
  expectRefused("min_width", [](WeldParams& params) { params.min_width = 0.05; });
  expectRefused("min_parent_length", [](WeldParams& params) { params.min_parent_length = 0.02; });
  expectRefused("edge_blur", [](WeldParams& params) { params.edge_blur = 8e-4, params.face_length = 5e-4; });
}

TEST(WeldParams, TheShippedFileHoldsTheDefaults)
{
  const std::string path = "config/weld_measurement.yaml";
  WeldParams params;
  params.max_gap = 0.0;  // is read
  YamlFields fields(YAML::LoadFile(path), path);
  params.visit(fields);
  std::vector<double> read, built;
  const auto collect = [](std::vector<double>& into)
  {
    return [&into](const char* /*name*/, auto& value)
    {
      if constexpr (std::is_same<std::decay_t<decltype(value)>, double>::value)
        into.push_back(value);
    };
  };
  params.visit(collect(read));
  WeldParams().visit(collect(built));
  EXPECT_EQ(read, built);
  EXPECT_EQ(params.kind, "auto");
  EXPECT_EQ(params.target, "flush");
}
}  // namespace weld_profiler
