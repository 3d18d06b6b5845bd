#include "toe_angle.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kAngleSigmas = 1.2;  // the arc is a model: ripples and real faces depart from it
constexpr int kAngleSamples = 64;
constexpr double kAngleFace = 1e-3;        // interfaces: the face's first millimetre ...
constexpr double kAngleShare = 1.0 / 3.0;  // ... or third of height
constexpr double kSpacing = 4e-5;          // of the places that stand for points where the kink blurs them [m]
constexpr double kBent = 0.5;              // a kink that the stripe's windows are shortened at [rad]
constexpr double kFewest = 2.5;            // places in a regression

/// Regression over the face's first piece, u rising inward from the toe.
class FirstPiece
{
public:
  FirstPiece(double begin, const Line& line, double height) : begin_(begin), line_(line), rise_(kAngleShare * height) {}

  /// False beyond the piece's end.
  bool add(double d, double z)
  {
    const double step = d - reached_;
    length_ += n_ > 0.0 ? std::hypot(step, z - last_) : 0.0;
    last_ = z;
    if (!std::isfinite(z) || length_ > kAngleFace || line_.above(begin_ + d, z) > rise_)
      return false;
    n_ += 1.0, u_ += d, z_ += z, uu_ += d * d, uz_ += d * z;
    reached_ = d;
    return true;
  }

  double reached() const { return reached_; }
  double spread() const { return uu_ - u_ * u_ / n_; }
  bool told() const { return n_ > kFewest && spread() > 0.0; }
  double angle() const { return std::atan((uz_ - u_ * z_ / n_) / spread()); }

private:
  double begin_;
  Line line_;
  double rise_;
  double n_ = 0.0, u_ = 0.0, z_ = 0.0, uu_ = 0.0, uz_ = 0.0, length_ = 0.0, last_ = 0.0, reached_ = 0.0;
};

/// The first piece of a rippled face: the arc where the kink blurs it, from there on the section's own points.
FirstPiece seenPiece(const ToeAngleQuestion& asked, double begin, const Line& line, double height)
{
  const double inward = -sign(asked.side);
  FirstPiece piece(begin, line, height);
  bool inside = true;
  for (double d = 0.0; inside && d < asked.blur; d += kSpacing)
    inside = piece.add(d, asked.toe.face.heightAt(begin + d));
  const SectionProfile& profile = asked.profile;
  const std::size_t count = profile.size();
  for (std::size_t n = 0; inside && n < count; ++n)
  {
    const std::size_t i = inward > 0.0 ? n : count - 1 - n;
    const double d = inward * profile.q[i] - begin;
    if (d >= asked.blur)
      inside = piece.add(d, profile.z[i]);
  }
  return piece;
}

/// Of a toe told from evened out faces: where it is not certain, or a ripple's crest comes near to a third of the
/// height, nor is it which piece is the first.
Quantity seenAngle(const ToeAngleQuestion& asked, const Line& line)
{
  const double begin = -sign(asked.side) * asked.toe.q;
  const FirstPiece piece = seenPiece(asked, begin, line, asked.height);
  const double bias = faceBias(asked.toe.flank);
  const double rise = std::hypot(bias, std::sqrt(asked.toe.energy)) / kAngleShare;
  double other = 0.0;
  for (const double way : { -1.0, 1.0 })
  {
    const FirstPiece moved = seenPiece(asked, begin + way * asked.toe.sigma, line, asked.height);
    const FirstPiece cut = seenPiece(asked, begin, line, asked.height + way * rise);
    if (!piece.told() || !moved.told() || !cut.told())
      return Quantity();
    const double change = std::hypot(moved.angle() - piece.angle(), cut.angle() - piece.angle());
    other = std::max(other, change);
  }
  const double blur = bias / (0.5 * piece.reached());
  return Quantity{ piece.angle(), std::sqrt(asked.toe.energy / piece.spread() + square(other) + square(blur)) };
}
}  // namespace

Quantity toeAngle(const ToeAngleQuestion& asked)
{
  constexpr double kPi = 3.14159265358979323846;
  const ToeFit& toe = asked.toe;
  if (toe.bridged || !std::isfinite(asked.height))
    return Quantity();
  const double inward = -sign(asked.side);
  const Line line{ asked.parent.height, inward * asked.parent.slope };
  if (toe.evened)
  {
    const Quantity angle = seenAngle(asked, line);
    return Quantity{ kPi - (angle.value - std::atan(line.slope)), angle.sigma };
  }
  const double begin = inward * toe.q;
  FirstPiece piece(begin, line, asked.height);
  for (int i = 0; i <= kAngleSamples; ++i)
  {
    const double d = i * kAngleFace / kAngleSamples;
    if (!piece.add(d, toe.face.heightAt(begin + d)))
      break;
  }
  const double half = 0.5 * piece.reached();
  const Eigen::Vector2d middle(begin + half, toe.face.heightAt(begin + half));
  const double angle = piece.told() ? piece.angle() : toe.face.direction(middle);
  // what a bent kink's blur leaves is in the factor, a flat one's is wider than the piece
  const double blur = half > 0.0 ? (faceBias(toe.flank) - faceBias(kBent)) / half : 0.0;
  const double noise = kAngleSigmas * toe.face.sigmaDirection(middle, toe.energy);
  return Quantity{ kPi - (angle - std::atan(line.slope)), std::hypot(noise, blur) };
}
}  // namespace weld
}  // namespace weld_profiler
