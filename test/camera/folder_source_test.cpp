#include "weld_profiler/camera/folder_source.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;
using Result = FrameSource::Result;

std::string whatOf(const std::function<void()>& call)
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

class FolderSourceTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    char name[] = "/tmp/folder_source_test.XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void writeImage(const std::string& name, int value, int width = 32) const
  {
    ASSERT_TRUE(cv::imwrite(path(name), cv::Mat(24, width, CV_8UC1, cv::Scalar(value))));
  }

  void truncate(const std::string& name) const { fs::resize_file(path(name), fs::file_size(path(name)) * 2 / 3); }

  FolderSourceParams fast(const std::string& images) const
  {
    FolderSourceParams params;
    params.images = images;
    params.rate = 1000.0;
    return params;
  }

  fs::path folder_;
};

TEST_F(FolderSourceTest, PlaysADirectoryInNaturalOrderAndEnds)
{
  writeImage("img10.png", 10);
  writeImage("img2.png", 2);
  writeImage("img1.png", 1);
  std::ofstream(path("notes.txt")) << "not an image";
  FolderSource source(fast(folder_.string()));
  Frame frame;
  std::vector<int> values;
  std::vector<Stamp> stamps;
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_EQ(source.next(frame, 1.0), Result::Frame) << source.message();
    values.push_back(frame.pixels.at(0));
    stamps.push_back(frame.stamp);
    EXPECT_EQ(frame.number, static_cast<std::uint64_t>(i));
  }
  EXPECT_EQ(values, (std::vector<int>{ 1, 2, 10 }));
  EXPECT_GE(stamps[1] - stamps[0], 1000000) << "1000 frames a second; more when the machine is busy";
  EXPECT_EQ(source.next(frame, 1.0), Result::End);
  EXPECT_EQ(source.next(frame, 1.0), Result::End) << "and stays at its end";
}

TEST_F(FolderSourceTest, LoopsWhenAskedTo)
{
  writeImage("a.png", 1);
  writeImage("b.png", 2);
  FolderSourceParams params = fast(folder_.string());
  params.loop = true;
  FolderSource source(params);
  Frame frame;
  std::vector<int> values;
  for (int i = 0; i < 5; ++i)
  {
    ASSERT_EQ(source.next(frame, 1.0), Result::Frame);
    values.push_back(frame.pixels.at(0));
    EXPECT_EQ(frame.number, static_cast<std::uint64_t>(i)) << "the counter goes on over the loop";
  }
  EXPECT_EQ(values, (std::vector<int>{ 1, 2, 1, 2, 1 }));
}

TEST_F(FolderSourceTest, WaitsForItsRateWithinTheTimeout)
{
  writeImage("a.png", 1);
  writeImage("b.png", 2);
  FolderSourceParams params = fast(folder_.string());
  params.rate = 1.0;
  FolderSource source(params);
  Frame frame;
  ASSERT_EQ(source.next(frame, 0.0), Result::Frame) << "the first frame is due at once";
  const Stamp first = frame.stamp;
  EXPECT_EQ(source.next(frame, 0.01), Result::Timeout);
  ASSERT_EQ(source.next(frame, 10.0), Result::Frame);
  EXPECT_EQ(frame.stamp - first, 1000000000);
}

TEST_F(FolderSourceTest, PlaysAGlobAndCarriesTheExposure)
{
  writeImage("left_1.png", 1);
  writeImage("right_1.png", 2);
  FolderSourceParams params = fast(path("right_*.png"));
  params.exposure = 0.005;
  FolderSource source(params);
  Frame frame;
  ASSERT_EQ(source.next(frame, 1.0), Result::Frame);
  EXPECT_EQ(frame.pixels.at(0), 2);
  EXPECT_DOUBLE_EQ(frame.exposure, 0.005);
  EXPECT_EQ(frame.origin, path("right_1.png"));
  EXPECT_EQ(source.next(frame, 1.0), Result::End);
}

TEST_F(FolderSourceTest, ReportsABrokenImageAndGoesOnWithTheNext)
{
  writeImage("1.png", 1);
  writeImage("2.png", 2);
  writeImage("3.png", 3);
  truncate("2.png");
  FolderSource source(fast(folder_.string()));
  Frame frame;
  ASSERT_EQ(source.next(frame, 1.0), Result::Frame);
  ASSERT_EQ(source.next(frame, 1.0), Result::Failed);
  EXPECT_NE(source.message().find("2.png: the image is truncated"), std::string::npos) << source.message();
  ASSERT_EQ(source.next(frame, 1.0), Result::Frame);
  EXPECT_EQ(frame.pixels.at(0), 3);
  EXPECT_EQ(frame.number, 2u) << "a gap in the numbers shows the loss";
}

