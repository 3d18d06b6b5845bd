#include "scan_aligner.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "said.h"
#include "statistics.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr int kSteps = 15;
constexpr double kStill = 0.01;      // a step is the last when it moves by less [sigmas]
constexpr int kLeastPatches = 8;     // a side
constexpr double kLeastShare = 0.1;  // of a side's patches that are seen in both
constexpr double kLeastFit = 0.5;    // of those, near to each other after the alignment
constexpr double kSearched = 3.0;    // sigmas of the shift across, within which undercuts are looked for
constexpr double kCertain = 5e-5;    // of the shift across: no undercuts are needed [m]
constexpr double kTold = 0.5;        // of what is known beforehand: less certain is not told by any surface
constexpr double kDegree = 3.14159265358979323846 / 180.0;
const std::array<const char*, 2> kSides = { { "left", "right" } };

std::vector<std::uint8_t> wanted(const AlignTarget& before, const UndercutMatch& undercuts)
{
  std::vector<std::uint8_t> mask(before.grid.z.size(), 0);
  for (const ParentPatch& patch : before.parents.patches)
    for (const std::uint32_t i : patch.points)
      mask[i] = 1;
  undercuts.want(mask);
  return mask;
}

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts)
{
  throw InputError(said(parts...));
}
}  // namespace

ScanAligner::ScanAligner(const AlignTarget& before, const SurfaceView& after, const StandingMarks& marks,
                         const CompareParams& params)
  : before_(before),
    after_(after),
    marks_(marks),
    params_(params),
    bins_(before.grid, wanted(before, marks.undercuts)),
    up_((before.parents.normals[0] + before.parents.normals[1]).normalized())
{
}

/// What is known without looking: the part lies along the plates about where it lay.
Matrix6d ScanAligner::knowledge() const
{
  constexpr double kAnyHeight = 0.05, kAnyTilt = 0.5;  // [m], [rad]
  const Eigen::Matrix3d upright = up_ * up_.transpose(), level = Eigen::Matrix3d::Identity() - upright;
  Matrix6d information = Matrix6d::Zero();
  information.topLeftCorner<3, 3>() = level / square(params_.placement) + upright / square(kAnyHeight);
  information.bottomRightCorner<3, 3>() =
      upright / square(params_.placement_turn_deg * kDegree) + level / square(kAnyTilt);
  return information;
}

std::vector<MotionObservation> ScanAligner::observe(const Eigen::Isometry3d& motion)
{
  sampleSurface(after_, motion, bins_, samples_);
  const Eigen::Vector3d across = before_.along.cross(up_);
  std::vector<MotionObservation> observations;
  used_.clear();
  for (std::size_t i = 0; i < before_.parents.patches.size(); ++i)
  {
    const ParentPatch& patch = before_.parents.patches[i];
    const double rise = meanRise(before_.grid, patch, samples_);
    if (!std::isfinite(rise))
      continue;
    const Eigen::Vector3d& normal = before_.parents.normals[static_cast<std::size_t>(patch.side)];
    const Eigen::Vector3d from = patch.middle - before_.about;
    MotionObservation one;
    one.jacobian << normal, from.cross(normal);
    one.distance = normal.z() * rise;
    one.common = patch.side == 0 ? CommonError::LeftParent : CommonError::RightParent;
    one.shape = { 1.0, from.dot(before_.along) / kCommonLength, from.dot(across) / kCommonLength };
    observations.push_back(one);
    used_.push_back(i);
  }
  const auto add = [&observations](const std::vector<MotionObservation>& more)
  {
    observations.insert(observations.end(), more.begin(), more.end());
    return !more.empty();
  };
  by_toes_ = add(marks_.toes.observe(motion, before_.about));
  if (by_undercuts_)
    add(marks_.undercuts.observe(samples_, before_.about));
  return observations;
}

void ScanAligner::requireOverlap() const
{
  std::array<int, 2> seen{ { 0, 0 } };
  for (const std::size_t i : used_)
    ++seen[static_cast<std::size_t>(before_.parents.patches[i].side)];
  for (const std::size_t side : { 0U, 1U })
  {
    const int all = before_.parents.count[side];
    if (all < kLeastPatches)
      refuse("the scan before shows too little of the parent ", kSides[side], " of the weld (", all,
             " patches of 1.2 mm,", " must be ", kLeastPatches, "): give a scan that shows more beside the weld");
    if (seen[side] < kLeastPatches || seen[side] < kLeastShare * all)
      refuse("the scans do not overlap: the scan after shows ", seen[side], " of ", all, " patches of the parent ",
             kSides[side], " of the weld, give two scans of one place");
  }
}

void ScanAligner::requireNear(const Vector6d& motion) const
{
  const double shift = motion.head<3>().cwiseAbs().maxCoeff(), turn = motion.tail<3>().norm() / kDegree;
  if (!(shift <= params_.max_shift && turn <= params_.max_turn_deg))
    refuse("the scan after fits the one before only when moved by ", 1e3 * shift, " mm and turned by ", turn,
           " deg, must be within max_shift ", 1e3 * params_.max_shift, " mm and max_turn_deg ", params_.max_turn_deg,
           ": give two scans of one place of one part");
}

