#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/messages.h"

namespace weld_profiler
{
namespace
{
Frame smallFrame()
{
  Frame frame;
  frame.width = 4;
  frame.height = 3;
  frame.step = 4;
  frame.encoding = "mono8";
  frame.pixels.assign(12, 9);
  frame.stamp = 1234567890123456789;
  frame.number = 42;
  return frame;
}

TEST(Messages, AStampSurvivesTheWayThereAndBack)
{
  EXPECT_EQ(fromRosTime(toRosTime(1234567890123456789)), 1234567890123456789);
}

TEST(Messages, AnImageTakesTheFramesMemory)
{
  Frame frame = smallFrame();
  const std::uint8_t* pixels = frame.pixels.data();
  const sensor_msgs::ImagePtr message = imageMessage(std::move(frame), "camera");
  EXPECT_EQ(message->data.data(), pixels);
  EXPECT_EQ(rawImage(*message).data, pixels);
  EXPECT_EQ(message->header.seq, 42U);
  EXPECT_EQ(message->header.frame_id, "camera");
}

TEST(Messages, AnImageThatDoesNotHoldItsPixelsIsRefused)
{
  sensor_msgs::Image image = *imageMessage(smallFrame(), "camera");
  image.data.resize(11);
  EXPECT_THROW(rawImage(image), PreconditionError);
  image = *imageMessage(smallFrame(), "camera");
  image.step = 3;
  EXPECT_THROW(rawImage(image), PreconditionError);
  image = *imageMessage(smallFrame(), "camera");
  image.width = 0;
  EXPECT_THROW(rawImage(image), PreconditionError);
  image = *imageMessage(smallFrame(), "camera");
  image.encoding = "purple8";
  EXPECT_THROW(rawImage(image), PreconditionError);
}

TEST(Messages, CameraInfoOfACalibrationFitsItAndGivesItBack)
{
  CameraCalibration camera;
  camera.distortion = { { -0.1, 0.02, 1e-4, -2e-4, 0.003 } };
  camera.roi_x = 8;
  camera.roi_y = 340;
  camera.roi_width = 1424;
  camera.roi_height = 400;
  const sensor_msgs::CameraInfo info = cameraInfoMessage(camera);
  EXPECT_EQ(cameraInfoMismatch(info, camera), "");
  const CameraCalibration back = cameraFromInfo(info);
  EXPECT_EQ(back.fx, camera.fx);
  EXPECT_EQ(back.cy, camera.cy);
  EXPECT_EQ(back.distortion, camera.distortion);
  EXPECT_EQ(back.roi_y, camera.roi_y);
  EXPECT_EQ(back.roi_width, camera.roi_width);
}

TEST(Messages, CameraInfoThatDiffersIsNamed)
{
  const CameraCalibration camera;
  const auto mismatch = [&](auto change)
  {
    sensor_msgs::CameraInfo info = cameraInfoMessage(camera);
    change(info);
    return cameraInfoMismatch(info, camera);
  };
  using Info = sensor_msgs::CameraInfo;
  EXPECT_NE(mismatch([](Info& i) { i.width = 640; }).find("width is 640"), std::string::npos);
  EXPECT_NE(mismatch([](Info& i) { i.height = 480; }).find("height"), std::string::npos);
  EXPECT_NE(mismatch([](Info& i) { i.K[0] *= 1.0 + 2e-6; }).find("K[0]"), std::string::npos);
  EXPECT_EQ(mismatch([](Info& i) { i.K[0] *= 1.0 + 5e-7; }), "") << "within 1e-6";
  EXPECT_NE(mismatch([](Info& i) { i.K[5] += 1.0; }).find("K[5]"), std::string::npos);
  EXPECT_NE(mismatch([](Info& i) { i.K.fill(0.0); }).find("K[0] is 0"), std::string::npos);
  EXPECT_NE(mismatch([](Info& i) { i.K[2] = std::nan(""); }).find("K[2]"), std::string::npos);
  EXPECT_NE(mismatch([](Info& i) { i.binning_x = 2; }).find("binning"), std::string::npos);
  EXPECT_EQ(mismatch([](Info& i) { i.binning_x = 0; }), "") << "0 is not binned, as 1 is";
  EXPECT_NE(mismatch([](Info& i) { i.roi.width = 700; }).find("roi.width is 700"), std::string::npos);
  EXPECT_EQ(mismatch([](Info& i) { i.roi.height = 1080; }), "") << "the whole sensor by its size";
  EXPECT_NE(mismatch([](Info& i) { i.roi.y_offset = 12; }).find("roi.y_offset"), std::string::npos);
}

TEST(Messages, StripeArraysOfDifferentLengthAreRefused)
{
  StripeProfile message;
  message.cell = { 1, 2 };
  message.u = { 1.0F };
  Stripe stripe;
  EXPECT_THROW(copyStripe(message, stripe), PreconditionError);
}

TEST(Messages, AScanBecomesAnOrganisedCloud)
{
  Scan scan;
  scan.frame_id = "part";
  scan.cells = 3;
  Profile row;
  row.stamp = 2'000'000'000;
  row.stage = 0.25;
  row.cells = 3;
  row.points = { CloudPoint{ 1.0F, 2.0F, 3.0F, 99.0F, 1e-6F, 1, 2 } };
  scan.rows = { row, row };
  scan.rows[1].stamp += 500'000'000;
  scan.rows[1].points.clear();
  const sensor_msgs::PointCloud2Ptr cloud = scanCloud(scan);
  EXPECT_EQ(cloud->height, 2U);
  EXPECT_EQ(cloud->width, 3U);
  EXPECT_EQ(cloud->point_step, 32U);
  EXPECT_EQ(cloud->row_step, 96U);
  EXPECT_FALSE(cloud->is_dense);
  EXPECT_EQ(cloud->header.stamp, ros::Time(2.0));
  ASSERT_EQ(cloud->fields.size(), 8U);
  EXPECT_EQ(cloud->fields[7].name, "flags");
  EXPECT_EQ(cloud->fields[7].offset, 28U);
  ASSERT_EQ(cloud->data.size(), 192U);
  const auto value = [&](std::size_t point, std::size_t offset)
  {
    float result = 0.0F;
    std::memcpy(&result, &cloud->data[point * 32 + offset], 4);
    return result;
  };
  EXPECT_TRUE(std::isnan(value(0, 0)));
  EXPECT_EQ(value(1, 0), 1.0F);
  EXPECT_EQ(value(1, 8), 3.0F);
  EXPECT_EQ(value(1, 12), 99.0F);
  EXPECT_EQ(value(1, 20), 0.25F);
  EXPECT_EQ(cloud->data[1 * 32 + 28], 2);
  EXPECT_TRUE(std::isnan(value(4, 8))) << "a frame without a stripe is a row of NaN";
}
}  // namespace
}  // namespace weld_profiler
