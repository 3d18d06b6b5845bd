#pragma once

#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "weld_profiler/core/balance.h"
#include "weld_profiler/core/scan.h"
#include "weld_profiler/scan/scan_assembler.h"
#include "weld_profiler/scan/scan_params.h"
#include "weld_profiler/stage/pose_source.h"

namespace weld_profiler
{
/// Profiles wait here, in order of arrival, until the pose source can place them; placed ones become rows of a scan.
/// At all times balance().frames_in == balance().accounted() + waiting().
/// The live nodelet and the offline command drive this same class. Not thread safe; the caller serialises.
class ScanBuilder
{
public:
  /// What happens on the way. Called from within addProfile, poll, finish, timeBackwards and restart; they must not
  /// call the builder back.
  struct Sinks
  {
    /// Each placed profile after the window's cut, whether it became a row or not. Before the on_scan it causes.
    std::function<void(const Profile&)> on_profile;
    std::function<void(Scan&&)> on_scan;  ///< each ended scan that has at least one row
  };

  /// @throws ConfigError as ScanParams::validate.
  ScanBuilder(const ScanParams& params, std::unique_ptr<PoseSource> poses, std::string frame_id, Sinks sinks);

  /// Takes a frame's points (none = no stripe) and places it as soon as it can be. Counts it in frames_in.
  /// Time running backwards: what waits is given up (`time_backwards`) and the open scan is closed. When more than
  /// max_waiting wait, the oldest is given up (`waiting_too_long`).
  void addProfile(SensorProfile profile);

  /// Places what can be placed; call after each new encoder sample or transform.
  void poll();

  /// The input ended or stop_scan: what waits is given up under the reason it waits for, the open scan is closed.
  void finish();

  /// Time ran backwards at the encoder: waiting profiles are given up under `time_backwards`, the open scan is closed.
  void timeBackwards();

  /// Begins from nothing: waiting profiles given up as `restarted`, open scan handed to on_scan, balance set to
  /// zero. Encoder samples stay: they are measured, not learnt.
  void restart();

  /// While not scanning, profiles are placed and handed to on_profile, become no row and are counted nowhere.
  void setScanning(bool scanning) { scanning_ = scanning; }
  bool scanning() const { return scanning_; }

  /// Other settings from the next profile on. @throws ConfigError; the old ones stay.
  void use(const ScanParams& params);

  void countDropped(const std::string& reason, std::uint64_t frames = 1);  ///< also counts them in frames_in
  const FrameBalance& balance() const { return balance_; }
  const Scan& openScan() const { return assembler_.open(); }
  std::size_t waiting() const { return waiting_.size(); }
  PoseSource& poses() { return *poses_; }

private:
  void place(const SensorProfile& profile, const SensorPose& pose);
  void hand(Scan&& scan);
  void giveUpFirst(const std::string& reason);
  void giveUpWaiting(const std::string& reason);
  void countUnplaced(const std::string& reason);

  std::unique_ptr<PoseSource> poses_;
  ScanParams params_;
  ScanAssembler assembler_;
  Sinks sinks_;
  std::deque<SensorProfile> waiting_;
  Stamp last_stamp_ = std::numeric_limits<Stamp>::min();
  std::optional<Stamp> last_placed_;
  FrameBalance balance_;
  bool scanning_ = true;
};
}  // namespace weld_profiler
