#include "weld_profiler/scan/summary.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "geometry/temporary_folder.h"
#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

namespace
{
FrameBalance someBalance()
{
  FrameBalance balance;
  balance.frames_in = 21;
  balance.rows = 10;
  balance.no_stripe = 2;
  balance.skipped = 3;
  balance.unplaced = { { "encoder_gap", 1 }, { "before_first_sample", 2 } };
  balance.dropped = { { "queue_full", 3 } };
  return balance;
}
}  // namespace

TEST(Summary, HoldsTheBalanceInThisOrder)
{
  EXPECT_EQ(summary(someBalance()).text(), R"({
  "frames_in": 21,
  "rows": 10,
  "no_stripe": 2,
  "skipped": 3,
  "unplaced": {
    "before_first_sample": 2,
    "encoder_gap": 1
  },
  "dropped": {
    "queue_full": 3
  }
})");
}

TEST(Summary, HasEmptyObjectsWithoutReasons)
{
  const YAML::Node json = YAML::Load(summary(FrameBalance{}).text());
  EXPECT_TRUE(json["unplaced"].IsMap());
  EXPECT_EQ(json["dropped"].size(), 0u);
}

TEST(Summary, IsUtf8WhateverIsAdded)
{
  JsonObject object;
  object.add("file", "/rigs/N\xe4he/\xe2\x82\xac\xc3.yaml");
  EXPECT_EQ(object.text(), "{\n  \"file\": \"/rigs/N\\ufffdhe/\xe2\x82\xac\\ufffd.yaml\"\n}");
}

TEST(Summary, TakesMoreKeys)
{
  JsonObject object = summary(someBalance());
  object.add("scans", 2).add("pitch", 2.5e-4).add("poor", false).add("bag", "a \"b\"\\\n").add("mean", std::nan(""));
  object.add("shift", std::vector<double>{ 1e-4, -0.5, std::nan("") });
  const std::string text = object.text();
  EXPECT_NE(text.find("\"shift\": [0.0001, -0.5, null]"), std::string::npos) << text;
  EXPECT_NE(text.find("\"scans\": 2,"), std::string::npos) << text;
  EXPECT_NE(text.find("\"pitch\": 0.00025,"), std::string::npos) << text;
  EXPECT_NE(text.find("\"poor\": false,"), std::string::npos) << text;
  EXPECT_NE(text.find("\"mean\": null"), std::string::npos) << text;
  EXPECT_EQ(YAML::Load(text)["bag"].as<std::string>(), "a \"b\"\\\n");
}

TEST(Summary, IsWrittenWhole)
{
  const TemporaryFolder folder;
  writeSummary(summary(someBalance()), folder.file("summary.json"));
  EXPECT_EQ(readText(folder.file("summary.json")), summary(someBalance()).text() + "\n");
  EXPECT_THROW(writeSummary(summary(someBalance()), folder.file("absent/summary.json")), InputError);
  EXPECT_EQ(folder.entries(), 1u);
}
