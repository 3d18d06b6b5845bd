#include "control_variates.h"

#include <algorithm>
#include <cmath>

#include "control_variates_kernels.h"

namespace weld_profiler
{
namespace
{
using namespace control_variates;

constexpr double kOutlier = 3.5;  // mean magnitudes
constexpr double kTypical = 2.0;  // a stretch is not trusted to be rougher than that many typical ones
constexpr float kLeast = 1e-9F;   // [px^2]
constexpr double kEnough = 24.0;
constexpr int kNeighbours = 2;         // stretches on either side that are asked as well, by less and less
constexpr double kCorrelated = 3.0;    // differences of means over common columns: so many count as one
constexpr double kSurely = 4.0;        // squared significance from which a correction is used
constexpr double kOutline = 2.5;       // scatter over what noise explains
constexpr double kSpeckleShare = 0.5;  // of the flanks, from which there is speckle beyond doubt
constexpr double kLikely = 1.1;
constexpr double kSpeckled = 1.9;          // more of it where there is speckle
constexpr double kGrainPerLikeness = 0.8;  // between white noise and a speckle whose neighbours are alike to 0.6
constexpr double kMostGrain = 2.2;
constexpr double kLargestShare = 1.1;

/// Share of a correction that pays: its least-squares value times how sure it is.
double sure(double share, double square, double rest)
{
  if (!(square > 0.0))
    return 0.0;
  const double significance = share * share * square / std::max(1e-18, rest) / kCorrelated;
  return std::clamp(share * std::max(0.0, 1.0 - kSurely / std::max(1e-9, significance)), 0.0, kLargestShare);
}
}  // namespace

void ControlVariates::Moments::add(const Moments& other, double share)
{
  count += share * other.count;
  ee += share * other.ee;
  ef += share * other.ef;
  ed += share * other.ed;
  ff += share * other.ff;
  fd += share * other.fd;
  dd += share * other.dd;
  lean += share * other.lean;
  fine += share * other.fine;
  uneven += share * other.uneven;
  light += share * other.light;
  width += share * other.width;
}

/// Variance of a mean over three columns that noise can have. What is the same in all pixels of a column shows between
/// neighbours; speckle, which neighbours share, shows in the light as well: where the light is uneven by a share u from
/// column to column, the centre scatters by about 0.96 u half widths.
ControlVariates::Explained ControlVariates::explained(const Moments& sum)
{
  constexpr double kSpecklePerLight = 0.92;
  constexpr double kWhite = 0.45;  // white noise makes the light uneven as well: that is not to be counted twice
  const double light = std::max(1e-9, sum.light / sum.count);
  const double fine = sum.fine / sum.count / 3.0;
  const double uneven = kSpecklePerLight * sum.width / sum.count * sum.uneven / sum.count / (light * light);
  return Explained{ fine + uneven, std::max(fine, kWhite * uneven) };
}

ControlVariates::Moments ControlVariates::momentsOf(const Means& means, int stretch, double most) const
{
  const int begin = stretch * kStretch;
  const int end = std::min(count_, begin + kStretch);
  double most_d = 0.0;
  dispatch<MagnitudeOf>(rough_difference_.data(), begin, end, &most_d);
  const MomentsOf::In in{ rough_.data(),
                          rough_feigned_.data(),
                          rough_difference_.data(),
                          means.difference,
                          fine_.data(),
                          rough_light_.data(),
                          means.light,
                          means.width,
                          begin,
                          end,
                          static_cast<float>(most + 1e-6),
                          static_cast<float>(kOutlier * most_d + 1e-6) };
  double s[MomentsOf::kSums];
  dispatch<MomentsOf>(in, s);
  return Moments{ s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9], s[10], s[11] };
}

/// Lower quartile of the stretches' mean magnitudes: a stripe that is broken or bent sharply in most of them must not
/// pass for a rough one.
double ControlVariates::typicalMagnitude()
{
  sorted_.clear();
  for (std::size_t i = 0; i < magnitudes_.size(); ++i)
  {
    const int begin = static_cast<int>(i) * kStretch;
    dispatch<MagnitudeOf>(rough_.data(), begin, std::min(count_, begin + kStretch), &magnitudes_[i]);
    if (magnitudes_[i] > 0.0)
      sorted_.push_back(magnitudes_[i]);
  }
  if (sorted_.empty())
    return 0.0;
  const auto quarter = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 4);
  std::nth_element(sorted_.begin(), quarter, sorted_.end());
  return *quarter;
}

