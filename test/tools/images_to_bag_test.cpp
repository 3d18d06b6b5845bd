#include "bag_contents.h"
#include "run_command_line.h"
#include "stripe_image.h"

namespace weld_profiler
{
namespace
{
const char* const kCalibration = R"(version: 1
camera:
  image_width: 320
  image_height: 240
  camera_matrix: [1000.0, 0.0, 159.5, 0.0, 1000.0, 119.5, 0.0, 0.0, 1.0]
  distortion_model: plumb_bob
  distortion_coefficients: [0.1, 0.0, 0.0, 0.0, 0.0]
laser_plane:
  normal: [0.0, 0.8660254, 0.5]
  distance: 0.125
stage:
  type: linear
  joint: rail
  axis: [0.0, -0.8660254, -0.5]
  metres_per_unit: 0.001
)";

const char* const kCameraInfo = R"(image_width: 320
image_height: 240
camera_name: test
camera_matrix: {rows: 3, cols: 3, data: [1000, 0, 159.5, 0, 1000, 119.5, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0.1, 0, 0, 0, 0]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [1000, 0, 159.5, 0, 0, 1000, 119.5, 0, 0, 0, 1, 0]}
)";

class ImagesToBag : public CommandTest
{
protected:
  void SetUp() override
  {
    CommandTest::SetUp();
    write("calibration.yaml", kCalibration);
    write("camera.yaml", kCameraInfo);
    std::filesystem::create_directory(folder_ / "scan");
    for (int i = 1; i <= 11; ++i)  // 10 and 11 sort before 2 by their letters
      writeStripeImage(path("scan/img" + std::to_string(i) + ".png"), 100.0 + i);
  }

  CommandResult convert(const std::string& changes = "", const std::string& setup = ":") const
  {
    return run("images_to_bag", "--images scan --pitch-mm 0.5 --fps 10 --out scan.bag " + changes, setup);
  }
};

TEST_F(ImagesToBag, WritesImagesInNaturalOrderWithTheEncoderTheyImply)
{
  ASSERT_EQ(convert("--camera calibration.yaml").status, 0);
  const BagContents bag = readBag(path("scan.bag"));
  ASSERT_EQ(bag.images.size(), 11u);
  ASSERT_EQ(bag.infos.size(), 11u);
  EXPECT_TRUE(bag.times_are_stamps);
  EXPECT_EQ(bag.topics.size(), 3u);
  EXPECT_EQ(bag.topics.count("/profiler/joint_states"), 1u);
  for (std::size_t i = 0; i < bag.images.size(); ++i)
  {
    const sensor_msgs::Image& image = *bag.images[i];
    EXPECT_EQ(image.encoding, "mono8");
    EXPECT_EQ(image.header.frame_id, "camera_optical_frame");
    EXPECT_EQ(image.header.stamp.toNSec(), 1000000000000u + i * 100000000u);
    EXPECT_EQ(bag.infos[i]->header.stamp, image.header.stamp);
    const std::size_t row = 101 + i;
    EXPECT_EQ(image.data[row * image.step], 185) << "image " << i + 1 << " has its peak in row " << row;
  }
  EXPECT_DOUBLE_EQ(bag.infos[0]->K[0], 1000.0);
  EXPECT_DOUBLE_EQ(bag.infos[0]->D.at(0), 0.1);
}

TEST_F(ImagesToBag, TheEncoderBracketsEveryImageAtItsPlace)
{
  ASSERT_EQ(convert("--camera calibration.yaml").status, 0);
  const BagContents bag = readBag(path("scan.bag"));
  ASSERT_GT(bag.joints.size(), 100u);
  EXPECT_EQ(bag.joints[0]->name.at(0), "rail") << "the calibration's joint";
  for (std::size_t i = 1; i < bag.joints.size(); ++i)
    ASSERT_LE((bag.joints[i]->header.stamp - bag.joints[i - 1]->header.stamp).toSec(), 0.0101);
  for (std::size_t i = 0; i < bag.images.size(); ++i)
  {
    const ros::Time stamp = bag.images[i]->header.stamp;
    std::size_t after = 0;
    while (after < bag.joints.size() && bag.joints[after]->header.stamp <= stamp)
      ++after;
    ASSERT_GT(after, 0u) << "a sample lies before the image";
    ASSERT_LT(after, bag.joints.size()) << "and one after it";
    const auto& a = *bag.joints[after - 1];
    const auto& b = *bag.joints[after];
    const double part = (stamp - a.header.stamp).toSec() / (b.header.stamp - a.header.stamp).toSec();
    const double position = a.position.at(0) + part * (b.position.at(0) - a.position.at(0));
    EXPECT_NEAR(position, 0.5 * static_cast<double>(i), 1e-9) << "0.5 mm an image; this joint counts in mm";
  }
}

