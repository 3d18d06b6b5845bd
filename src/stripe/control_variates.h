#pragma once

#include <vector>

namespace weld_profiler
{
/// What the scatter between neighbouring columns says of a stretch of 64 slots.
struct StretchScatter
{
  float feigned = 0.0F;     ///< share of what reflectance feigns that is there
  float flanks = 0.0F;      ///< share of the flanks in the centre
  float variance = 0.0F;    ///< of a mean over three columns, after both [px^2]
  float told = 0.0F;        ///< the same, as far as noise explains it
  float difference = 0.0F;  ///< of the difference between flanks and core, over three columns [px^2]
  float grain = 1.0F;       ///< variance of a mean over many columns, in what it were if neighbours were independent
  float lean = 0.0F;        ///< mean difference between flanks and core: the profile's own skewness [px]
};

/// Learns, stretch by stretch, how far two corrections make the centre's scatter along the stripe less (control
/// variates: least squares on what is rough in all three), and what scatter is left.
///
/// Rough is what is left of values six columns apart in their fifth difference: a weld's outline leaves next to nothing
/// of itself in it, and six columns are farther than speckle is alike. Steps and spatter are left out. An outline that
/// is rough itself (a narrow notch) is told from noise by what neighbouring columns and the light along the stripe say:
/// scatter beyond what both explain is not taken for noise.
class ControlVariates
{
public:
  static constexpr int kStretch = 64;  ///< slots

  /// Means over three columns, one a slot, and the columns they hold.
  struct Means
  {
    const float* centre;
    const float* feigned;     ///< offset that reflectance feigns
    const float* difference;  ///< flanks minus core
    const float* light;
    const float* columns;
    const float* single;  ///< the centre of one column
    const float* width;   ///< half width down the column [px]
    int count;
    float noise;  ///< 1-sigma of one pixel [grey levels]
  };
  void learn(const Means& means);

  const std::vector<StretchScatter>& stretches() const { return stretches_; }

private:
  struct Moments
  {
    double count = 0.0, ee = 0.0, ef = 0.0, ed = 0.0, ff = 0.0, fd = 0.0, dd = 0.0;  ///< of what is rough
    double lean = 0.0, fine = 0.0, uneven = 0.0, light = 0.0, width = 0.0;           ///< sums; see explained()
    void add(const Moments& other, double share);
  };
  double typicalMagnitude();
  Moments momentsOf(const Means& means, int stretch, double most) const;
  struct Explained
  {
    double most, likely;
  };
  static Explained explained(const Moments& sum);
  static StretchScatter solve(const Moments& sum);
  StretchScatter ofShortPieces(const Means& means) const;

  std::vector<StretchScatter> stretches_;
  std::vector<float> rough_, rough_feigned_, rough_difference_, rough_light_, fine_;
  std::vector<double> magnitudes_, sorted_;
  std::vector<Moments> moments_;
  int count_ = 0;
};
}  // namespace weld_profiler
