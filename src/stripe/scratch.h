#pragma once

#include <cstdint>
#include <vector>

#include "along_stripe.h"
#include "centre_line.h"
#include "centroid.h"
#include "channel.h"
#include "column_moments.h"
#include "derivatives.h"
#include "gray_column.h"
#include "ridge_centres.h"
#include "site_normals.h"
#include "slot_choice.h"
#include "stripe_finder.h"
#include "taylor_step.h"
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
  StripeFinder finder;
  ColumnTrack track;
  AlongStripe along;

  // ridge
  RidgeCentres ridge_centres;

  // estimation
  ColumnCentroid centroid;
  SlotChoice choice;
  std::vector<Centre> centres;
  LineScatter scatter;
  DerivativeKernel kernel;
  std::vector<double> widths;
  Sites sites;
  SiteNormals normals;
  TaylorSteps steps;
  GrayColumn column;
  std::vector<double> gains;           ///< of the columns, of gauss_fit only
  std::vector<std::uint8_t> filtered;  ///< the whole frame's median, of the literal reading only
};
}  // namespace weld_profiler
