#pragma once

#include <memory>
#include <vector>

#include "centroid.h"
#include "scratch.h"
#include "weld_profiler/stripe/stripe_extractor.h"
#include "weld_profiler/stripe/stripe_params.h"

namespace weld_profiler
{
/// What all methods share: finding the stripe, the initial centroid, and what is written of the result. A method moves
/// the centres from where the centroid put them.
class MethodBase : public StripeExtractor
{
public:
  explicit MethodBase(const StripeParams& params) : params_(params) {}

  void extract(const ImageView& image, const StripeHint& hint, Workspace& workspace, Stripe& stripe) const final;

protected:
  virtual CentroidWeight weight() const { return CentroidWeight::SquaredGray; }

  /// Refines scratch.centres; the slope of each is known. The default leaves them where they are.
  virtual void refine(const ImageView& image, Workspace::Scratch& scratch) const;

  const StripeParams& params() const { return params_; }

private:
  StripeParams params_;
};

/// The way out of every method: measures the scatter, writes the stripe and, if the caller asked for it, the trace.
void finish(const StripeParams& params, const Levels& levels, Workspace& workspace, Stripe& stripe);

std::unique_ptr<const StripeExtractor> makeGrayCentroid(const StripeParams& params);
std::unique_ptr<const StripeExtractor> makeSquaredCentroid(const StripeParams& params);
std::unique_ptr<const StripeExtractor> makeSvd(const StripeParams& params);
std::unique_ptr<const StripeExtractor> makePca(const StripeParams& params);
std::unique_ptr<const StripeExtractor> makeSteger(const StripeParams& params);
std::unique_ptr<const StripeExtractor> makeRidge(const StripeParams& params);
std::unique_ptr<const StripeExtractor> makeGaussFit(const StripeParams& params);
std::unique_ptr<const StripeExtractor> makeFirPeak(const StripeParams& params);
std::unique_ptr<const StripeExtractor> makeLogParabola(const StripeParams& params);
}  // namespace weld_profiler
