#include "toe_fit.h"

#include <algorithm>
#include <cmath>

#include "face_window.h"
#include "statistics.h"
#include "undercut_flank.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr int kRounds = 5;
constexpr double kConverged = 1e-6;      // [m]
constexpr double kOutsideGuess = 3e-3;   // the toe is looked for this far outside its guess [m]
constexpr double kStartLevel = 0.15;     // of the face's height: the search begins inside of where it crosses this
constexpr double kStartHeight = 4.5e-5;  // ... but no higher than this [m]
constexpr double kSteepest = 1.45;       // a face nearer to upright was not measured [rad]
constexpr double kLargestFlank = 2.6;    // between parent and face, in a corner [rad]
constexpr double kFalling = -0.3;        // a face that falls more steeply from its toe is a groove's [rad]
constexpr double kDeepest = 1.5e-3;      // ... as is one that lies deeper below its parent [m]
constexpr double kBeyond = 0.3;          // of its height: where the search begins on a rise outside of a crossing
constexpr double kCrest = 1.5;           // levels that a crest stands out of what lies beside it
constexpr double kToldWell = 1.5e-5;     // a toe better known than this needs no other witness [m]
constexpr double kShallowest = 0.005;    // one flatter meets its parent nowhere in particular [rad]
constexpr double kBias = 1.5e-6;         // what the kink's blur leaves in a toe's place, along the parent [m] ...
constexpr double kBiasCut = 3.6e-6;      // ... where the profile goes on below the parent
constexpr double kFaceBias = 1.9e-6;     // ... and in its face, square to it [m] ...
constexpr double kFlatBias = 3.5e-6;  // ... where the kink is too flat for the stripe's windows to be shortened there
constexpr double kFlat = 0.25;        // it is, up to this [rad] ...
constexpr double kBent = 0.35;        // ... and from here on it is not [rad]
constexpr double kCut = 1.5e-5;       // it does, where it lies this far below beside the toe [m]

/// The side's profile with u rising inward from the parent to the weld's middle.
class ToeSearch
{
public:
  ToeSearch(const SectionProfile& profile, const ToeQuestion& question, const ParentFit& parent,
            const WeldParams& params)
    : parent_(parent), params_(params)
  {
    inward_ = -sign(question.side);
    line_ = Line{ parent.line.height, inward_ * parent.line.slope };
    along_ = Eigen::Vector2d(1.0, line_.slope).normalized();
    const double middle = inward_ * 0.5 * (question.guess + question.opposite);
    const double outside = inward_ * question.guess - kOutsideGuess;
    width_ = std::abs(question.opposite - question.guess);
    const auto take = [&](std::size_t i)
    {
      const double u = inward_ * profile.q[i];
      if (u >= outside && u <= middle)
        points_.push_back(Eigen::Vector2d(u, profile.z[i]));
    };
    points_.reserve(profile.size());
    for (std::size_t i = 0; i < profile.size(); ++i)
      take(inward_ > 0.0 ? i : profile.size() - 1 - i);
    above_.reserve(points_.size());
    for (const Eigen::Vector2d& point : points_)
      above_.push_back((point.y() - line_.at(point.x())) * along_.x());
  }

  ToeFit operator()()
  {
    ToeFit toe;
    double start = kNaN;
    if (!begin(start))
      return toe;
    double place = start;
    for (int round = 0; round < kRounds; ++round)
    {
      toe.face = FaceArc::fit(window(place));
      if (!toe.face.valid())
        return toe;
      const Eigen::Vector2d at(place, line_.at(place));
      const double move = toe.face.meet(at, along_) * along_.x();
      if (!(std::abs(move) < kOutsideGuess))
        return toe;
      place += move;
      if (std::abs(move) < kConverged)
        break;
    }
    finish(place, toe);
    return toe;
  }

private:
  /// Mean of three neighbours: one point does not decide where the search begins.
  double smoothAbove(std::size_t i) const { return (above_[i - 1] + above_[i] + above_[i + 1]) / 3.0; }

  /// Where the outline, from the weld's middle outward, comes down to the parent: just inside of the toe. Beside the
  /// higher one of two plates a low face may fall from its toe and lie below the parent all along; then where it comes
  /// up.
  bool begin(double& start) const
  {
    if (points_.size() < 8)
      return false;
    double top = 0.0, bottom = 0.0;
    for (std::size_t i = 1; i + 1 < points_.size(); ++i)
    {
      top = std::max(top, smoothAbove(i));
      bottom = std::max(bottom, -smoothAbove(i));
    }
    if (beginAt(1.0, top, start))
      return true;
    if (!(bottom < kDeepest) || !beginAt(-1.0, bottom, start))
      return false;
    lookBeyond(start);
    return true;
  }

