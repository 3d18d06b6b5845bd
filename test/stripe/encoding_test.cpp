// What selectChannel refuses.
#include "stripe/encoding.h"

#include <gtest/gtest.h>

#include "stripe/channel.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
TEST(Encoding, RefusesAnUnknownEncodingAndListsTheKnown)
{
  std::vector<std::uint8_t> bytes(100);
  RawImage image;
  image.data = bytes.data();
  image.width = image.height = 5;
  image.step = 10;
  image.encoding = "yuv422";
  ChannelMemory memory;
  try
  {
    selectChannel(image, Region{ 0, 0, 5, 5 }, "red", memory);
    FAIL();
  }
  catch (const PreconditionError& error)
  {
    for (const char* part : { "yuv422", "mono8", "mono16", "bayer_rggb16", "bgra8" })
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(Encoding, RefusesAStepTooShortForItsColumns)
{
  std::vector<std::uint8_t> bytes(100);
  RawImage image;
  image.data = bytes.data();
  image.width = image.height = 5;
  image.step = 14;
  image.encoding = "rgb8";
  ChannelMemory memory;
  EXPECT_THROW(selectChannel(image, Region{ 0, 0, 5, 5 }, "red", memory), PreconditionError);
}

TEST(Encoding, RefusesAStepThatIsNotOfWholeSamples)
{
  std::vector<std::uint8_t> bytes(100);
  RawImage image;
  image.data = bytes.data();
  image.width = image.height = 5;
  image.step = 11;
  ChannelMemory memory;
  for (const char* encoding : { "mono16", "bayer_rggb16" })
  {
    image.encoding = encoding;
    try
    {
      selectChannel(image, Region{ 0, 0, 5, 5 }, "red", memory);
      FAIL() << encoding;
    }
    catch (const PreconditionError& error)
    {
      for (const char* part : { "step", "11", "multiple of the 2 bytes", "pad the rows" })
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  image.encoding = "mono8";
  EXPECT_EQ(selectChannel(image, Region{ 0, 0, 5, 5 }, "red", memory).view.width, 5);
}
}  // namespace
}  // namespace weld_profiler