void ScanAligner::requireMatch(const MotionStep& step) const
{
  std::array<int, 2> seen{ { 0, 0 } }, near{ { 0, 0 } };
  for (std::size_t k = 0; k < used_.size(); ++k)
  {
    const auto side = static_cast<std::size_t>(before_.parents.patches[used_[k]].side);
    ++seen[side];
    near[side] += std::abs(step.residuals[k]) <= 3.0 * params_.max_residual ? 1 : 0;
  }
  for (const std::size_t side : { 0U, 1U })
    if (near[side] < kLeastFit * seen[side])
      refuse("the parents do not match: ", near[side], " of ", seen[side], " patches of the parent ", kSides[side],
             " of the weld lie on each other within ", 3e3 * params_.max_residual,
             " mm (3 max_residual), give two scans of one part");
  if (!(step.rms <= params_.max_residual))
    refuse("the parents do not match: they are ", 1e3 * step.rms, " mm apart (RMS), must be within max_residual ",
           1e3 * params_.max_residual, " mm, give two scans of one part");
}

void ScanAligner::tell(ScanAlignment& aligned) const
{
  const Eigen::Vector3d across = this->across(), along = up_.cross(across);
  const auto sigma = [&aligned](int first, const Eigen::Vector3d& direction)
  { return std::sqrt(direction.dot(aligned.covariance.block<3, 3>(first, first) * direction)); };
  aligned.across_told = sigma(0, across) < kTold * params_.placement;
  aligned.along_told = sigma(0, along) < kTold * params_.placement;
  aligned.turn_told = sigma(3, up_) < kTold * params_.placement_turn_deg * kDegree;
  aligned.by_toes = by_toes_;
  aligned.by_undercuts = by_undercuts_;
}

void ScanAligner::measureNoise(const MotionStep& step)
{
  std::vector<double> points, patches;
  for (std::size_t k = 0; k < used_.size(); ++k)
  {
    if (std::abs(step.residuals[k]) > 4.0 * step.scatter)
      continue;
    double sum = 0.0;
    int count = 0;
    for (const std::uint32_t i : before_.parents.patches[used_[k]].points)
    {
      if (!std::isfinite(samples_[i].z))
        continue;
      const double variance = pointVariance(before_.grid, i) + static_cast<double>(samples_[i].variance);
      const double error =
          (static_cast<double>(samples_[i].z) - static_cast<double>(before_.grid.z[i])) / std::sqrt(variance);
      points.push_back(error);
      sum += error;
      ++count;
    }
    patches.push_back(sum / std::sqrt(static_cast<double>(count)));
  }
  const double single = robustSigma(std::move(points)), mean = robustSigma(std::move(patches));
  if (!(single > 0.0))
    return;
  noise_.factor = std::max(1.0, single);
  noise_.alike = std::max(1.0, square(mean / single));
}

ScanAligner::Laid ScanAligner::lay(Eigen::Isometry3d motion)
{
  const Matrix6d known = knowledge();
  MotionStep step;
  for (int i = 0; i < kSteps; ++i)
  {
    const std::vector<MotionObservation> observations = observe(motion);
    requireOverlap();
    step = fitMotion(observations, stepOf(motion, before_.about), known);
    motion = motionOf(step.motion, before_.about) * motion;
    requireNear(stepOf(motion, before_.about));
    if (step.motion.dot(step.covariance.ldlt().solve(step.motion)) < square(kStill))
      break;
  }
  return { motion, step };
}

/// Where parents and toes leave the shift across uncertain. Walls are matched only when near to each other, so where
/// they are is looked for first.
ScanAligner::Laid ScanAligner::layByUndercuts(const Laid& without)
{
  const double sigma = std::sqrt(across().dot(without.last.covariance.topLeftCorner<3, 3>() * across()));
  if (marks_.undercuts.empty() || sigma < kCertain)
    return without;
  const Eigen::Isometry3d found = marks_.undercuts.search(after_, without.motion, across(), kSearched * sigma);
  by_undercuts_ = true;
  Laid laid = lay(found);
  if (marks_.undercuts.standing(samples_))
    return laid;
  by_undercuts_ = false;
  return lay(without.motion);
}

ScanAlignment ScanAligner::align()
{
  const Laid laid = layByUndercuts(lay(Eigen::Isometry3d::Identity()));
  const MotionStep& step = laid.last;
  requireMatch(step);
  measureNoise(step);
  ScanAlignment aligned;
  aligned.about = before_.about;
  const Vector6d whole = stepOf(laid.motion, before_.about);
  aligned.shift = whole.head<3>();
  aligned.rotation = whole.tail<3>();
  aligned.covariance = step.covariance;
  aligned.residual = step.rms;
  aligned.before_T_after = laid.motion;
  tell(aligned);
  return aligned;
}
}  // namespace weld
}  // namespace weld_profiler
