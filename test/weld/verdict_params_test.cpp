#include "weld_profiler/weld/verdict_params.h"

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/refused_fields.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/core/yaml_fields.h"
#include "weld_profiler/weld/verdict.h"

using namespace weld_profiler;

namespace
{
const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

VerdictParams fromYaml(const std::string& text)
{
  VerdictParams params;
  YamlFields fields(YAML::Load(text), "weld.yaml");
  params.visit(fields);
  fields.refuseUnknown();
  return params;
}
}  // namespace

TEST(VerdictParams, AcceptTheirDefaults)
{
  EXPECT_NO_THROW(VerdictParams{}.validate());
}

TEST(VerdictParams, RefuseEachBadValueByName)
{
  const std::vector<double> absurd = { kNan, 0.0, -1e-3, 1.001, kInfinity, -kInfinity };
  const std::vector<FieldRefusal<VerdictParams>> refusals = {
    refusal("thickness", &VerdictParams::thickness, absurd),
    refusal("nominal_thickness", &VerdictParams::nominal_thickness, absurd),
    refusal("level", &VerdictParams::level, std::vector<std::string>{ "A", "b", "BC", " " }),
    refusal("smallest_imperfection", &VerdictParams::smallest_imperfection,
            std::vector<double>{ kNan, -1e-6, 1.1e-3, kInfinity }),
    refusal("min_length", &VerdictParams::min_length, std::vector<double>{ kNan, -1e-6, 0.11, kInfinity }),
    refusal("min_measured_share", &VerdictParams::min_measured_share, std::vector<double>{ kNan, -0.1, 1.1 }),
  };
  ASSERT_EQ(refusals.size(), 6u);
  expectRefused(refusals, [](const VerdictParams& params) { const WeldJudge judge(params); });
}

TEST(VerdictParams, RefuseATableThatIsNotThere)
{
  VerdictParams params;
  params.limits_file = "/nowhere/limits.yaml";
  EXPECT_THROW(WeldJudge{ params }, InputError);
}

TEST(VerdictParams, AreAllReadFromAFile)
{
  const VerdictParams params = fromYaml(
      "{thickness: 0.004, nominal_thickness: 0.003, level: C, judge_toe_angle: true, limits_file: a.yaml, "
      "smallest_imperfection: 0.0001, min_length: 0.002, min_measured_share: 0.5}");
  EXPECT_EQ(params.thickness, 0.004);
  EXPECT_EQ(params.nominal_thickness, 0.003);
  EXPECT_EQ(params.level, "C");
  EXPECT_TRUE(params.judge_toe_angle);
  EXPECT_EQ(params.limits_file, "a.yaml");
  EXPECT_EQ(params.smallest_imperfection, 0.0001);
  EXPECT_EQ(params.min_length, 0.002);
  EXPECT_EQ(params.min_measured_share, 0.5);
  EXPECT_NO_THROW(params.validate());
}

TEST(VerdictParams, HaveNoThicknessWhereAFileGivesNoneOrZero)
{
  EXPECT_FALSE(fromYaml("{level: B}").thickness);
  EXPECT_FALSE(fromYaml("{thickness: 0}").thickness);
  for (const char* bad : { "{thickness: .nan}", "{thickness: -0.001}", "{thickness: 2}", "{nominal_thickness: .nan}" })
    EXPECT_THROW(fromYaml(bad).validate(), ConfigError) << bad;
}