TEST_F(ImagesToBag, TakesARosCameraFileAndNames)
{
  ASSERT_EQ(convert("--camera camera.yaml --namespace /left --joint slide --start-time 5").status, 0);
  const BagContents bag = readBag(path("scan.bag"));
  ASSERT_EQ(bag.images.size(), 11u);
  EXPECT_EQ(bag.topics.count("/left/image_raw"), 1u);
  EXPECT_EQ(bag.joints.at(0)->name.at(0), "slide");
  EXPECT_EQ(bag.images.at(0)->header.stamp.toSec(), 5.0);
  EXPECT_NEAR(bag.joints.back()->position.at(0), 0.0005 * 11, 1e-6) << "in metres, a tenth of a second after the last";
}

TEST_F(ImagesToBag, SameImagesSameBytes)
{
  ASSERT_EQ(convert("--camera camera.yaml").status, 0);
  const std::string first = text("scan.bag");
  ASSERT_EQ(convert("--camera camera.yaml").status, 0);
  EXPECT_EQ(first, text("scan.bag"));
}

TEST_F(ImagesToBag, ABrokenImageOrOneOfAnotherSizeLeavesNoBag)
{
  writeStripeImage(path("scan/img12.png"), 100.0, 0.0, { 321, 240 });
  const CommandResult size = convert("--camera camera.yaml");
  EXPECT_EQ(size.status, 1);
  EXPECT_EQ(size.errorLines(), 1);
  EXPECT_TRUE(size.says("img12.png: is 321x240, but the camera in camera.yaml is 320x240")) << size.errors;
  std::filesystem::resize_file(path("scan/img12.png"), 500);
  const CommandResult broken = convert("--camera camera.yaml");
  EXPECT_EQ(broken.status, 1);
  EXPECT_TRUE(broken.says("img12.png: the image is truncated")) << broken.errors;
  EXPECT_EQ(filesIn("."), (std::vector<std::string>{ "calibration.yaml", "camera.yaml", "scan" }));
}

TEST_F(ImagesToBag, AFullDiskIsOneLineAndLeavesNothing)
{
  const CommandResult result = convert("--camera camera.yaml", "ulimit -f 100");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errorLines(), 1) << result.errors;
  EXPECT_TRUE(result.says("scan.bag: cannot be written")) << result.errors;
  EXPECT_EQ(filesIn("."), (std::vector<std::string>{ "calibration.yaml", "camera.yaml", "scan" }));
}

TEST_F(ImagesToBag, RefusesEachOptionOutOfRange)
{
  const std::string given = "--images scan --out scan.bag --camera camera.yaml ";
  const std::vector<std::pair<std::string, std::string>> bad = {
    { "--pitch-mm 0 --fps 10", "--pitch-mm is 0" },
    { "--pitch-mm nan --fps 10", "--pitch-mm is nan" },
    { "--pitch-mm 1 --fps 0", "--fps is 0" },
    { "--pitch-mm 1 --fps nan", "--fps is nan" },
    { "--pitch-mm 1 --fps 10 --encoder-hz 50", "--encoder-hz is 50" },
    { "--pitch-mm 1 --fps 10 --start-time 0", "--start-time is 0" },
    { "--pitch-mm 1 --fps 10 --namespace profiler", "--namespace is 'profiler'" },
  };
  for (const auto& [arguments, text] : bad)
  {
    const CommandResult result = run("images_to_bag", given + arguments);
    EXPECT_EQ(result.status, 1) << arguments;
    EXPECT_EQ(result.errorLines(), 1) << result.errors;
    EXPECT_TRUE(result.says(text)) << result.errors;
  }
  EXPECT_FALSE(std::filesystem::exists(path("scan.bag")));
}

TEST_F(ImagesToBag, NamesWhatCannotBeReadOrWritten)
{
  const std::string given = "--pitch-mm 1 --fps 10 ";
  const auto refusal = [&](const std::string& arguments) { return run("images_to_bag", given + arguments); };
  EXPECT_TRUE(refusal("--images none --camera camera.yaml --out b").says("none: no such directory"));
  EXPECT_TRUE(refusal("--images scan --camera none.yaml --out b").says("none.yaml: cannot be read"));
  EXPECT_TRUE(refusal("--images scan --camera camera.yaml --out no/b").says("no/b: cannot be written"));
  write("bad.yaml", "image_width: wide\n");
  const CommandResult bad = refusal("--images scan --camera bad.yaml --out b");
  EXPECT_EQ(bad.status, 1);
  EXPECT_TRUE(bad.says("bad.yaml")) << bad.errors;
  EXPECT_EQ(refusal("--images scan --camera camera.yaml").status, 2) << "--out is missing";
  EXPECT_EQ(refusal("--help").status, 0);
  EXPECT_FALSE(std::filesystem::exists(path("b")));
}
}  // namespace
}  // namespace weld_profiler
