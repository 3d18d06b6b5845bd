#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "made_weld.h"

namespace weld_profiler
{
/// A made weld with the name of the test that runs on it.
struct MadeCase
{
  std::string name;
  MadeWeld weld;
};

using MadeChange = std::pair<std::string, std::function<void(MadeWeld&)>>;

/// A case for each change to a made weld, and one with the same weld flipped.
inline std::vector<MadeCase> bothWays(const std::vector<MadeChange>& changes)
{
  std::vector<MadeCase> cases;
  for (const MadeChange& change : changes)
  {
    MadeWeld weld;
    change.second(weld);
    cases.push_back({ change.first, weld });
    weld.flipped = true;
    cases.push_back({ change.first + "Flipped", weld });
  }
  return cases;
}

inline std::string nameOf(const ::testing::TestParamInfo<MadeCase>& info)
{
  return info.param.name;
}
}  // namespace weld_profiler
