#pragma once

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "weld_profiler/weld/limits.h"
#include "weld_profiler/weld/verdict_params.h"
#include "weld_profiler/weld/weld_section.h"
#include "weld_profiler/weld/weld_spot.h"

namespace weld_profiler
{
enum class Decision
{
  NotMeasured,
  NotJudged,  ///< measured, but there is no limit, or it was not asked for
  Pass,
  Fail,
  Undecided  ///< the limit lies within 2 sigma; of several sizes: one of them, or one was not measured
};

/// As in verdict.csv: empty, `not_judged`, `pass`, `fail`, `undecided`.
const char* name(Decision decision);

/// A size against the limit of one level.
struct Comparison
{
  Quantity limit;   ///< its sigma comes from the dimension that it depends on; not measured where there is none
  Quantity margin;  ///< > 0 = within the limit
  Decision decision = Decision::NotJudged;
};

/// One imperfection of one section, or one side of it.
struct Judgement
{
  Imperfection imperfection = Imperfection::ExcessWeldMetal;
  std::string side;  ///< `left`, `right` or empty
  Quantity value;
  std::array<Comparison, 3> levels;  ///< B, C, D
  bool decides = false;              ///< takes part in the section's verdict
  bool verified = false;             ///< the limit was taken from a copy of the standard that was read

  const Comparison& at(QualityLevel level) const { return levels[static_cast<std::size_t>(level)]; }
};

/// The verdict on one section, without the rule for short imperfections.
struct SectionVerdict
{
  std::string verdict;                 ///< as in weld.csv; empty = not judged, or nothing of a bead was measured
  std::vector<std::string> waits_for;  ///< what was not measured and leaves it undecided: `undercut left`, ...
  bool unverified = false;             ///< rests on a limit that was not read
  std::array<Decision, 3> levels{};    ///< whether B, C, D are met
  std::array<bool, 3> unverified_levels{};
  std::vector<Judgement> judgements;
};

/// A line of verdict.csv: one imperfection of the whole weld at one level.
struct VerdictRow
{
  Imperfection imperfection = Imperfection::ExcessWeldMetal;
  QualityLevel level = QualityLevel::B;
  Quantity value;   ///< at the deciding place: a median over min_length [m; toe angle: rad]
  Quantity limit;   ///< there; not measured = there is none
  Quantity margin;  ///< > 0 = within the limit
  double length = std::numeric_limits<double>::quiet_NaN();  ///< of weld beyond the limit; Short: see docs [m]
  Decision decision = Decision::NotMeasured;
  LevelLimit::Rule rule = LevelLimit::Rule::Permitted;
  std::string side;                                     ///< of the deciding place: `left`, `right` or empty
  double s = std::numeric_limits<double>::quiet_NaN();  ///< the deciding place along the path [m]
  double measured = 0.0;                                ///< length of weld on which it was measured [m]
  std::string edition;                                  ///< of the limit; empty = no limit
  bool verified = false;
};

/// Sections that are `undecided` by what was not measured there. Those without a verdict do not wait.
struct WaitingSections
{
  int sections = 0;                     ///< that wait
  int all = 0;                          ///< of the weld
  std::map<std::string, int> for_what;  ///< how many wait for each, as in SectionVerdict::waits_for

  /// `16 of 200 sections wait for what was not measured there: undercut left 9, undercut right 8`, or empty.
  std::string text() const;
};

/// The verdict on the whole weld.
struct WeldVerdict
{
  std::string verdict;                       ///< B, C, D (best level met), fail, undecided; empty = not judged
  std::vector<std::string> waits_for;        ///< imperfections that were measured nowhere and leave it undecided
  std::vector<std::string> lacks_thickness;  ///< imperfections whose limits need the plate's thickness: not judged
  WaitingSections waiting;
  bool unverified = false;           ///< rests on a limit that was not read
  std::array<Decision, 3> levels{};  ///< whether B, C, D are met
  std::array<bool, 3> unverified_levels{};
  Decision asked = Decision::NotJudged;  ///< whether the level asked for is met; by a part of the limits none is
  double length = 0.0;                   ///< of the weld [m]
  std::vector<VerdictRow> rows;          ///< imperfection by imperfection, B, C, D
  std::vector<std::string> notes;        ///< what a reader must know: not judged and why, unverified, ...

  /// The verdict as everything shows it: `C`, `fail`, `not judged`, `not fully judged, C by what was judged`.
  std::string headline() const;

  /// `no plate thickness given, not judged: undercut, misalignment`, or empty.
  std::string lacking() const;

  /// In one line, with what it lacks and that it rests on limits that were not read.
  std::string text() const;
};

/// What is known of a weld when it is judged as a whole.
struct WeldToJudge
{
  WeldKind kind = WeldKind::None;
  const std::vector<WeldSection>* sections = nullptr;  ///< along the path, s rising; holes may be missing
  const std::vector<WeldSpot>* spots = nullptr;        ///< null = pores were not looked for
  const std::vector<WeldSpot>* hollows = nullptr;      ///< that may be pores; null = there are none
  UnseenPores unseen_pores = {};                       ///< that would not be among the spots
  bool runs_out = false;                               ///< of what was seen: the weld may be longer
};

/// Judges welds after a table of limits. Immutable: one object may serve several threads. docs/verdict.md has the
/// rules.
class WeldJudge
{
public:
  /// @throws ConfigError for bad parameters or a bad table, InputError for a table that cannot be read.
  explicit WeldJudge(const VerdictParams& params);
  WeldJudge(const VerdictParams& params, Limits limits);

  SectionVerdict judge(WeldKind kind, const WeldSection& section) const;

  /// @throws PreconditionError if s does not rise from section to section.
  WeldVerdict judge(const WeldToJudge& weld) const;

  const VerdictParams& params() const { return params_; }
  const Limits& limits() const { return limits_; }

  /// The entry that judges an imperfection here, or none.
  const LimitEntry* entry(Imperfection imperfection, WeldKind kind) const;

  /// A size against the limit of one level, there being one.
  Comparison compare(const LimitEntry& entry, QualityLevel level, const Quantity& value,
                     const LimitDimensions& dimensions) const;

  /// What the limits of a section depend on.
  LimitDimensions dimensions(const WeldSection& section) const;

private:
  VerdictParams params_;
  Limits limits_;
};
}  // namespace weld_profiler
