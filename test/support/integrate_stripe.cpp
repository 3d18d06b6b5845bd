#include "support/integrate_stripe.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace test_support
{
namespace
{
constexpr double kChord = 0.25;  ///< columns a chord is long; it leaves the line by kChord^2 / 8 * curvature [px]
constexpr double kReach = 6.0;   ///< of the light, in sigmas
// Gauss-Legendre, three points a pixel each way.
const double kNodes[] = { -0.5 * 0.7745966692414834, 0.0, 0.5 * 0.7745966692414834 };
const double kWeights[] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };

struct Corner
{
  double u = 0.0, v = 0.0;
};

struct Range
{
  int first = 0, last = 0;
};

struct Nearest
{
  double distance = 1e9;  ///< signed: positive below the line
  double u = 0.0;
};

class Chords
{
public:
  Chords(const StripePicture& stripe, double beyond) : first_(-beyond)
  {
    const auto count = static_cast<int>(std::ceil((stripe.width + 2.0 * beyond) / kChord));
    for (int i = 0; i <= count; ++i)
    {
      const double u = first_ + kChord * i;
      corners_.push_back(Corner{ u, stripe.row(u) });
    }
  }

  Nearest nearest(double u, double v, double reach) const
  {
    Nearest best;
    for (int i = index(u - reach); i <= index(u + reach); ++i)
    {
      const Corner& a = corners_[static_cast<std::size_t>(i)];
      const Corner& b = corners_[static_cast<std::size_t>(i) + 1];
      const double du = b.u - a.u, dv = b.v - a.v;
      const double part = std::clamp(((u - a.u) * du + (v - a.v) * dv) / (du * du + dv * dv), 0.0, 1.0);
      const double away_u = u - a.u - part * du, away_v = v - a.v - part * dv;
      const double distance = std::hypot(away_u, away_v);
      if (distance < std::abs(best.distance))
        best = Nearest{ away_v < 0.0 ? -distance : distance, a.u + part * du };
    }
    return best;
  }

  /// Rows that may lie within reach of the line.
  Range rowsNear(double u, double reach) const
  {
    double least = 1e9, most = -1e9;
    for (int i = index(u - reach); i <= index(u + reach) + 1; ++i)
    {
      least = std::min(least, corners_[static_cast<std::size_t>(i)].v);
      most = std::max(most, corners_[static_cast<std::size_t>(i)].v);
    }
    return Range{ static_cast<int>(std::floor(least - reach)), static_cast<int>(std::ceil(most + reach)) };
  }

private:
  int index(double u) const
  {
    return std::clamp(static_cast<int>((u - first_) / kChord), 0, static_cast<int>(corners_.size()) - 2);
  }

  double first_;
  std::vector<Corner> corners_;
};

double lightAt(const StripePicture& stripe, const Nearest& nearest)
{
  const double sigma = stripe.sigma_at ? stripe.sigma_at(nearest.u) : stripe.sigma;
  const double square = nearest.distance * nearest.distance / (sigma * sigma);
  const double shape = stripe.profile ? stripe.profile(nearest.distance) : std::exp(-0.5 * square);
  return stripe.peak * shape * (stripe.gain ? stripe.gain(nearest.u) : 1.0);
}
}  // namespace

Picture renderIntegrated(const StripePicture& stripe)
{
  const double scale = stripe.bit_depth == 8 ? 1.0 : 257.0;
  Picture picture = blank(stripe.width, stripe.height, stripe.background * scale, stripe.bit_depth);
  double widest = stripe.sigma;
  for (int u = 0; stripe.sigma_at && u < stripe.width; ++u)
    widest = std::max(widest, stripe.sigma_at(u));
  const double reach = kReach * widest + 1.0;
  const Chords chords(stripe, 2.0 * reach);
  for (int u = 0; u < stripe.width; ++u)
  {
    const Range rows = chords.rowsNear(u, reach);
    for (int v = std::max(0, rows.first); v <= std::min(stripe.height - 1, rows.last); ++v)
    {
      double light = 0.0;
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          light += kWeights[i] * kWeights[j] * lightAt(stripe, chords.nearest(u + kNodes[i], v + kNodes[j], reach));
      picture.set(u, v, std::min(stripe.background + light, stripe.clip) * scale);
    }
  }
  return picture;
}
}  // namespace test_support
}  // namespace weld_profiler
