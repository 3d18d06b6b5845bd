// The last frame's stripe saves time and changes nothing: every frame once in a stream and once on its own.
#include <gtest/gtest.h>

#include <cmath>

#include "support/extract.h"

namespace weld_profiler
{
namespace
{
using test_support::extract;
using test_support::paramsOf;
using test_support::Picture;
using test_support::render;
using test_support::StripePicture;

/// A bead on a plate that rises by some rows a frame.
StripePicture frameOf(int frame, double rise)
{
  StripePicture scene;
  scene.width = 480;
  scene.height = 720;
  scene.snr = 40.0;
  scene.seed = 50U + static_cast<unsigned>(frame);
  const double row = 300.0 + rise * frame;
  scene.row = [row](double u) { return row + 0.06 * u - 40.0 * std::exp(-0.5 * std::pow((u - 240.0) / 45.0, 2.0)); };
  return scene;
}

void expectSame(const Stripe& followed, const Stripe& alone)
{
  ASSERT_GT(alone.size(), 100U);
  ASSERT_EQ(followed.cell, alone.cell);
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    EXPECT_NEAR(followed.v[i], alone.v[i], 1e-3) << "cell " << alone.cell[i];
    EXPECT_NEAR(followed.u[i], alone.u[i], 1e-3) << "cell " << alone.cell[i];
    EXPECT_EQ(followed.flags[i], alone.flags[i]) << "cell " << alone.cell[i];
  }
}

class Follow : public ::testing::TestWithParam<std::string>
{
protected:
  /// In the stream, then as the only frame.
  void check(const Picture& picture)
  {
    stage_.process(picture.raw(), workspace_, followed_);
    expectSame(followed_, extract(paramsOf("ridge", GetParam()), picture));
  }

  Picture turned(const Picture& picture) const { return GetParam() == "u" ? picture : transposed(picture); }

private:
  StripeStage stage_{ paramsOf("ridge", GetParam()) };
  Workspace workspace_;
  Stripe followed_;
};

TEST_P(Follow, AStripeThatMovesSlowlyIsTheSame)
{
  for (int frame = 0; frame < 8; ++frame)
    check(turned(render(frameOf(frame, 2.7))));
}

TEST_P(Follow, AStripeThatJumpsIsFoundAgain)
{
  for (const double rise : { 0.0, 130.0, -90.0, 200.0 })
    check(turned(render(frameOf(1, rise))));
}

TEST_P(Follow, APieceThatAppearsElsewhereIsFound)
{
  check(turned(render(frameOf(0, 0.0))));
  StripePicture scene = frameOf(1, 0.0);
  const auto row = scene.row;
  scene.row = [row](double u) { return u < 120.0 ? 620.0 : row(u); };
  check(turned(render(scene)));
  check(turned(render(frameOf(2, 0.0))));
}

TEST_P(Follow, ABrighterStripeElsewhereIsTaken)
{
  StripePicture scene = frameOf(0, 0.0);
  scene.peak = 60.0;
  check(turned(render(scene)));
  scene.seed = 77;
  scene.ambient = [](double /*u*/, double v) { return 180.0 * std::exp(-0.5 * std::pow((v - 600.0) / 2.5, 2.0)); };
  check(turned(render(scene)));
}

TEST_P(Follow, AFrameWithoutAStripeLeavesNothingBehind)
{
  check(turned(render(frameOf(0, 0.0))));
  const StripeStage stage(paramsOf("ridge", GetParam()));
  Workspace workspace;
  Stripe stripe;
  stage.process(turned(render(frameOf(0, 0.0))).raw(), workspace, stripe);
  stage.process(turned(test_support::blank(480, 720, 8.0)).raw(), workspace, stripe);
  EXPECT_EQ(stripe.size(), 0U);
  stage.process(turned(render(frameOf(3, 40.0))).raw(), workspace, stripe);
  EXPECT_GT(stripe.size(), 470U);
}

TEST_P(Follow, AnImageOfAnotherSizeIsSearched)
{
  check(turned(render(frameOf(0, 0.0))));
  StripePicture small = frameOf(1, 0.0);
  small.width = 200;
  small.height = 400;
  check(turned(render(small)));
  check(turned(render(frameOf(2, 0.0))));
}

INSTANTIATE_TEST_SUITE_P(BothDirections, Follow, ::testing::Values("u", "v"));
}  // namespace
}  // namespace weld_profiler
