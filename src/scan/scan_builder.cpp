#include "weld_profiler/scan/scan_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/stage/unplaced.h"

namespace weld_profiler
{
namespace
{
constexpr Stamp kNoStamp = std::numeric_limits<Stamp>::min();

bool inWindow(const CloudPoint& p, const ScanParams& w)
{
  return p.x >= w.min_x && p.x <= w.max_x && p.y >= w.min_y && p.y <= w.max_y && p.z >= w.min_z && p.z <= w.max_z;
}

Profile placed(const SensorProfile& profile, const SensorPose& pose, const ScanParams& window)
{
  const Eigen::Matrix3d rotation = pose.cloud_T_camera.linear();
  const Eigen::Vector3d translation = pose.cloud_T_camera.translation();
  const Eigen::RowVector3f up = rotation.row(2).cast<float>();
  Profile result{ profile.stamp, profile.frame, pose.stage, profile.cells, {} };
  result.points.reserve(profile.points.size());
  for (const SensorPoint& point : profile.points)
  {
    const Eigen::Vector3f position = (rotation * point.position + translation).cast<float>();
    const CloudPoint cloud_point{
      position.x(), position.y(), position.z(), point.intensity, std::abs(up.dot(point.spread)), point.cell, point.flags
    };
    if (inWindow(cloud_point, window))
      result.points.push_back(cloud_point);
  }
  return result;
}
}  // namespace

ScanBuilder::ScanBuilder(const ScanParams& params, std::unique_ptr<PoseSource> poses, std::string frame_id, Sinks sinks)
  : poses_(std::move(poses)), params_(params), assembler_(params, std::move(frame_id)), sinks_(std::move(sinks))
{
  if (!poses_)
    throw PreconditionError("scan builder without a pose source, give one");
}

void ScanBuilder::addProfile(SensorProfile profile)
{
  ++balance_.frames_in;
  if (last_stamp_ != kNoStamp && last_stamp_ - profile.stamp >= fromSeconds(kClockJump))
  {
    // The images came back before the encoder did: its samples are of the time before, and would place by chance.
    if (last_placed_ && poses_->at(*last_placed_).kind == PoseAnswer::Kind::Placed)
      poses_->reset();
    timeBackwards();
  }
  last_stamp_ = last_stamp_ == kNoStamp ? profile.stamp : std::max(last_stamp_, profile.stamp);
  waiting_.push_back(std::move(profile));
  poll();
  while (waiting_.size() > static_cast<std::size_t>(params_.max_waiting))
    giveUpFirst(unplaced::kWaitingTooLong);
}

void ScanBuilder::poll()
{
  while (!waiting_.empty())
  {
    const PoseAnswer answer = poses_->at(waiting_.front().stamp);
    if (answer.kind == PoseAnswer::Kind::Wait)
      return;
    if (answer.kind == PoseAnswer::Kind::Never)
    {
      giveUpFirst(answer.reason);
      continue;
    }
    const SensorProfile profile = std::move(waiting_.front());
    waiting_.pop_front();
    last_placed_ = profile.stamp;
    place(profile, answer.pose);
  }
}

void ScanBuilder::place(const SensorProfile& profile, const SensorPose& pose)
{
  if (!pose.cloud_T_camera.matrix().allFinite() || !std::isfinite(pose.stage))
  {
    countUnplaced(unplaced::kPoseNotFinite);
    return;
  }
  const Profile row = placed(profile, pose, params_);
  if (!scanning_)
  {
    --balance_.frames_in;
    if (sinks_.on_profile)
      sinks_.on_profile(row);
    return;
  }
  ScanAssembler::Result result = assembler_.add(row);
  // counted before anybody is told, so that the balance holds inside the sinks as well
  if (result.outcome == ScanAssembler::Outcome::Skipped)
    ++balance_.skipped;
  else
    ++(profile.points.empty() ? balance_.no_stripe : balance_.rows);
  if (sinks_.on_profile)
    sinks_.on_profile(row);
  if (result.ended)
    hand(std::move(*result.ended));
}

void ScanBuilder::hand(Scan&& scan)
{
  if (!scan.empty() && sinks_.on_scan)
    sinks_.on_scan(std::move(scan));
}

void ScanBuilder::finish()
{
  poll();
  while (!waiting_.empty())
  {
    const PoseAnswer answer = poses_->at(waiting_.front().stamp);
    if (answer.kind == PoseAnswer::Kind::Placed)
      poll();
    else
      giveUpFirst(answer.reason);
  }
  hand(assembler_.close(ScanEnd::Stopped));
}

void ScanBuilder::timeBackwards()
{
  giveUpWaiting(unplaced::kTimeBackwards);
  last_stamp_ = kNoStamp;
  last_placed_.reset();
  hand(assembler_.close(ScanEnd::Stopped));
}

void ScanBuilder::restart()
{
  giveUpWaiting(unplaced::kRestarted);
  hand(assembler_.close(ScanEnd::Stopped));
  poses_->beginScan();
  last_stamp_ = kNoStamp;
  last_placed_.reset();
  balance_ = FrameBalance{};
}

void ScanBuilder::use(const ScanParams& params)
{
  assembler_.use(params);
  params_ = params;
}

void ScanBuilder::countDropped(const std::string& reason, std::uint64_t frames)
{
  if (frames == 0 || !scanning_)
    return;
  balance_.frames_in += frames;
  balance_.dropped[reason] += frames;
}

void ScanBuilder::giveUpFirst(const std::string& reason)
{
  waiting_.pop_front();
  countUnplaced(reason);
}

void ScanBuilder::countUnplaced(const std::string& reason)
{
  if (scanning_)
    ++balance_.unplaced[reason];
  else
    --balance_.frames_in;
}

void ScanBuilder::giveUpWaiting(const std::string& reason)
{
  while (!waiting_.empty())
    giveUpFirst(reason);
}
}  // namespace weld_profiler
