#include "derivatives.h"

#include <cmath>

#include "pixels.h"

namespace weld_profiler
{
namespace
{
constexpr double kReachSigmas = 4.0;

constexpr std::size_t kMostTaps = 168;  ///< of the widest Gaussian, 20 px

double dot(const double* a, const double* b, std::size_t size)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < size; ++i)
    sum += a[i] * b[i];
  return sum;
}

/// Adds a row of pixels, weighted, to the sums down the columns.
template <class Pixel>
void addRow(const Pixel* row, std::size_t size, double smooth, double first, double second, double* __restrict plain,
            double* __restrict slope, double* __restrict curvature)
{
  for (std::size_t i = 0; i < size; ++i)
  {
    const double gray = row[i];
    plain[i] += smooth * gray;
    slope[i] += first * gray;
    curvature[i] += second * gray;
  }
}
}  // namespace

void DerivativeKernel::setSobel(Sobel scaling)
{
  reach_ = 1;
  // The operator's own output is 8 times the first derivatives and 4 times the second; of that only the ratio, 2,
  // matters.
  first_gain_ = scaling == Sobel::Scaled ? 1.0 : 2.0;
  smooth_ = { 0.25, 0.5, 0.25 };
  first_ = { -0.5, 0.0, 0.5 };
  second_ = { 1.0, -2.0, 1.0 };
  finish();
}

void DerivativeKernel::setGaussian(double sigma)
{
  reach_ = static_cast<int>(std::ceil(kReachSigmas * sigma));
  first_gain_ = 1.0;
  const std::size_t size = 2 * static_cast<std::size_t>(reach_) + 1;
  smooth_.resize(size);
  first_.resize(size);
  second_.resize(size);
  const auto place = [this](std::size_t i) { return static_cast<double>(i) - reach_; };
  double sum = 0.0;
  for (std::size_t i = 0; i < size; ++i)
    sum += smooth_[i] = std::exp(-0.5 * place(i) * place(i) / (sigma * sigma));
  double square = 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    smooth_[i] /= sum;
    square += smooth_[i] * place(i) * place(i);
  }
  // Sampled and cut off, a kernel no longer has the moments of the Gaussian: given back, so that a slope of 1 and a
  // curvature of 1 measure 1, and a flat image measures 0.
  double fourth = 0.0;
  for (std::size_t i = 0; i < size; ++i)
    fourth += smooth_[i] * place(i) * place(i) * (place(i) * place(i) - square);
  for (std::size_t i = 0; i < size; ++i)
  {
    first_[i] = smooth_[i] * place(i) / square;
    second_[i] = 2.0 * smooth_[i] * (place(i) * place(i) - square) / fourth;
  }
  finish();
}

void DerivativeKernel::finish()
{
  noise_gain_ = first_gain_ * std::sqrt(dot(smooth_.data(), smooth_.data(), smooth_.size()) *
                                        dot(first_.data(), first_.data(), first_.size()));
}

void DerivativeKernel::copyFactors(std::vector<float>& factors) const
{
  factors.clear();
  for (const std::vector<double>* values : { &smooth_, &first_, &second_ })
    for (const double value : *values)
      factors.push_back(static_cast<float>(value));
}

bool DerivativeKernel::holds(const ImageView& image, int u, int v) const
{
  return u >= reach_ && v >= reach_ && u < image.width - reach_ && v < image.height - reach_;
}

Derivatives DerivativeKernel::at(const ImageView& image, int u, int v) const
{
  const std::size_t size = smooth_.size();
  double plain[kMostTaps];
  double slope[kMostTaps];
  double curvature[kMostTaps];
  for (double* sums : { plain, slope, curvature })
    std::fill_n(sums, size, 0.0);
  withPixel(image,
            [&](auto pixel)
            {
              using Pixel = decltype(pixel);
              for (std::size_t j = 0; j < size; ++j)
                addRow(image.row<Pixel>(v - reach_ + static_cast<int>(j)) + (u - reach_), size, smooth_[j], first_[j],
                       second_[j], plain, slope, curvature);
            });
  Derivatives result;
  result.x = first_gain_ * dot(first_.data(), plain, size);
  result.y = first_gain_ * dot(smooth_.data(), slope, size);
  result.xx = dot(second_.data(), plain, size);
  result.xy = dot(first_.data(), slope, size);
  result.yy = dot(smooth_.data(), curvature, size);
  return result;
}
}  // namespace weld_profiler
