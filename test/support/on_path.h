#pragma once

#include <gtest/gtest.h>

#include "stripe/multiversion.h"

namespace weld_profiler
{
namespace test_support
{
/// Vector code takes a path as long as this lives.
class OnPath
{
public:
  explicit OnPath(VectorPath path) : before_(vectorPath().exchange(path)) {}
  ~OnPath() { vectorPath() = before_; }
  OnPath(const OnPath&) = delete;
  OnPath& operator=(const OnPath&) = delete;

private:
  VectorPath before_;
};

/// A test on every path in turn: INSTANTIATE_TEST_SUITE_P(..., Values(VectorPath::Plain, VectorPath::Avx2)).
class OnEachPath : public ::testing::TestWithParam<VectorPath>
{
protected:
  void SetUp() override
  {
    if (GetParam() > widestVectorPath())
      GTEST_SKIP() << "this processor has no such path";
  }

private:
  OnPath on_{ GetParam() <= widestVectorPath() ? GetParam() : VectorPath::Plain };
};
}  // namespace test_support
}  // namespace weld_profiler
