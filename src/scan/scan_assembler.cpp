#include "weld_profiler/scan/scan_assembler.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
// Relative. A stage that steps by exactly one pitch must make a row at each step, whatever the last digit says.
constexpr double kSlack = 1e-6;
}  // namespace

ScanAssembler::ScanAssembler(const ScanParams& params, std::string frame_id)
  : params_(params), frame_id_(std::move(frame_id))
{
  params_.validate();
  scan_.frame_id = frame_id_;
}

void ScanAssembler::use(const ScanParams& params)
{
  params.validate();
  params_ = params;
}

ScanAssembler::Result ScanAssembler::add(const Profile& profile)
{
  if (!std::isfinite(profile.stage))
    throw PreconditionError("profile without a finite stage position, place it first");
  Result result;
  if (started_ && reversed(profile.stage))
  {
    started_ = false;
    if (!scan_.empty())
      result.ended = takeScan(ScanEnd::Reversal);
  }
  if (!fits(profile))
  {
    started_ = false;
    result.ended = takeScan(ScanEnd::Stopped);
  }
  if (started_ && !triggered(profile.stage))
    return result;

  append(profile);
  result.outcome = Outcome::Row;
  if (scan_.rows.size() >= static_cast<std::size_t>(params_.max_rows))
    result.ended = takeScan(ScanEnd::MaxRows);  // trigger and heading go on as if nothing had happened
  return result;
}

/// Follows the stage; true when it has come back by the hysteresis and reversals count.
bool ScanAssembler::reversed(double stage)
{
  lowest_stage_ = std::min(lowest_stage_, stage);
  highest_stage_ = std::max(highest_stage_, stage);
  const double hysteresis = params_.reversal_hysteresis * (1.0 - kSlack);
  const bool up = stage - lowest_stage_ >= hysteresis;
  const bool down = highest_stage_ - stage >= hysteresis;
  const int old_heading = heading_;
  if (heading_ != 1 && up)
    heading_ = 1;
  else if (heading_ != -1 && down)
    heading_ = -1;
  if (heading_ == old_heading)
    return false;
  lowest_stage_ = highest_stage_ = stage;
  return old_heading != 0 && params_.on_reversal == "split";
}

bool ScanAssembler::triggered(double stage) const
{
  if (params_.trigger == "time")
    return true;
  const bool forward_only = params_.on_reversal == "split" && heading_ != 0;
  const double moved = forward_only ? heading_ * (stage - last_row_stage_) : std::abs(stage - last_row_stage_);
  return params_.pitch > 0.0 ? moved >= params_.pitch * (1.0 - kSlack) : moved > params_.still_tolerance;
}

bool ScanAssembler::fits(const Profile& profile) const
{
  return profile.points.empty() || !width_known_ || profile.cells == scan_.cells;
}

void ScanAssembler::append(const Profile& profile)
{
  if (!started_)
    lowest_stage_ = highest_stage_ = profile.stage;
  started_ = true;
  last_row_stage_ = profile.stage;
  if (scan_.empty() || (!width_known_ && !profile.points.empty()))
  {
    scan_.cells = profile.cells;
    for (Profile& row : scan_.rows)  // all without points
      row.cells = profile.cells;
  }
  width_known_ = width_known_ || !profile.points.empty();
  scan_.rows.push_back(profile);
  scan_.rows.back().cells = scan_.cells;
}

Scan ScanAssembler::takeScan(ScanEnd end)
{
  Scan ended = std::move(scan_);
  ended.end = end;
  scan_ = Scan{};
  scan_.frame_id = frame_id_;
  width_known_ = false;
  return ended;
}

Scan ScanAssembler::close(ScanEnd end)
{
  started_ = false;
  heading_ = 0;
  return takeScan(end);
}
}  // namespace weld_profiler
