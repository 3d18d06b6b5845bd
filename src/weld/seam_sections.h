#pragma once

#include <cstdint>
#include <vector>

#include "along_weld.h"
#include "parent_plate.h"
#include "seam_guess.h"
#include "section_sampler.h"
#include "section_shape.h"

namespace weld_profiler
{
namespace weld
{
/// All sections along one weld: cut, parents and toes fitted to each, both evened out along the weld.
class SeamSections
{
public:
  SeamSections(const SectionSampler& sampler, const SeamGuess& guess, const WeldParams& params)
    : sampler_(sampler), guess_(guess), params_(params)
  {
  }

  /// @param places  s of each section, rising.
  /// A first look: nothing is masked, and toes that spatter moved are mapped where their neighbours are.
  void measureRoughly(const std::vector<double>& places);

  /// @param masked  points of the grid to leave out.
  void measure(const std::vector<double>& places, const std::vector<std::uint8_t>& masked);

  std::size_t size() const { return places_.size(); }
  const std::vector<double>& places() const { return places_; }
  const SectionProfile& profile(std::size_t k) const { return profiles_[k]; }
  const SectionShape& shape(std::size_t k) const { return shapes_[k]; }

  /// q of a toe, continued to where it was not measured; for maps. NaN where even that says nothing.
  double mappedToe(std::size_t k, Side side) const { return side == Side::Left ? mapped_left_[k] : mapped_right_[k]; }

private:
  void fit(const std::vector<double>& places, const std::vector<std::uint8_t>& masked);
  void fitParents(Side side);
  void demoteShort(Side side);
  /// Two places across the weld that tell a parent line: q of them.
  struct Lever
  {
    double near = 0.0, far = 0.0;
  };
  bool isInside(Side side, const Lever& lever, std::size_t k) const;
  void demoteOdd(Side side, const Lever& lever, const ParentPlate& plate);
  void smoothParents(Side side);
  void fitToes();
  void dropLone(Side side);
  AlongWeld smoothToes(Side side);
  void bridgeToes(Side side);
  void bridgeToe(Side side, std::size_t before, std::size_t k, std::size_t after);

  const SectionSampler& sampler_;
  const SeamGuess& guess_;
  const WeldParams& params_;
  std::vector<double> places_;
  std::vector<SectionProfile> profiles_;
  std::vector<SectionShape> shapes_;
  std::vector<ParentFit> short_parents_;  ///< of the side in work: in view, but not to be relied on
  std::vector<double> mapped_left_, mapped_right_;
};
}  // namespace weld
}  // namespace weld_profiler