TEST_F(FolderSourceTest, ReportsAnImageOfAnotherSizeAndGoesOn)
{
  writeImage("1.png", 1, 32);
  writeImage("2.png", 2, 40);
  writeImage("3.png", 3, 32);
  FolderSource source(fast(folder_.string()));
  Frame frame;
  ASSERT_EQ(source.next(frame, 1.0), Result::Frame);
  ASSERT_EQ(source.next(frame, 1.0), Result::Failed);
  EXPECT_NE(source.message().find("2.png: is 40x24 mono8, but the images before it are 32x24 mono8"), std::string::npos)
      << source.message();
  EXPECT_EQ(source.next(frame, 1.0), Result::Frame);
}

TEST_F(FolderSourceTest, NamesWhatIsMissing)
{
  const std::string missing = path("nowhere");
  EXPECT_NE(whatOf([&] { FolderSource source(fast(missing)); }).find(missing + ": no such directory"),
            std::string::npos);
  EXPECT_NE(whatOf([&] { FolderSource source(fast(folder_.string())); }).find("no image in this directory"),
            std::string::npos);
  EXPECT_NE(whatOf([&] { FolderSource source(fast(path("*.png"))); }).find("matches no image"), std::string::npos);
}

TEST_F(FolderSourceTest, RefusesEachParameterOutOfRange)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  writeImage("1.png", 1);
  EXPECT_NE(whatOf([&] { FolderSource source(fast("")); }).find("camera/images is empty"), std::string::npos);
  for (const double rate : { 0.0, -1.0, 10001.0, nan })
  {
    FolderSourceParams params = fast(folder_.string());
    params.rate = rate;
    EXPECT_NE(whatOf([&] { params.validate(); }).find("camera/rate"), std::string::npos) << rate;
  }
  for (const double exposure : { -0.1, nan, 11.0 })
  {
    FolderSourceParams params = fast(folder_.string());
    params.exposure = exposure;
    EXPECT_NE(whatOf([&] { params.validate(); }).find("camera/exposure"), std::string::npos) << exposure;
  }
}

TEST_F(FolderSourceTest, ReadsGreyAndColourOfEightAndSixteenBits)
{
  const std::vector<std::pair<int, std::string>> kinds = {
    { CV_8UC1, "mono8" }, { CV_16UC1, "mono16" }, { CV_8UC3, "bgr8" }, { CV_16UC3, "bgr16" }, { CV_8UC4, "bgr8" }
  };
  for (const auto& [type, encoding] : kinds)
  {
    ASSERT_TRUE(cv::imwrite(path("x.png"), cv::Mat(5, 7, type, cv::Scalar(11, 22, 33, 44))));
    Frame frame;
    readImage(path("x.png"), frame);
    EXPECT_EQ(frame.encoding, encoding);
    EXPECT_EQ(frame.width, 7);
    EXPECT_EQ(frame.height, 5);
    ASSERT_EQ(frame.pixels.size(), frame.step * 5u);
    EXPECT_EQ(frame.pixels[0], 11) << encoding << ": blue (or grey) comes first";
  }
}

TEST_F(FolderSourceTest, NamesTheFileAndTheCauseOfEveryUnreadableImage)
{
  Frame frame;
  const auto refusal = [&](const std::string& name) { return whatOf([&] { readImage(path(name), frame); }); };
  std::ofstream(path("empty.png")).flush();
  std::ofstream(path("text.png")) << "this is text";
  writeImage("cut.jpg", 100);
  truncate("cut.jpg");
  ASSERT_TRUE(cv::imwrite(path("float.tiff"), cv::Mat(4, 4, CV_32FC1, cv::Scalar(1))));
  EXPECT_EQ(refusal("none.png"), path("none.png") + ": cannot be read: No such file or directory");
  EXPECT_NE(refusal("empty.png").find("empty.png: is empty"), std::string::npos);
  EXPECT_NE(refusal("text.png").find("text.png: not an image"), std::string::npos);
  EXPECT_NE(refusal("cut.jpg").find("cut.jpg: the image is truncated"), std::string::npos);
  EXPECT_NE(refusal("float.tiff").find("float.tiff: pixels are neither 8 nor 16 bit"), std::string::npos);
  EXPECT_NE(whatOf([&] { readImage(folder_.string(), frame); }).find("is a directory"), std::string::npos);
}
}  // namespace
}  // namespace weld_profiler
