#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// Where a method started in a cell: the pixel block and the initial (centroid) point, for the overlay. [px]
struct InitialPoint
{
  float block_u = 0.0F, block_v = 0.0F;  ///< centre of the pixel block the template was laid on
  float u = 0.0F, v = 0.0F;              ///< initial centre point
};

/// Scratch memory and learnt state of one stream of frames. One a thread; reused from frame to frame.
class Workspace
{
public:
  Workspace();
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;

  /// Forgets what was learnt (direction, last stripe); keeps the memory.
  void reset();

  std::optional<Direction> direction;  ///< found by `auto` beyond doubt, kept until reset()
  Stripe last;                         ///< last frame's stripe along the rows searched: cell and v alone are kept
  bool keep_trace = false;             ///< fill `initial` (the overlay wants it)
  std::vector<InitialPoint>
      initial;  ///< one a centre of the last stripe, in full image coordinates; empty unless keep_trace

  /// Columns that each centre was measured over (`ridge`), one a centre of the last stripe before repair.
  std::vector<std::uint16_t> aperture;

  struct Scratch;  ///< private to the stripe room
  Scratch& scratch() { return *scratch_; }

private:
  std::unique_ptr<Scratch> scratch_;
};
}  // namespace weld_profiler
