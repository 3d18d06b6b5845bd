#include "weld_profiler/scan/scan_params.h"

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/refused_fields.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/core/yaml_fields.h"

using namespace weld_profiler;

namespace
{
const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

const std::vector<FieldRefusal<ScanParams>>& refusals()
{
  static const std::vector<FieldRefusal<ScanParams>> all = {
    refusal<std::string>("trigger", &ScanParams::trigger, { "", "Distance", "frames" }),
    refusal<double>("pitch", &ScanParams::pitch, { -1e-6, 1.1, kNan, kInfinity }),
    refusal<double>("still_tolerance", &ScanParams::still_tolerance, { -1e-6, 1.1, kNan }),
    refusal<std::string>("on_reversal", &ScanParams::on_reversal, { "", "close" }),
    refusal<double>("reversal_hysteresis", &ScanParams::reversal_hysteresis, { 0.0, -1e-3, 1.1, kNan }),
    refusal<int>("max_rows", &ScanParams::max_rows, { 0, -1, 1000001 }),
    refusal<int>("max_waiting", &ScanParams::max_waiting, { 0, -1, 100001 }),
    refusal<double>("min_x", &ScanParams::min_x, { kNan, -kInfinity, 10.0, 11.0 }),
    refusal<double>("max_x", &ScanParams::max_x, { kNan, kInfinity, -10.0 }),
    refusal<double>("min_y", &ScanParams::min_y, { kNan, -kInfinity, 1000.0 }),
    refusal<double>("max_y", &ScanParams::max_y, { kNan, kInfinity, -1000.0 }),
    refusal<double>("min_z", &ScanParams::min_z, { kNan, -kInfinity, 10.0 }),
    refusal<double>("max_z", &ScanParams::max_z, { kNan, kInfinity, -10.0 }),
  };
  return all;
}
}  // namespace

TEST(ScanParams, AcceptTheirDefaults)
{
  EXPECT_NO_THROW(ScanParams{}.validate());
}

TEST(ScanParams, RefuseEachBadValueByName)
{
  ASSERT_EQ(refusals().size(), 13u) << "one for each parameter";
  expectRefused(refusals(), [](const ScanParams& params) { params.validate(); });
}

TEST(ScanParams, AreAllReadFromAFile)
{
  ScanParams params;
  YamlFields fields(YAML::Load("{trigger: time, pitch: 0.1, still_tolerance: 0.2, on_reversal: ignore, "
                               "reversal_hysteresis: 0.3, max_rows: 4, max_waiting: 5, min_x: 1, max_x: 2, min_y: 3, "
                               "max_y: 4, min_z: 5, max_z: 6}"),
                    "scan.yaml");
  params.visit(fields);
  EXPECT_NO_THROW(fields.refuseUnknown());
  EXPECT_EQ(params.trigger, "time");
  EXPECT_EQ(params.max_waiting, 5);
  EXPECT_EQ(params.max_z, 6.0);
  EXPECT_NO_THROW(params.validate());
}
