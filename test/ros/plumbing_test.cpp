#include <atomic>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "weld_profiler/ros/age_statistics.h"
#include "weld_profiler/ros/message_pool.h"
#include "weld_profiler/ros/work_queue.h"

namespace weld_profiler
{
namespace
{
TEST(WorkQueue, LiveLosesItsOldestItemAndSaysSo)
{
  WorkQueue<int> queue(2, false);
  EXPECT_EQ(queue.push(1), 0U);
  EXPECT_EQ(queue.push(2), 0U);
  EXPECT_EQ(queue.push(3), 1U);
  int item = 0;
  ASSERT_TRUE(queue.pop(item));
  EXPECT_EQ(item, 2);
}

TEST(WorkQueue, LosslessWaitsForRoomAndLosesNothing)
{
  WorkQueue<int> queue(2, true);
  constexpr int kItems = 1000;
  std::thread producer(
      [&]
      {
        for (int i = 0; i < kItems; ++i)
          EXPECT_EQ(queue.push(i), 0U);
      });
  for (int i = 0; i < kItems; ++i)
  {
    int item = -1;
    ASSERT_TRUE(queue.pop(item));
    ASSERT_EQ(item, i);
  }
  producer.join();
}

TEST(WorkQueue, ClosingWakesBothSides)
{
  WorkQueue<int> queue(1, true);
  queue.push(1);
  std::atomic<std::size_t> lost{ 0 };
  std::thread producer([&] { lost = queue.push(2); });
  queue.close();
  producer.join();
  EXPECT_EQ(lost, 1U) << "what comes after the end is lost, and said so";
  int item = 0;
  EXPECT_FALSE(queue.pop(item));
}

struct Blob
{
  int value = 0;
};

TEST(MessagePool, TakesAMessageBackOnlyWhenItsLastReaderLetsGo)
{
  MessagePool<Blob> pool;
  boost::shared_ptr<Blob> first = pool.take();
  const boost::shared_ptr<const Blob> reader = first;
  const Blob* address = first.get();
  first.reset();
  EXPECT_NE(pool.take().get(), address) << "somebody still reads it";
}

TEST(MessagePool, GivesTheSameMemoryAgainOnceItIsFree)
{
  MessagePool<Blob> pool;
  boost::shared_ptr<Blob> first = pool.take();
  const Blob* address = first.get();
  first.reset();
  EXPECT_EQ(pool.take().get(), address);
}

TEST(MessagePool, AMessageOutlivesThePool)
{
  boost::shared_ptr<Blob> message;
  {
    MessagePool<Blob> pool;
    message = pool.take();
    message->value = 7;
  }
  EXPECT_EQ(message->value, 7);
}

TEST(AgeStatistics, PercentilesOfAKnownSeries)
{
  AgeStatistics statistics(1000);
  for (int i = 0; i < 1000; ++i)
    statistics.add(0.001 * i, 0.02 * i);
  const AgeStatistics::Summary summary = statistics.summary();
  EXPECT_EQ(summary.count, 1000U);
  EXPECT_NEAR(summary.p50, 0.5, 1e-9);
  EXPECT_NEAR(summary.p99, 0.99, 1e-9);
  EXPECT_NEAR(summary.max, 0.999, 1e-9);
  EXPECT_NEAR(summary.rate, 50.0, 1e-6);
}

TEST(AgeStatistics, ForgetsWhatIsOlderThanItsWindow)
{
  AgeStatistics statistics(4);
  statistics.add(100.0, 0.0);
  for (int i = 1; i <= 4; ++i)
    statistics.add(1.0, i);
  EXPECT_EQ(statistics.summary().max, 1.0);
}
}  // namespace
}  // namespace weld_profiler
