#pragma once

#include <set>
#include <string>
#include <vector>

#include <rosbag/bag.h>

#include "tools/bag_scan.h"

namespace weld_profiler
{
/// Which topics of a bag are scanned.
struct BagTopics
{
  std::string name_space;  ///< with its slashes: "/profiler/"
  std::string image, info, joints;

  /// With those of tf.
  std::vector<std::string> all() const { return { image, info, joints, "/tf", "/tf_static" }; }
};

/// @throws InputError when the bag lacks what is needed, or holds it more than once, naming what it holds and the
/// remedy.
BagTopics chooseTopics(const rosbag::Bag& bag, const BagScanParams& params);

/// "a, b", or "nothing".
std::string listOf(const std::set<std::string>& names);
}  // namespace weld_profiler
