#pragma once

#include <cstddef>
#include <vector>

namespace weld_profiler
{
/// The stripe column by column while it is being measured: arrays over slots, one slot a column of a piece.
///
/// Pieces follow one another with kGuard empty slots (weight 0) before, between and behind them, so that a step along
/// the stripe needs no test for the ends. Neighbouring slots of a piece are neighbouring columns. Rows [px], grey
/// levels of the image, widths down the column.
struct ColumnTrack
{
  static constexpr int kGuard = 48;

  struct Piece
  {
    int slot = 0;   ///< of its first column
    int cell = 0;   ///< its first column
    int count = 0;  ///< columns
  };

  std::vector<Piece> pieces;
  int columns = 0;                ///< of the image
  std::vector<float> v;           ///< reference line that offsets are counted from
  std::vector<float> sigma;       ///< 1-sigma half width
  std::vector<float> background;  ///< at v
  std::vector<float> gradient;    ///< of the background, per row
  std::vector<float> ambiguous;   ///< 1 where a second peak was nearly as good

  // what ColumnMoments measures
  float noise = 0.0F;         ///< 1-sigma of one pixel that it was measured with
  std::vector<float> light;   ///< height of the stripe's profile above the background, from the whole profile
  std::vector<float> core;    ///< offset of the centre from v by the weights of the matched filter
  std::vector<float> flanks;  ///< the same by weights that look at the flanks, where speckle is weak
  std::vector<float> spread;  ///< measured half width over `sigma`, squared
  std::vector<float> peak;    ///< brightest pixel within one half width, not background corrected
  std::vector<float> weight;  ///< 0 = nothing measured here

  /// Continues the reference line straight over the guards of a piece.
  void layOn(const Piece& piece);

  std::size_t slots() const { return v.size(); }

  void resize(std::size_t count)
  {
    for (std::vector<float>* field :
         { &v, &sigma, &background, &gradient, &ambiguous, &light, &core, &flanks, &spread, &peak, &weight })
      field->resize(count);
  }
};
}  // namespace weld_profiler
