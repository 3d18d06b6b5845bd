#include <algorithm>

#include "verdict_level.h"
#include "verdict_rows.h"

namespace weld_profiler
{
namespace
{
std::vector<Place> poresOf(const WeldToJudge& weld)
{
  std::vector<WeldSpot> spots = *weld.spots;
  if (weld.hollows != nullptr)
    spots.insert(spots.end(), weld.hollows->begin(), weld.hollows->end());
  std::vector<Place> pores;
  for (const WeldSpot& spot : spots)
  {
    if (spot.kind != WeldSpot::Kind::Pore || !spot.diameter.measured())
      continue;
    Place pore;
    pore.s = spot.s;
    pore.value = spot.diameter;
    pores.push_back(pore);
  }
  return pores;
}

/// Of those that were not seen the largest has no diameter, or at 2 sigma that of what would not have been; it lies
/// nowhere.
Place unseenPore(const WeldToJudge& weld)
{
  Place pore;
  pore.s = std::numeric_limits<double>::quiet_NaN();
  pore.value = { 0.0, 0.5 * hiddenPore(weld.unseen_pores) };
  return pore;
}
}  // namespace

double hiddenPore(const UnseenPores& unseen)
{
  constexpr double kVisible = 5e-4;  // docs/verdict.md: what visual testing resolves [m]
  return unseen.round > kVisible ? unseen.shallow : 0.0;
}

double VerdictRows::beadLength() const
{
  double length = 0.0;
  for (std::size_t i = 0; i < cells_.size(); ++i)
    length += sections_[i].hasBead() ? cells_[i].end - cells_[i].begin : 0.0;
  return length;
}

std::vector<VerdictRow> VerdictRows::poreRows(const WeldToJudge& weld) const
{
  const LimitEntry* entry = judge_.entry(Imperfection::SurfacePore, kind_);
  std::vector<VerdictRow> result;
  for (const QualityLevel level : kQualityLevels)
  {
    VerdictRow row = emptyRow(Imperfection::SurfacePore, level, entry);
    row.measured = beadLength();
    const bool limited = entry != nullptr && row.rule != LevelLimit::Rule::Permitted;
    const auto hold = [&](Place& pore)
    {
      Comparison comparison;
      if (limited)
        comparison = judge_.compare(*entry, level, pore.value, judge_.dimensions(WeldSection{}));
      else
        comparison.margin = { -pore.value.value, pore.value.sigma };
      pore.limit = comparison.limit;
      pore.margin = comparison.margin;
    };
    std::vector<Place> pores = poresOf(weld), unseen{ unseenPore(weld) };
    std::for_each(pores.begin(), pores.end(), hold);
    hold(unseen.front());
    const SizeDecision seen = decideSize(pores, pores), hidden = decideSize(unseen, unseen);
    const bool counts =
        pores.empty() || (limited && seen.decision == Decision::Pass && hidden.decision != Decision::Pass);
    const SizeDecision& size = counts ? hidden : seen;
    setPlace(size.place, limited, row);
    // none is looked for between toes that are not known
    if (limited)
      row.decision = size.decision == Decision::Pass && row.measured < needed_ ? Decision::Undecided : size.decision;
    else
      row.decision = entry == nullptr ? Decision::NotJudged : Decision::Pass;
    result.push_back(row);
  }
  return result;
}
}  // namespace weld_profiler
