#pragma once

#include <memory>
#include <string>

#include "local_surface.h"
#include "path_frame.h"
#include "toe_track.h"
#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/weld_surface.h"

namespace weld_profiler
{
namespace weld
{
/// A weld's surfaces in coordinates along and across its path. Heights are z of the cloud's frame. Immutable.
class WeldShape
{
public:
  /// @throws PreconditionError when result and scan do not belong together.
  WeldShape(const Scan& scan, const WeldResult& result, const WeldSurfaceParams& params);

  /// Why there is nothing to be had; empty = all is well. Nothing else may be asked for when there is a reason.
  const std::string& reason() const { return reason_; }

  /// The parents rise beside the toes: what is wider than the face does not reach it.
  bool corner() const { return corner_; }

  const PathFrame& frame() const { return *frame_; }
  const ToeTrack& toes() const { return *toes_; }

  HeightSample bead(double s, double q) const { return bead_->at(s, q); }

  /// The target, told from its points between the toes: it may stand above the parents like a table.
  HeightSample targetBetween(double s, double q) const { return between_->at(s, q); }
  HeightSample targetBeside(double s, double q) const { return beside_->at(s, q); }

private:
  std::string findPath(const WeldResult& result);
  std::string findSurfaces(const Scan& scan, const WeldResult& result, const WeldSurfaceParams& params);

  std::string reason_;
  bool corner_ = false;
  std::unique_ptr<PathFrame> frame_;
  std::unique_ptr<ToeTrack> toes_;
  std::unique_ptr<LocalSurface> bead_, between_, beside_;
};
}  // namespace weld
}  // namespace weld_profiler
