#pragma once

#include <array>
#include <vector>

#include "column_track.h"
#include "control_variates.h"
#include "width_growth.h"

namespace weld_profiler
{
/// Joins the columns' centres along the stripe: what one column can not tell, its neighbours do.
class AlongStripe
{
public:
  /// Evens out reference line and half width along the stripe, from a first measurement of the columns.
  void settle(ColumnTrack& track);

  /// The centres from a second measurement. Of each column:
  ///
  /// 1. The offset that reflectance feigns on an oblique stripe is taken off, and core and flanks are joined, each as
  /// far
  ///    as the scatter along the stripe becomes less by it (ControlVariates), with what is not significant left alone:
  ///    with constant reflectance and no speckle nothing is changed.
  /// 2. The centre is the mean over 27 columns along the stripe, drawn to that over 9 and on to that over 3 as far as
  ///    they differ by more than noise does (their mean square difference around the column against what noise makes
  ///    it; positive-part James-Stein), each less what the line's curvature adds to it where it is curved beyond doubt.
  /// 3. Its sigma follows from the scatter that is left between neighbours and from those differences, so that it holds
  ///    for speckle, outlines and what no model knows.
  /// @param max_aperture  most columns that a centre may be measured over.
  void join(const ColumnTrack& track, int max_aperture);

  /// Moves the reference line to the centres where they lie so far off it that a column's answer is no longer linear.
  /// @return whether it was necessary.
  bool moveReference(ColumnTrack& track) const;

  // one a slot
  const std::vector<float>& row() const { return row_; }               ///< of the centre [px]
  const std::vector<float>& slope() const { return arrays_[Slope9]; }  ///< of the line, rows a column
  const std::vector<float>& sigma() const { return sigma_; }           ///< of the row [px]
  const std::vector<float>& aperture() const { return aperture_; }  ///< columns whose pixels take part; 0 = no centre

private:
  enum Array
  {
    Feigned,     // offset that reflectance feigns, a column
    Difference,  // flanks minus core, a column
    Offset,      // row of the centre, a column
    Sum3,
    Sum9,
    Sum27,
    Sum81,  // columns held
    Lever3,
    Lever9,
    Lever27,  // their distances
    Mean3,
    Mean9,
    Mean27,  // rows
    Faded,   // offset that light feigns which fades out beside a break, taken off whole
    Unsure,  // what a change of the curvature beside a break may make of a centre
    Feigned3,
    Difference3,  // means over three columns
    Bend,         // second derivative of the line
    Square9,
    Square27,  // squared differences between the means
    Seen9,
    Seen27,  // their sums around a column
    Slope9,  // mean slopes
    Slope27,
    SpareA,
    SpareB,
    SpareC,
    Arrays
  };
  float* at(Array array) { return arrays_[array].data(); }
  void resize(std::size_t slots);
  void sum(Array values, int lag, Array to);
  void countColumns(const ColumnTrack& track);
  void prepareColumns(const ColumnTrack& track);
  void findBreaks(const ColumnTrack& track);
  void prepareBreaks(const ColumnTrack& track);
  static bool atBorder(const ColumnTrack& track, int slot);
  void turnAtBreak(const ColumnTrack& track, int slot);
  void takeFading(const ColumnTrack& track, int slot);
  void meanSlopes();
  void meanAlong();
  void compareMeans(const ColumnTrack& track);
  void bendBreaks(const ColumnTrack& track);
  void bendAtBreak(const ColumnTrack& track, int slot);
  void tellBreaks(const ColumnTrack& track);
  void tellLost(const ColumnTrack& track, int slot);
  void tellFaded(int slot);
  void choose(const ColumnTrack& track, int max_aperture);

  int slots_ = 0;
  std::array<std::vector<float>, Arrays> arrays_;
  ControlVariates variates_;
  WidthGrowth growth_;
  std::vector<int> beside_breaks_;  ///< slots
  std::vector<float> slope_, row_, sigma_, aperture_;
};
}  // namespace weld_profiler
