#pragma once

#include <cstdint>
#include <vector>

#include "candidates.h"
#include "centre_line.h"
#include "centroid.h"
#include "channel.h"
#include "continuity.h"
#include "derivatives.h"
#include "gray_column.h"
#include "weld_profiler/stripe/workspace.h"

namespace weld_profiler
{
/// The scratch memory of the stripe room.
struct Workspace::Scratch
{
  // the stage's
  ChannelMemory channel;
  std::vector<std::uint8_t> transposed;
  Stripe other;
  std::vector<InitialPoint> other_initial;

  // detection
  FrameStatistics statistics;
  CandidateFinder finder;
  CandidateList candidates;
  ContinuityTracker tracker;
  std::vector<Seed> seeds;

  // estimation
  ColumnCentroid centroid;
  std::vector<Centre> centres;
  LineScatter scatter;
  DerivativeKernel kernel;
  std::vector<double> widths;
  GrayColumn column;
  std::vector<double> gains;           ///< of the columns, of gauss_fit only
  std::vector<std::uint8_t> filtered;  ///< the whole frame's median, of the literal reading only
};
}  // namespace weld_profiler
