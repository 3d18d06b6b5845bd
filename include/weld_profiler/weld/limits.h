#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "weld_profiler/weld/quantity.h"
#include "weld_profiler/weld/weld_section.h"

namespace weld_profiler
{
/// Quality levels of ISO 5817, from stringent to moderate.
enum class QualityLevel
{
  B,
  C,
  D
};
constexpr std::array<QualityLevel, 3> kQualityLevels = { { QualityLevel::B, QualityLevel::C, QualityLevel::D } };

/// `B`, `C`, `D`.
const char* name(QualityLevel level);

/// What a table of limits can limit: the imperfections of ISO 6520-1 that a section or a spot measures.
enum class Imperfection
{
  ExcessWeldMetal,  ///< no. 502: reinforcement of a butt weld or of a bead on a plate
  Convexity,        ///< no. 503: reinforcement of a fillet weld
  Undercut,         ///< nos. 5011 (continuous) and 5012 (intermittent), either side
  ToeAngle,         ///< no. 505, either side [rad]
  Misalignment,     ///< no. 507
  IncompleteFill,   ///< no. 511
  SurfacePore       ///< no. 2017: the diameter of one pore
};

const std::vector<Imperfection>& imperfections();

/// As in verdict.csv: `excess_weld_metal`, `convexity`, ...
const char* name(Imperfection imperfection);

/// Number in ISO 6520-1; 5011 for an undercut.
int isoNumber(Imperfection imperfection);

/// What the table says of one imperfection at one level.
struct LevelLimit
{
  enum class Rule
  {
    Limit,         ///< the size must not be beyond the limit
    Short,         ///< ... and the imperfection must be short
    NotPermitted,  ///< there must be none
    Permitted      ///< there is no limit
  };
  Rule rule = Rule::Permitted;
  double base = 0.0;    ///< limit = min(base + factor * dimension, cap) [m or rad]
  double factor = 0.0;  ///< [-]
  char of = 0;          ///< the dimension: b width, t plate thickness, s nominal thickness, a throat; 0 = none
  double cap = std::numeric_limits<double>::infinity();  ///< [m]
};

/// `max`, `short`, `not_permitted`, `permitted`.
const char* name(LevelLimit::Rule rule);

/// What limits depend on. The plate is as ordered: it has no sigma.
struct LimitDimensions
{
  Quantity b;               ///< width of the weld
  Quantity a;               ///< throat
  std::optional<double> t;  ///< plate thickness [m]
  std::optional<double> s;  ///< nominal thickness of a butt weld [m]
};

/// The limit and its sigma, which comes from b or a. Not measured if the dimension is missing. Only for Limit and
/// Short.
///
/// At the cap sigma is 0; within 2 sigma of the dimension below the cap it is still that of the slope: the larger one.
Quantity evaluate(const LevelLimit& limit, const LimitDimensions& dimensions);

/// One line of the table: an imperfection of some kinds of weld in a range of plate thickness, at all levels.
struct LimitEntry
{
  Imperfection imperfection = Imperfection::ExcessWeldMetal;
  std::vector<WeldKind> kinds;
  double above = 0.0;                                   ///< plates thicker than this [m]
  double from = 0.0;                                    ///< plates of at least this [m]
  double to = std::numeric_limits<double>::infinity();  ///< plates of at most this [m]
  bool any_thickness = true;                            ///< the entry names no thickness
  bool least = false;                                   ///< the limit is the least that is allowed (toe angle)
  std::array<LevelLimit, 3> levels{};                   ///< B, C, D
  std::string edition;                                  ///< of the standard
  bool verified = false;                                ///< source is `read`: taken from a copy that was read

  const LevelLimit& at(QualityLevel level) const { return levels[static_cast<std::size_t>(level)]; }

  /// Whether a formula of any level needs this dimension.
  bool needs(char dimension) const;
};

/// When an imperfection counts as short.
struct ShortRule
{
  double length = 0.025;  ///< in all within any `per` of weld [m]
  double per = 0.1;       ///< [m]
  double share = 0.25;    ///< of a weld shorter than `per`
  std::string edition;
  bool verified = false;
};

/// The limits after which welds are judged, read from a YAML table (docs/verdict.md describes it). Immutable.
class Limits
{
public:
  /// The table that the package ships, config/limits/iso5817.yaml, built in.
  static Limits shipped();

  /// @throws InputError if the file cannot be read, ConfigError naming file, key, value and remedy.
  static Limits load(const std::string& path);

  /// @param origin  stands for the file in messages.
  /// @throws ConfigError as load.
  static Limits parse(const std::string& text, const std::string& origin);

  /// The entry that judges, or none: no limit for this kind or thickness, or a formula needs what is not given.
  /// @param t  plate thickness [m]; none = only entries that name no thickness.
  /// @param s  nominal thickness [m]
  const LimitEntry* find(Imperfection imperfection, WeldKind kind, std::optional<double> t,
                         std::optional<double> s) const;

  /// There is a limit for this kind, and without the plate's thickness it cannot be told: find() then has none.
  /// @param s  nominal thickness [m]
  bool lacksThickness(Imperfection imperfection, WeldKind kind, std::optional<double> s) const;

  /// Least plate thickness that the table is for [m].
  double leastThickness() const { return least_thickness_; }
  const ShortRule& shortRule() const { return short_rule_; }
  const std::vector<LimitEntry>& entries() const { return entries_; }
  const std::string& standard() const { return standard_; }  ///< `ISO 5817`
  const std::string& origin() const { return origin_; }      ///< the file

private:
  friend class LimitsReader;
  Limits() = default;

  std::string origin_;
  std::string standard_;
  double least_thickness_ = 0.0;
  ShortRule short_rule_;
  std::vector<LimitEntry> entries_;
};
}  // namespace weld_profiler
