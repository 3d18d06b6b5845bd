#include <random>

#include <gtest/gtest.h>

#include "scan/bench.h"

using namespace weld_profiler;

namespace
{
/// A rig on which anything may happen at any time, the same for the same seed.
class Chaos
{
public:
  explicit Chaos(unsigned seed) : generator_(seed), bench(params()) {}

  void step()
  {
    now_ += (1 + draw(9)) * kMs;
    position_ += speed_ * 0.005;
    const int event = draw(200);
    if (event < 80)
      bench.frame(now_ - draw(30) * kMs / 4, draw(3), draw(40) == 0 ? 6 : 4);
    else if (event < 180)
      bench.sample(now_, draw(30) == 0 ? kNan : position_);
    else if (event < 185)
      now_ += 80 * kMs;  // longer than max_encoder_gap
    else if (event < 190)
      speed_ = -speed_;
    else if (event < 195)
      bench.builder->countDropped(draw(2) == 0 ? "queue_full" : "camera_info", static_cast<std::uint64_t>(draw(3)));
    else if (event < 198)
      now_ -= 500 * kMs;
    else
      bench.builder->finish();
  }

private:
  int draw(int below) { return static_cast<int>(generator_() % static_cast<unsigned>(below)); }

  ScanParams params()
  {
    ScanParams params;
    params.trigger = draw(2) == 0 ? "distance" : "time";
    params.on_reversal = draw(2) == 0 ? "split" : "ignore";
    params.max_waiting = 1 + draw(8);
    params.max_rows = max_rows = 1 + draw(20);
    params.pitch = draw(2) * 1e-3;
    return params;
  }

  std::mt19937 generator_;
  Stamp now_ = 1000 * kMs;
  double position_ = 0.0;
  double speed_ = 0.05;

public:
  int max_rows = 0;
  Bench bench;
};
}  // namespace

/// Whatever comes in whatever order: no frame is lost silently, and what was told agrees with what was counted.
TEST(FrameBalance, ClosesWhateverHappens)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    Chaos chaos(seed);
    for (int step = 0; step < 600; ++step)
    {
      chaos.step();
      ASSERT_TRUE(chaos.bench.closes()) << "seed " << seed << " step " << step;
    }
    chaos.bench.builder->finish();
    EXPECT_EQ(chaos.bench.builder->waiting(), 0u);
    const FrameBalance& balance = chaos.bench.balance();
    EXPECT_EQ(balance.frames_in, balance.accounted());
    std::size_t rows = 0;
    for (const Scan& scan : chaos.bench.scans)
    {
      EXPECT_FALSE(scan.empty());
      EXPECT_LE(scan.rows.size(), static_cast<std::size_t>(chaos.max_rows));
      rows += scan.rows.size();
    }
    EXPECT_EQ(rows, balance.rows + balance.no_stripe);
    EXPECT_EQ(chaos.bench.profiles.size(), balance.rows + balance.no_stripe + balance.skipped);
    EXPECT_GT(rows, 0u);
  }
}

TEST(FrameBalance, CountsDropsAsFramesThatCameIn)
{
  Bench bench;
  bench.builder->countDropped("queue_full", 3);
  bench.builder->countDropped("camera_info");
  bench.builder->countDropped("lost_by_driver", 0);
  EXPECT_EQ(bench.balance().frames_in, 4u);
  EXPECT_EQ(bench.balance().dropped.size(), 2u);
  EXPECT_EQ(bench.balance().dropped.at("queue_full"), 3u);
  EXPECT_TRUE(bench.closes());
}
