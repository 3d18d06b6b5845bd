#include "weld_profiler/stripe/overlay.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "channel.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
const cv::Scalar kYellow(0, 255, 255);
const cv::Scalar kRed(0, 0, 255);
const cv::Scalar kBlue(255, 64, 0);
const cv::Scalar kGreen(0, 255, 0);
const cv::Scalar kWhite(255, 255, 255);

constexpr int kShift = 4;                ///< fractional bits of OpenCV's drawing coordinates
constexpr int kDetailScale = 4;          ///< from here on single pixels can be told apart
constexpr float kGapCells = 4.0F;        ///< the curve is not drawn across more
constexpr float kTear = 3.0F;            ///< ... nor across a step steeper than this
constexpr float kNormalSpacing = 24.0F;  ///< of the arrows on a picture without detail [px of the picture]

/// From pixels of the image to OpenCV's drawing coordinates on the enlarged picture.
struct Enlarged
{
  int scale;

  cv::Point at(double u, double v) const { return { place(u), place(v) }; }

private:
  int place(double x) const { return static_cast<int>(std::lround(((x + 0.5) * scale - 0.5) * (1 << kShift))); }
};

cv::Mat background(const RawImage& image, int scale)
{
  ChannelMemory memory;
  const Region whole{ 0, 0, image.width, image.height };
  const ImageView view = selectChannel(image, whole, "luminance", memory).view;
  const int type = view.bit_depth == 8 ? CV_8UC1 : CV_16UC1;
  cv::Mat gray(view.height, view.width, type, const_cast<std::uint8_t*>(view.data), view.step);
  if (view.bit_depth == 16)
  {
    // Cameras of 10 or 12 bit fill the lower bits of the container: stretched to what is used.
    double brightest = 0.0;
    cv::minMaxLoc(gray, nullptr, &brightest);
    gray.convertTo(gray, CV_8U, 255.0 / std::max(1.0, brightest));
  }
  cv::Mat large;
  cv::resize(gray, large, cv::Size(), scale, scale, cv::INTER_NEAREST);
  cv::cvtColor(large, large, cv::COLOR_GRAY2BGR);
  return large;
}

void drawDot(cv::Mat& picture, const cv::Point& where, int radius, const cv::Scalar& colour)
{
  if (radius == 0)
  {
    const cv::Point pixel((where.x + (1 << (kShift - 1))) >> kShift, (where.y + (1 << (kShift - 1))) >> kShift);
    cv::line(picture, pixel, pixel, colour);
    return;
  }
  cv::circle(picture, where, radius << kShift, colour, cv::FILLED, cv::LINE_AA, kShift);
}

void drawCurve(cv::Mat& picture, const Stripe& stripe, const Enlarged& enlarged)
{
  const bool along_u = stripe.direction == Direction::AlongU;
  for (std::size_t i = 1; i < stripe.size(); ++i)
  {
    const float columns = std::abs(along_u ? stripe.u[i] - stripe.u[i - 1] : stripe.v[i] - stripe.v[i - 1]);
    const float rows = std::abs(along_u ? stripe.v[i] - stripe.v[i - 1] : stripe.u[i] - stripe.u[i - 1]);
    if (stripe.cell[i] - stripe.cell[i - 1] > kGapCells || rows > kTear * columns + 1.0F)
      continue;
    cv::line(picture, enlarged.at(stripe.u[i - 1], stripe.v[i - 1]), enlarged.at(stripe.u[i], stripe.v[i]), kRed, 1,
             cv::LINE_AA, kShift);
  }
}

void drawNormals(cv::Mat& picture, const Stripe& stripe, const Enlarged& enlarged)
{
  const bool detail = enlarged.scale >= kDetailScale;
  const auto every = detail ? 1U : static_cast<std::size_t>(std::ceil(kNormalSpacing / enlarged.scale));
  const double length = detail ? 3.0 : kNormalSpacing / enlarged.scale;
  for (std::size_t i = 0; i < stripe.size(); i += every)
  {
    // Of the two directions across the stripe always the one that points up.
    const double side =
        std::sin(stripe.normal_angle[i]) > 0.0 && stripe.direction == Direction::AlongU ? -length : length;
    const double u = stripe.u[i] + side * std::cos(stripe.normal_angle[i]);
    const double v = stripe.v[i] + side * std::sin(stripe.normal_angle[i]);
    cv::arrowedLine(picture, enlarged.at(stripe.u[i], stripe.v[i]), enlarged.at(u, v), kWhite, 1, cv::LINE_AA, kShift,
                    0.2);
  }
}
}  // namespace

cv::Mat drawStripe(const RawImage& image, const Stripe& stripe, const std::vector<InitialPoint>& initial, int scale)
{
  if (!(scale >= 1 && scale <= 16))
    throw PreconditionError("overlay scale is " + std::to_string(scale) + ", must be in [1, 16]");
  cv::Mat picture = background(image, scale);
  const Enlarged enlarged{ scale };
  // Concentric where they coincide: block, initial and exact point stay visible together.
  const int radius = scale >= kDetailScale ? std::max(1, scale / 6) : 0;
  drawNormals(picture, stripe, enlarged);
  drawCurve(picture, stripe, enlarged);
  for (const InitialPoint& point : initial)
    drawDot(picture, enlarged.at(point.block_u, point.block_v), radius == 0 ? 0 : radius + 2, kYellow);
  for (const InitialPoint& point : initial)
    drawDot(picture, enlarged.at(point.u, point.v), radius == 0 ? 0 : radius + 1, kRed);
  for (std::size_t i = 0; i < stripe.size(); ++i)
    drawDot(picture, enlarged.at(stripe.u[i], stripe.v[i]), radius,
            (stripe.flags[i] & stripe_flag::kInterpolated) != 0 ? kGreen : kBlue);
  return picture;
}
}  // namespace weld_profiler
