#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "gray_column.h"
#include "method.h"

namespace weld_profiler
{
namespace
{
constexpr double kHalfPerSigma = 1.5;    ///< points either side, a 1-sigma half width: 7 for sigma 2
constexpr int kMostHalf = 3;             ///< 7 points
constexpr double kFaintest = 3.0;        ///< in the noise; the logarithm of less is nothing but noise
constexpr int kMoves = 2;                ///< pixels that the middle point may be off the brightest
constexpr double kBetweenPixels = 0.55;  ///< a vertex half-way between two pixels may swing between them
constexpr double kAstraySigmas = 0.4;    ///< from the centroid; a vertex farther off is that of a broad, rugged top

struct Vertex
{
  bool found = false;
  double v = 0.0;
  double read_sigma = 0.0;
};

/// The parabola's vertex by weighted least squares: the logarithm of a gray g with noise s has a noise of s / g, so
/// that its weight is g^2. Clipped and faint points take no part.
Vertex vertexOf(const GrayColumn& column, int middle, double noise)
{
  double brightest = 0.0;
  for (int i = 0; i < column.size(); ++i)
    brightest = std::max(brightest, column.gray[static_cast<std::size_t>(i)]);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const auto takesPart = [&](std::size_t i) { return column.clipped[i] == 0 && column.gray[i] > kFaintest * noise; };
  const auto basis = [&](int i)
  {
    const double y = column.first_row + i - middle;
    return Eigen::Vector3d(1.0, y, y * y);
  };
  int points = 0;
  for (int i = 0; i < column.size(); ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    if (!takesPart(at))
      continue;
    // In shares of the brightest: the same numbers for 8 and 16 bit.
    const double share = column.gray[at] / brightest;
    normal += share * share * basis(i) * basis(i).transpose();
    right += share * share * std::log(share) * basis(i);
    ++points;
  }
  Vertex vertex;
  const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
  const Eigen::Vector3d p = solver.solve(right);
  if (points < 3 || !p.allFinite() || !(p[2] < 0.0))
    return vertex;
  vertex.v = middle - 0.5 * p[1] / p[2];
  const Eigen::Vector3d change = solver.solve(Eigen::Vector3d(0.0, -0.5 / p[2], 0.5 * p[1] / (p[2] * p[2])));
  for (int i = 0; i < column.size(); ++i)
    if (const auto at = static_cast<std::size_t>(i); takesPart(at))
      vertex.read_sigma += std::pow(noise * column.gray[at] / (brightest * brightest) * basis(i).dot(change), 2.0);
  vertex.read_sigma = std::sqrt(vertex.read_sigma);
  vertex.found = std::isfinite(vertex.v) && std::isfinite(vertex.read_sigma) && vertex.read_sigma > 0.0;
  return vertex;
}

/// A parabola through the logarithm of the gray of 3 to 7 points around the brightest: a Gaussian's logarithm is one.
///
/// Source: R. B. Fisher, D. K. Naidu, "A Comparison of Algorithms for Subpixel Peak Detection", 1996 (Gaussian
/// approximation). As many points as the stripe's width gives within 1.5 sigma either side: 3 below a sigma of 1 px, 5
/// to 1.67 px, 7 above; where the top is clipped, the flanks beside it. They are weighed by the square of their gray,
/// so that noise in the tails, which the logarithm blows up, doesn't spoil the fit. Good for: narrow stripes, little
/// time. Poor for: wide stripes, whose flanks it does not look at, and a background that is not known well. A column
/// without a vertex within its stripe keeps the centroid.
class LogParabola : public MethodBase
{
public:
  using MethodBase::MethodBase;

protected:
  void refine(const ImageView& image, Workspace::Scratch& scratch) const override
  {
    for (Centre& centre : scratch.centres)
    {
      const Vertex vertex = settle(image, centre, scratch);
      if (!vertex.found || std::abs(vertex.v - centre.v) > kAstraySigmas * centre.sigma_column)
        continue;
      centre.background += centre.gradient * (vertex.v - centre.v);
      centre.v = vertex.v;
      centre.read_sigma = vertex.read_sigma;
    }
  }

private:
  /// Moves the points by a pixel until the vertex lies in the middle one.
  Vertex settle(const ImageView& image, const Centre& centre, Workspace::Scratch& scratch) const
  {
    const Levels levels = levelsOf(image, params());
    GrayColumn& column = scratch.column;
    const int half = std::clamp(static_cast<int>(std::lround(kHalfPerSigma * centre.sigma_column)), 1, kMostHalf);
    int middle = static_cast<int>(std::lround(centre.v));
    for (int move = 0; move <= kMoves; ++move)
    {
      int beside = 0;  // rows that the clipped ones push the points outward
      readColumn(image, levels, centre, middle, half, column);
      while (const auto clipped = std::count(column.clipped.begin(), column.clipped.end(), 1))
      {
        if (const int wider = static_cast<int>(clipped + 1) / 2; wider > beside)
          beside = wider;
        else
          break;
        readColumn(image, levels, centre, middle, half + beside, column);
      }
      const Vertex vertex = vertexOf(column, middle, scratch.finder.noise());
      if (!vertex.found || std::abs(vertex.v - middle) <= kBetweenPixels || beside > 0)
        return vertex;
      middle += vertex.v > middle ? 1 : -1;
    }
    return {};
  }
};
}  // namespace

std::unique_ptr<const StripeExtractor> makeLogParabola(const StripeParams& params)
{
  return std::make_unique<LogParabola>(params);
}
}  // namespace weld_profiler
