#include "tools/params_file.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "weld_profiler/scan/scan_params.h"
#include "weld_profiler/stage/encoder_track.h"
#include "weld_profiler/stripe/stripe_params.h"

namespace weld_profiler
{
namespace
{
class ParamsFileTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    char name[] = "/tmp/params_file_test.XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& content) const
  {
    const std::string path = (folder_ / "params.yaml").string();
    std::ofstream(path) << content;
    return path;
  }

  static std::string whatOf(const std::function<void()>& call)
  {
    try
    {
      call();
    }
    catch (const Error& error)
    {
      return error.what();
    }
    return "nothing was thrown";
  }

  std::filesystem::path folder_;
  StripeParams stripe_;
};

TEST_F(ParamsFileTest, ReadsAFlatMap)
{
  ParamsFile params(file("method: svd\nmin_peak_counts: 33\n"));
  params.load("stripe_centre", stripe_);
  params.refuseUnknown();
  EXPECT_EQ(stripe_.method, "svd");
  EXPECT_DOUBLE_EQ(stripe_.min_peak_counts, 33.0);
  EXPECT_EQ(stripe_.max_gap_px, StripeParams().max_gap_px) << "not in the file: keeps its default";
}

TEST_F(ParamsFileTest, ReadsItsSectionAndLeavesTheOthersAlone)
{
  ParamsFile params(file("stripe_centre:\n  method: pca\ntriangulation:\n  pitch: 0.001\n  max_encoder_gap: 0.1\n"));
  ScanParams scan;
  EncoderParams encoder;
  params.load("stripe_centre", stripe_);
  params.load("triangulation", scan, encoder);
  params.refuseUnknown();
  EXPECT_EQ(stripe_.method, "pca");
  EXPECT_DOUBLE_EQ(scan.pitch, 0.001);
  EXPECT_DOUBLE_EQ(encoder.max_encoder_gap, 0.1);
}

TEST_F(ParamsFileTest, AMissingSectionOrFileSetsNothing)
{
  ParamsFile other(file("triangulation:\n  pitch: 0.001\n"));
  other.load("stripe_centre", stripe_);
  ParamsFile none("");
  none.load("stripe_centre", stripe_);
  none.refuseUnknown();
  EXPECT_EQ(stripe_.method, StripeParams().method);
}

TEST_F(ParamsFileTest, NamesFileKeyAndTypeOfAWrongValue)
{
  ParamsFile params(file("median_size_px: big\n"));
  const std::string text = whatOf([&] { params.load("stripe_centre", stripe_); });
  EXPECT_NE(text.find("params.yaml: median_size_px has the wrong type, must be a whole number"), std::string::npos)
      << text;
}

TEST_F(ParamsFileTest, RefusesAnUnknownKeyFlatAndInASection)
{
  ParamsFile flat(file("metod: svd\n"));
  flat.load("stripe_centre", stripe_);
  EXPECT_NE(whatOf([&] { flat.refuseUnknown(); }).find("unknown parameter 'metod', must be one of:"),
            std::string::npos);
  ParamsFile sectioned(file("stripe_centre:\n  metod: svd\n"));
  const std::string text = whatOf([&] { sectioned.load("stripe_centre", stripe_); });
  EXPECT_NE(text.find("stripe_centre: unknown parameter 'metod'"), std::string::npos) << text;
}

TEST_F(ParamsFileTest, RefusesAnUnknownSection)
{
  const std::string path = file("stripe_centre:\n  method: svd\ntriangulaton:\n  pitch: 1\n");
  EXPECT_NE(whatOf([&] { ParamsFile params(path); }).find("unknown section 'triangulaton'"), std::string::npos);
}

TEST_F(ParamsFileTest, NamesAFileThatCannotBeReadOrIsNotYaml)
{
  EXPECT_NE(whatOf([&] { ParamsFile params("/nowhere.yaml"); }).find("/nowhere.yaml: cannot be read: No such file"),
            std::string::npos);
  EXPECT_NE(whatOf([&] { ParamsFile params(file("a: [1,\nb: 2")); }).find("is not YAML"), std::string::npos);
  EXPECT_NE(whatOf([&] { ParamsFile params(file("")); }).find("is empty"), std::string::npos);
  EXPECT_NE(whatOf([&] { ParamsFile params(file("- 1\n")); }).find("expected `name: value` lines"), std::string::npos);
}
}  // namespace
}  // namespace weld_profiler
