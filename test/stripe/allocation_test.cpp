// After warm-up no frame allocates. Counted by replacing operator new, which is why this is a program of its own.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "support/extract.h"

namespace
{
std::atomic<long> allocations{ 0 };
}

// Not inlined: GCC would otherwise see malloc() and free() and warn of a mismatched pair.
__attribute__((noinline)) void* operator new(std::size_t size)
{
  ++allocations;
  if (void* memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}

__attribute__((noinline)) void operator delete(void* memory) noexcept
{
  std::free(memory);
}

__attribute__((noinline)) void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace weld_profiler
{
namespace
{
struct Case
{
  const char* direction;
  const char* encoding;
  const char* taylor;
};

TEST(Allocation, HappensInTheFirstFramesOnly)
{
  test_support::StripePicture scene;
  scene.width = 500;
  scene.height = 200;
  scene.snr = 50.0;
  scene.row = [](double u) { return 120.0 + 30.0 * std::sin(u / 40.0); };
  scene.gain = [](double u) { return u > 200.0 && u < 210.0 ? 0.0 : 1.0; };
  const test_support::Picture picture = render(scene);
  for (const std::string& method : stripeMethods())
    for (const Case& c :
         { Case{ "u", "mono8", "sound" }, Case{ "v", "mono8", "sound" }, Case{ "auto", "mono8", "sound" },
           Case{ "u", "bayer_rggb8", "sound" }, Case{ "u", "mono8", "literal" } })
    {
      StripeParams params = test_support::paramsOf(method, c.direction);
      params.taylor = c.taylor;
      const test_support::Picture turned = transposed(picture);
      RawImage image = c.direction[0] == 'v' ? turned.raw() : picture.raw();
      image.encoding = c.encoding;
      const StripeStage stage(params);
      Workspace workspace;
      workspace.keep_trace = true;
      Stripe stripe;
      for (int i = 0; i < 3; ++i)
        stage.process(image, workspace, stripe);
      ASSERT_GT(stripe.size(), 100U) << method << ' ' << c.direction << ' ' << c.encoding;
      const long before = allocations;
      for (int i = 0; i < 3; ++i)
        stage.process(image, workspace, stripe);
      EXPECT_EQ(allocations - before, 0) << method << ' ' << c.direction << ' ' << c.encoding << ' ' << c.taylor;
    }
}

TEST(Allocation, IsCounted)
{
  const long before = allocations;
  ::operator delete(::operator new(3));
  EXPECT_GT(allocations, before);
}
}  // namespace
}  // namespace weld_profiler
