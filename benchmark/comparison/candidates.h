#pragma once

#include <memory>
#include <string>
#include <vector>

#include "weld_profiler/core/image.h"
#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
namespace comparison
{
/// One contestant: a method of the package with its default parameters, or an outsider.
class Candidate
{
public:
  virtual ~Candidate() = default;
  virtual void process(const RawImage& image, Stripe& stripe) = 0;
  /// Forgets the frames before: the next one is searched everywhere.
  virtual void reset() {}
  /// Columns, centred on its cell, that measured centre i of the last frame (those that a repair filled are not
  /// counted) was measured over; 0 = it does not tell.
  virtual int columnsTold(std::size_t /*i*/) const { return 0; }
};

/// What a contestant is told about the scene: as much as a user would set.
struct CandidateSettings
{
  double stripe_sigma = 2.0;  ///< outsiders without an estimate of their own get their kernel from it [px]
  bool repair = true;         ///< gaps are filled, where the method can
  bool trace = true;          ///< kept for columnsTold(); off where time counts
};

/// The default method's name.
std::string defaultMethod();
/// Names of all contestants: every method in the table, then the outsiders `opencv_steger` (textbook) and
/// `paper_to_the_letter` (svd, taylor literal, sobel, median 3).
std::vector<std::string> candidateNames();
/// Also takes `svd_plain`, the paper's chain over the whole frame (8 bit), for its time, and `steger@2.0` and
/// `opencv_steger@2.0`: with a kernel of that sigma [px].
std::unique_ptr<Candidate> makeCandidate(const std::string& name, const CandidateSettings& settings = {});
}  // namespace comparison
}  // namespace weld_profiler
