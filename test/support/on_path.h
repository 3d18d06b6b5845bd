#pragma once

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
}  // namespace test_support
}  // namespace weld_profiler
