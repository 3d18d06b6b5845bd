#pragma once

#include <string>
#include <vector>

#include "weld_profiler/weld/verdict.h"

namespace weld_profiler
{
/// A size and what it is compared with, at one place of the weld.
struct Place
{
  std::string side;
  std::size_t cell = 0;  ///< index of its section
  double s = 0.0;        ///< along the path [m]
  Quantity value;
  Quantity limit;
  Quantity margin;
  int count = 1;  ///< sections that the median was taken of
};

/// The median by margin within half a window before and after each place. Sigma is the sections' own: neighbours share
/// points and parents, so that nothing is gained for certain.
/// @param places  of one side, s rising.
std::vector<Place> runningMedians(const std::vector<Place>& places, double window);

/// What the size of an imperfection says, the short rule aside.
struct SizeDecision
{
  Decision decision = Decision::NotMeasured;
  Place place;  ///< the place that decides
};

/// How many sigmas beyond its limit each median must be to fail the weld: 2 if their noise is the same all along, more
/// if they are few and independent, so that the largest of all is beyond by chance in no more than 2.3 % of welds.
std::vector<double> failSigmas(const std::vector<Place>& medians);

/// Fails if any median is beyond its limit for certain; passes if each is within by 2 sigma and no single section is
/// beyond.
SizeDecision decideSize(const std::vector<Place>& singles, const std::vector<Place>& medians);
}  // namespace weld_profiler