  /// The face may have crossed the parent twice: a little above it between the toe and where it dives below.
  void lookBeyond(double& start) const
  {
    const double level = 4.0 * parent_.scatter;
    auto i = static_cast<std::size_t>(std::lower_bound(points_.begin(), points_.end() - 1, start,
                                                       [](const Eigen::Vector2d& point, double u)
                                                       { return point.x() < u; }) -
                                      points_.begin());
    const double sunk = kCrest * std::max(level, -smoothAbove(std::max<std::size_t>(i, 1)));
    double top = level;
    // an undercut's far rim is not the face's
    for (; i > 1 && smoothAbove(i - 1) > -sunk; --i)
      top = std::max(top, smoothAbove(i - 1));
    if (!(top > level))
      return;
    while (smoothAbove(i) < kBeyond * top)
      ++i;
    start = points_[i].x();
  }

  bool beginAt(double side, double top, double& start) const
  {
    const double level = std::max(4.0 * parent_.scatter, std::min(kStartLevel * top, kStartHeight));
    if (!(top > 1.5 * level))
      return false;
    std::size_t i = points_.size() - 2;
    while (i > 0 && side * smoothAbove(i) < 0.5 * top)
      --i;
    std::size_t nearest = i;  // to the parent
    while (i > 0 && side * smoothAbove(i) > level)
    {
      nearest = side * smoothAbove(i) < side * smoothAbove(nearest) ? i : nearest;
      // between a face that falls from its toe and an undercut the toe is a crest below the parent
      if (side < 0.0 && smoothAbove(i) < smoothAbove(nearest) - kCrest * level)
        break;
      --i;
    }
    start = points_[i > 0 && side < 0.0 ? nearest : i].x();
    return i > 0;
  }

  std::vector<FacePoint> window(double toe) const
  {
    return faceWindow(points_, Eigen::Vector2d(toe, line_.at(toe)), faceReach(width_, params_), params_);
  }

  bool cutBeside(double toe) const
  {
    std::vector<double> heights;
    for (std::size_t i = 0; i < points_.size(); ++i)
    {
      if (points_[i].x() < toe - params_.edge_blur && points_[i].x() > toe - 4.0 * params_.edge_blur)
        heights.push_back(above_[i]);
    }
    return median(std::move(heights)) < -kCut;
  }

  void finish(double place, ToeFit& toe) const
  {
    const Eigen::Vector2d corner(place, line_.at(place));
    toe.flank = toe.face.direction(corner) - std::atan(line_.slope);
    if (!(std::abs(toe.flank) > kShallowest && toe.flank > kFalling && toe.flank < kLargestFlank &&
          toe.face.direction(corner) < kSteepest))
      return;
    toe.q = inward_ * place;
    toe.z = corner.y();
    toe.energy = std::max(square(parent_.scatter) * parent_.correlated_cells, square(toe.face.scatter()) * 5.0);
    const double face = toe.face.sigmaAcross(corner, toe.energy);
    const double line = parent_.sigmaAt(toe.q) * along_.x();
    // a flat face's angle is as uncertain as its height
    const double doubt = toe.face.sigmaDirection(corner, toe.energy);
    const double steepness = std::abs(std::sin(std::max(std::abs(toe.flank) - doubt, kShallowest)));
    toe.sigma = std::hypot(face, line * std::cos(toe.flank)) / steepness;
    toe.bias = std::max(cutBeside(place) ? kBiasCut : kBias, faceBias(toe.flank) / steepness);
    toe.found = true;
    lookFromOutside(place, toe);
  }

  /// A flat face says little of the place where it meets the parent; the flank of an undercut may say more.
  void lookFromOutside(double place, ToeFit& toe) const
  {
    const double told = std::hypot(toe.sigma, toe.bias);
    if (told < kToldWell)
      return;
    std::vector<Eigen::Vector2d> outline;
    outline.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      outline.emplace_back(points_[i].x(), above_[i]);
    const Quantity flank = flankToe(outline, place, parent_.scatter);
    if (!flank.measured())
      return;
    const double share = square(told) / (square(told) + square(flank.sigma));
    const double better = (1.0 - share) * place + share * flank.value;
    toe.q = inward_ * better;
    toe.z = line_.at(better);
    toe.sigma *= std::sqrt(1.0 - share);
    toe.bias = std::hypot(toe.bias * (1.0 - share), flank.sigma * share);
  }

  const ParentFit& parent_;
  const WeldParams& params_;
  double inward_ = 1.0;
  double width_ = 0.0;
  Line line_;
  Eigen::Vector2d along_;
  std::vector<Eigen::Vector2d> points_;  ///< (u, z), u rising
  std::vector<double> above_;            ///< of each point, its height above the parent line
};
}  // namespace

double faceBias(double flank)
{
  const double share = std::min(1.0, std::max(0.0, (std::abs(flank) - kFlat) / (kBent - kFlat)));
  return kFlatBias + share * (kFaceBias - kFlatBias);
}

ToeFit fitToe(const SectionProfile& profile, const ToeQuestion& question, const ParentFit& parent,
              const WeldParams& params)
{
  if (!parent.valid())
    return ToeFit();
  return ToeSearch(profile, question, parent, params)();
}
}  // namespace weld
}  // namespace weld_profiler
