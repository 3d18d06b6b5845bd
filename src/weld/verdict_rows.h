#pragma once

#include <string>
#include <vector>

#include "verdict_length.h"
#include "verdict_places.h"
#include "weld_profiler/weld/verdict.h"

namespace weld_profiler
{
/// The sizes of one side along the weld.
struct SizeSeries
{
  std::string side;
  std::vector<Quantity> values;  ///< one a section
};

/// A row with what the table says, nothing measured yet.
VerdictRow emptyRow(Imperfection imperfection, QualityLevel level, const LimitEntry* entry);

/// Puts the place that decides into a row. @param with_limit  false = there is no limit: the size alone.
void setPlace(const Place& place, bool with_limit, VerdictRow& row);

/// The length over which a weld was seen, measured or not.
struct SeenLength
{
  double seen = 0.0;    ///< [m]
  bool longer = false;  ///< whether the weld may go on beyond
};

/// Diameter of the largest pore that counts and may be there unseen [m].
double hiddenPore(const UnseenPores& unseen);

/// Makes the rows of verdict.csv of one weld.
class VerdictRows
{
public:
  /// @param sections  of the weld from its first bead to its last, s rising. Must outlive the object, as judge must.
  /// @throws PreconditionError if s does not rise.
  VerdictRows(const WeldJudge& judge, WeldKind kind, const std::vector<WeldSection>& sections, const SeenLength& seen);

  /// B, C, D. @param decides  false = it was not asked for: measured, not judged.
  std::vector<VerdictRow> rows(Imperfection imperfection, bool decides) const;

  /// B, C, D of the pores: each is judged by itself. A hollow that may be one fails nothing, as its sigma is half its
  /// diameter, and passes only what one twice as wide would.
  std::vector<VerdictRow> poreRows(const WeldToJudge& weld) const;

  /// Of the weld, its gaps counted [m].
  double length() const { return length_; }

  /// On less a size cannot pass [m].
  double needed() const { return needed_; }

private:
  VerdictRow row(const std::vector<SizeSeries>& all, Imperfection imperfection, QualityLevel level) const;
  std::vector<Place> places(const SizeSeries& series, const LimitEntry* entry, QualityLevel level) const;
  double beadLength() const;
  double measuredLength(const std::vector<SizeSeries>& all) const;
  void judgeLength(const std::vector<SizeSeries>& all, const std::vector<Place>& medians, VerdictRow& row) const;

  const WeldJudge& judge_;
  WeldKind kind_;
  const std::vector<WeldSection>& sections_;
  std::vector<Stretch> cells_;
  double length_ = 0.0;
  double needed_ = 0.0;
  bool longer_ = false;
};
}  // namespace weld_profiler
