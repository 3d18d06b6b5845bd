#pragma once

#include <Eigen/Core>

#include "line.h"
#include "section_sampler.h"
#include "weld_profiler/weld/weld_params.h"

namespace weld_profiler
{
namespace weld
{
/// Side of the weld: the sign of q there.
enum class Side
{
  Left = -1,
  Right = 1
};

inline double sign(Side side)
{
  return side == Side::Left ? -1.0 : 1.0;
}

/// The parent line of one side, fitted to one section.
struct ParentFit
{
  Line line;                                             ///< invalid = too little of the parent is in view
  double middle = 0.0;                                   ///< q that the covariance refers to
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of the height at `middle` and the slope
  double inner = 0.0, outer = 0.0;                       ///< q of the piece's ends, nearer to the weld and farther
  double scatter = 0.0;                                  ///< of a point about the line [m]
  double correlated_cells = 1.0;                         ///< this many neighbours count as one
  int points = 0;

  bool valid() const { return line.valid(); }

  /// 1-sigma of the line's height at q; grows outside of the piece it was fitted to.
  double sigmaAt(double q) const;
};

/// Where a parent line is fitted.
struct ParentPiece
{
  Side side = Side::Left;
  double toe = 0.0;         ///< q of the toe, roughly [m]
  double begin = 0.0;       ///< from the toe outward, beyond where an undercut may be [m]
  double length = 1.0;      ///< of it at most, outward [m]
  bool correlation = true;  ///< tell how many neighbours count as one; else each counts
};

/// The piece's begin for a parent that is in view for `room` from the toe outward: an undercut's reach, less where
/// little is in view.
double parentBegin(double room, const WeldParams& params);

/// How far a parent goes on outward from a toe, up to the field's edge or another bead [m]; 0 = not in view.
/// @param from   side and toe; looked at from `begin` on.
/// @param guess  a line that the parent lies near.
double roomBeside(const SectionProfile& profile, const ParentPiece& from, const Line& guess, const WeldParams& params);

/// Fits a side's parent line robustly (Tukey's biweight, begun at a guess).
/// @param guess  a line that most of the parent lies near.
ParentFit fitParent(const SectionProfile& profile, const ParentPiece& piece, const Line& guess,
                    const WeldParams& params);
}  // namespace weld
}  // namespace weld_profiler
