#include "weld_profiler/stripe/workspace.h"

#include "scratch.h"

namespace weld_profiler
{
Workspace::Workspace() : scratch_(std::make_unique<Scratch>()) {}

Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

void Workspace::reset()
{
  direction.reset();
  last.clear();
  last.status = StripeStatus::NoStripe;
  initial.clear();
}
}  // namespace weld_profiler
