#include "comparison/candidates.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "comparison/opencv_steger.h"
#include "reference/plain_svd.h"
#include "weld_profiler/stripe/stripe_methods.h"
#include "weld_profiler/stripe/stripe_stage.h"
#include "weld_profiler/stripe/workspace.h"

namespace weld_profiler
{
namespace comparison
{
namespace
{
constexpr double kKernelPerStripe = 1.155;  ///< Steger's kernel, 2 / sqrt(3) of the stripe's sigma

/// Room for the columns that a method tells each of its centres was measured over; none do where Memory has no such
/// member.
template <class Memory>
auto apertureOf(const Memory& workspace, std::size_t i, int) -> decltype(static_cast<int>(workspace.aperture[i]))
{
  return i < workspace.aperture.size() ? static_cast<int>(workspace.aperture[i]) : 0;
}
template <class Memory>
int apertureOf(const Memory&, std::size_t, long)
{
  return 0;
}

class OfThePackage : public Candidate
{
public:
  OfThePackage(const StripeParams& params, bool trace) : stage_(params) { workspace_.keep_trace = trace; }
  void process(const RawImage& image, Stripe& stripe) override { stage_.process(image, workspace_, stripe); }
  void reset() override { workspace_.reset(); }
  int columnsTold(std::size_t i) const override { return apertureOf(workspace_, i, 0); }

private:
  StripeStage stage_;
  Workspace workspace_;
};

class Textbook : public Candidate
{
public:
  explicit Textbook(double sigma) : steger_(sigma) {}
  void process(const RawImage& image, Stripe& stripe) override { steger_.process(image, stripe); }

private:
  OpencvSteger steger_;
};

/// The same over the rows around the stripe alone, told from the first frame it is given.
class TextbookInBand : public Candidate
{
public:
  explicit TextbookInBand(double sigma) : reach_(static_cast<int>(std::ceil(kReach * sigma))), steger_(sigma) {}
  void process(const RawImage& image, Stripe& stripe) override
  {
    if (rows_ == 0)
      findBand(image, stripe);
    RawImage band = image;
    band.data += static_cast<std::size_t>(first_) * image.step;
    band.height = std::min(rows_, image.height - first_);
    steger_.process(band, stripe);
    for (float& v : stripe.v)
      v += static_cast<float>(first_);
  }

private:
  static constexpr double kReach = 6.0;  ///< the kernel's, and what the stripe moves from frame to frame

  void findBand(const RawImage& image, Stripe& stripe)
  {
    StripeParams params;
    params.direction = "u";
    Workspace workspace;
    StripeStage(params).process(image, workspace, stripe);
    const auto range = std::minmax_element(stripe.v.begin(), stripe.v.end());
    first_ = std::max(0, static_cast<int>(stripe.empty() ? 0.0F : *range.first) - reach_);
    rows_ = (stripe.empty() ? image.height : static_cast<int>(*range.second) + reach_) - first_ + 1;
  }

  int reach_;
  int first_ = 0, rows_ = 0;
  OpencvSteger steger_;
};

/// The paper's chain over the whole frame, with the kernel that method svd takes for the stripe.
class PlainSvd : public Candidate
{
public:
  explicit PlainSvd(double sigma) : sigma_(sigma) {}
  void process(const RawImage& image, Stripe& stripe) override
  {
    const cv::Mat frame(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.data), image.step);
    stripe.clear();
    for (const reference::PlainCentre& centre : reference::plainSvd(frame, sigma_))
    {
      StripePoint point;
      point.cell = static_cast<std::uint16_t>(centre.cell);
      point.u = static_cast<float>(centre.u);
      point.v = static_cast<float>(centre.v);
      stripe.push_back(point);
    }
    stripe.status = stripe.empty() ? StripeStatus::NoStripe : StripeStatus::Ok;
  }

private:
  double sigma_;
};
}  // namespace

std::string defaultMethod()
{
  return StripeParams().method;
}

std::vector<std::string> candidateNames()
{
  std::vector<std::string> names = stripeMethods();
  names.emplace_back("opencv_steger");
  names.emplace_back("paper_to_the_letter");
  return names;
}

std::unique_ptr<Candidate> makeCandidate(const std::string& name, const CandidateSettings& settings)
{
  const std::size_t at = name.find('@');
  const std::string method = name.substr(0, at);
  const double kernel = at == std::string::npos ? 0.0 : std::atof(name.c_str() + at + 1);
  if (method == "opencv_steger")
    return std::make_unique<Textbook>(kernel > 0.0 ? kernel : kKernelPerStripe * settings.stripe_sigma);
  if (method == "opencv_steger_in_band")
    return std::make_unique<TextbookInBand>(kKernelPerStripe * settings.stripe_sigma);
  if (method == "svd_plain")
    return std::make_unique<PlainSvd>(0.25 * std::round(kKernelPerStripe * settings.stripe_sigma / 0.25));
  StripeParams params;
  params.method = method;
  params.direction = "u";
  params.hessian_sigma_px = kernel;
  if (!settings.repair)
    params.max_gap_px = 0;
  if (method == "paper_to_the_letter")
  {
    params.method = "svd";
    params.taylor = "literal";
    params.derivatives = "sobel";
    params.median_size_px = 3;
  }
  return std::make_unique<OfThePackage>(params, settings.trace);
}
}  // namespace comparison
}  // namespace weld_profiler
