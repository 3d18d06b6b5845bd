#include "fuzz/stripe_promises.h"

#include <cmath>
#include <sstream>

namespace weld_profiler
{
namespace fuzz
{
namespace
{
constexpr double kBeyond = 2.0;     ///< px that a centre may lie outside the image
constexpr double kFromCell = 1.51;  ///< px along the stripe from its cell: half a photosite's pitch and its offset
constexpr double kHalfPi = 1.57079632679489661923;

std::string ofPoint(const StripePoint& point, const RawImage& image, Direction direction)
{
  for (const float value : { point.u, point.v, point.normal_angle, point.intensity, point.width, point.sigma })
    if (!std::isfinite(value))
      return "a value is not finite";
  if (!(point.u >= -kBeyond && point.u <= image.width - 1 + kBeyond))
    return "u lies outside the image";
  if (!(point.v >= -kBeyond && point.v <= image.height - 1 + kBeyond))
    return "v lies outside the image";
  const bool along_u = direction == Direction::AlongU;
  if (point.cell >= (along_u ? image.width : image.height))
    return "the cell lies outside the image";
  if (std::abs((along_u ? point.u : point.v) - point.cell) > kFromCell)
    return "the centre lies outside its cell";
  if (!(point.normal_angle > -kHalfPi && point.normal_angle <= kHalfPi))
    return "the normal is turned too far";
  if (!(point.sigma > 0.0F) || !(point.width > 0.0F) || !(point.intensity > 0.0F))
    return "sigma, width or intensity is not positive";
  if ((point.flags & ~(stripe_flag::kInterpolated | stripe_flag::kSaturated | stripe_flag::kAmbiguous)) != 0)
    return "a flag that there is not";
  return {};
}

std::string told(const StripePoint& point)
{
  std::ostringstream text;
  text << " (cell " << point.cell << ", u " << point.u << ", v " << point.v << ", normal " << point.normal_angle
       << ", intensity " << point.intensity << ", width " << point.width << ", sigma " << point.sigma << ", flags "
       << static_cast<int>(point.flags) << ")";
  return text.str();
}
}  // namespace

std::string brokenPromise(const Stripe& stripe, const RawImage& image, const StripeParams& params)
{
  for (const auto* field :
       { &stripe.u, &stripe.v, &stripe.normal_angle, &stripe.intensity, &stripe.width, &stripe.sigma })
    if (field->size() != stripe.size())
      return "arrays of different lengths";
  if (stripe.flags.size() != stripe.size())
    return "arrays of different lengths";
  if (stripe.empty() == (stripe.status == StripeStatus::Ok))
    return "the status is Ok without a centre, or not Ok with some";
  if ((params.direction == "u" && stripe.direction != Direction::AlongU) ||
      (params.direction == "v" && stripe.direction != Direction::AlongV))
    return "the direction is not the one asked for";
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    if (i > 0 && stripe.cell[i] <= stripe.cell[i - 1])
      return "cells do not rise" + told(stripe[i]);
    if (const std::string broken = ofPoint(stripe[i], image, stripe.direction); !broken.empty())
      return broken + told(stripe[i]);
  }
  return {};
}
}  // namespace fuzz
}  // namespace weld_profiler
