#include "column_moments.h"
#include "detector.h"
#include "method.h"
#include "scratch.h"

namespace weld_profiler
{
namespace
{
constexpr int kMostPasses = 3;

/// The centre line at the limit that noise sets: found as a path of sums over 8 columns, measured in each column by
/// matched weights, joined along the stripe as far as it is straight or bent evenly. See StripeFinder, ColumnMoments,
/// AlongStripe. Good for: everything a laser line is used for. Poor for: stripes steeper than 70 deg.
class Ridge : public StripeExtractor
{
public:
  explicit Ridge(const StripeParams& params) : params_(params) {}

  void extract(const ImageView& image, const StripeHint& hint, Workspace& workspace, Stripe& stripe) const final
  {
    Workspace::Scratch& scratch = workspace.scratch();
    workspace.initial.clear();
    stripe.direction = Direction::AlongU;
    stripe.status = detectStripe(image, params_, hint, scratch);
    if (stripe.status != StripeStatus::Ok)
    {
      stripe.clear();
      workspace.aperture.clear();
      return;
    }
    ColumnTrack& track = scratch.track;
    for (int pass = 1;; ++pass)
    {
      scratch.along.join(track, params_.max_aperture_px);
      if (pass == kMostPasses || !scratch.along.moveReference(track))
        break;
      ColumnMoments::measure(image, scratch.finder.noise(), track);
    }
    const StripeLimits limits = limitsOf(params_, levelsOf(image, params_), scratch.finder.noise());
    scratch.ridge_centres.write(track, scratch.along, limits, image.width, stripe, workspace.aperture);
    if (workspace.keep_trace)
      scratch.ridge_centres.trace(track, workspace.initial);
    stripe.status = stripe.empty() ? reasonForNone(image, params_) : StripeStatus::Ok;
  }

private:
  StripeParams params_;
};
}  // namespace

std::unique_ptr<const StripeExtractor> makeRidge(const StripeParams& params)
{
  return std::make_unique<Ridge>(params);
}
}  // namespace weld_profiler