/// Least squares of e - feigned f + flanks d.
StretchScatter ControlVariates::solve(const Moments& sum)
{
  StretchScatter result;
  double feigned = 0.0;
  double flanks = 0.0;
  const double determinant = sum.ff * sum.dd - sum.fd * sum.fd;
  if (determinant > 1e-6 * sum.ff * sum.dd)
  {
    feigned = (sum.ef * sum.dd - sum.ed * sum.fd) / determinant;
    flanks = -(sum.ed * sum.ff - sum.ef * sum.fd) / determinant;
  }
  else if (sum.dd > 0.0)
    flanks = -sum.ed / sum.dd;
  const double rest = (sum.ee - feigned * sum.ef + flanks * sum.ed) / sum.count;
  feigned = sure(feigned, sum.ff, rest);
  flanks = sure(flanks, sum.dd, rest);
  const double left = sum.ee + feigned * feigned * sum.ff + flanks * flanks * sum.dd - 2.0 * feigned * sum.ef +
                      2.0 * flanks * sum.ed - 2.0 * feigned * flanks * sum.fd;
  result.feigned = static_cast<float>(feigned);
  result.flanks = static_cast<float>(flanks);
  const Explained noise = explained(sum);
  const double seen = std::max(0.0, left / sum.count);
  // An outline is told from noise only where it is far beyond: what reflectance leaves of itself is averaged out as if
  // it were noise, and is no noise.
  result.variance = static_cast<float>((seen > kOutline * noise.most ? noise.most : seen) + kLeast);
  const double speckle = std::min(1.0, flanks / kSpeckleShare);
  result.told = static_cast<float>(std::min(seen, (kLikely + kSpeckled * speckle) * noise.likely) + kLeast);
  const double alike = 3.0 * seen / std::max<double>(kLeast, sum.fine / sum.count);
  result.grain = static_cast<float>(std::clamp(1.0 + kGrainPerLikeness * speckle * (alike - 1.0), 1.0, kMostGrain));
  result.lean = static_cast<float>(sum.lean / sum.count);
  result.difference = static_cast<float>(sum.dd / sum.count + kLeast);
  return result;
}

/// Of pieces too short for fifth differences six columns apart: what neighbours say, at least what pixel noise makes.
StretchScatter ControlVariates::ofShortPieces(const Means& means) const
{
  constexpr float kNoiseGain = 1.136F;  // variance of a centre, of unit noise over light and a half width of 1 px
  constexpr float kWhole = 2.5F;
  float sum = 0.0F;
  float count = 0.0F;
  float floor = 0.0F;
  float held = 0.0F;
  for (int i = kReach; i < count_ - kReach; ++i)
  {
    if (means.columns[i - 1] > kWhole && means.columns[i + 2] > kWhole)
    {
      sum += fine_[static_cast<std::size_t>(i)] * fine_[static_cast<std::size_t>(i)];
      count += 1.0F;
    }
    if (means.columns[i] > kWhole && means.light[i] > 0.0F)
    {
      floor += kNoiseGain * means.width[i] * means.noise * means.noise / (means.light[i] * means.light[i]);
      held += 1.0F;
    }
  }
  StretchScatter result;
  const float seen = sum / std::max(1.0F, count);
  result.variance = result.told = std::max(seen, floor / std::max(1.0F, held)) / 3.0F + kLeast;
  result.difference = kUnknown;  // flanks and core may differ: no one knows how much they do by themselves
  return result;
}

void ControlVariates::learn(const Means& means)
{
  count_ = means.count;
  for (std::vector<float>* rough : { &rough_, &rough_feigned_, &rough_difference_, &rough_light_, &fine_ })
  {
    rough->resize(static_cast<std::size_t>(count_));
    std::fill(rough->begin(), rough->begin() + std::min(kReach, count_), kUnknown);
    std::fill(rough->end() - std::min(kReach, count_), rough->end(), kUnknown);
  }
  dispatch<RoughnessOf>(means.centre, means.columns, count_, rough_.data());
  dispatch<RoughnessOf>(means.feigned, means.columns, count_, rough_feigned_.data());
  dispatch<RoughnessOf>(means.difference, means.columns, count_, rough_difference_.data());
  dispatch<FinenessOf>(means.light, count_, rough_light_.data());
  dispatch<FinenessOf>(means.single, count_, fine_.data());

  const int stretches = (count_ + kStretch - 1) / kStretch;
  magnitudes_.assign(static_cast<std::size_t>(stretches), 0.0);
  moments_.resize(static_cast<std::size_t>(stretches));
  stretches_.resize(static_cast<std::size_t>(stretches));
  const double typical = typicalMagnitude();
  for (int i = 0; i < stretches; ++i)
    moments_[static_cast<std::size_t>(i)] =
        momentsOf(means, i, kOutlier * std::min(magnitudes_[static_cast<std::size_t>(i)], kTypical * typical));
  for (int i = 0; i < stretches; ++i)
  {
    Moments sum;
    for (int reach = kNeighbours; reach < stretches + kNeighbours && sum.count < kEnough; ++reach)
    {
      sum = Moments{};
      for (int j = std::max(0, i - reach); j <= std::min(stretches - 1, i + reach); ++j)
        sum.add(moments_[static_cast<std::size_t>(j)], 1.0 - std::abs(j - i) / (reach + 1.0));
    }
    stretches_[static_cast<std::size_t>(i)] = sum.count < kFew ? ofShortPieces(means) : solve(sum);
  }
}
}  // namespace weld_profiler
