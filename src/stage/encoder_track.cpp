#include "weld_profiler/stage/encoder_track.h"

#include <algorithm>
#include <cmath>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
constexpr double kSpeedWindow = 0.05;  // [s]
}

void EncoderParams::validate() const
{
  requireRange("max_encoder_gap", max_encoder_gap, 1e-6, 10.0, "s");
  requireRange("max_samples", max_samples, 2, 10000000);
}

EncoderTrack::EncoderTrack(const EncoderParams& params) : params_(params)
{
  params_.validate();
}

bool EncoderTrack::add(Stamp stamp, double position)
{
  const bool late = !samples_.empty() && stamp < samples_.back().stamp;
  const bool backwards = late && samples_.back().stamp - stamp >= fromSeconds(kClockJump);
  if (late && !backwards)
    return true;  // its neighbours bracket as well without it
  if (backwards)
    samples_.clear();
  if (!samples_.empty() && stamp == samples_.back().stamp)
    samples_.back().position = position;
  else
    samples_.push_back(Sample{ stamp, position });
  if (samples_.size() > static_cast<std::size_t>(params_.max_samples))
    samples_.pop_front();
  return !backwards;
}

EncoderTrack::Answer EncoderTrack::at(Stamp stamp) const
{
  using Kind = PoseAnswer::Kind;
  if (samples_.empty())
    return Answer{ Kind::Wait, 0.0, unplaced::kNoEncoder };
  if (stamp < samples_.front().stamp)
    return Answer{ Kind::Never, 0.0, unplaced::kBeforeFirstSample };
  if (stamp > samples_.back().stamp)
    return Answer{ Kind::Wait, 0.0, unplaced::kAfterLastSample };

  const auto after = std::lower_bound(samples_.begin(), samples_.end(), stamp,
                                      [](const Sample& sample, Stamp value) { return sample.stamp < value; });
  const auto before = after->stamp == stamp ? after : std::prev(after);
  if (!std::isfinite(before->position) || !std::isfinite(after->position))
    return Answer{ Kind::Never, 0.0, unplaced::kEncoderNotFinite };
  const double gap = toSeconds(after->stamp - before->stamp);
  if (gap == 0.0)
    return Answer{ Kind::Placed, after->position, "" };
  if (after->stamp - before->stamp > fromSeconds(params_.max_encoder_gap))
    return Answer{ Kind::Never, 0.0, unplaced::kEncoderGap };
  const double share = toSeconds(stamp - before->stamp) / gap;
  return Answer{ Kind::Placed, before->position + share * (after->position - before->position), "" };
}

double EncoderTrack::speed() const
{
  const Sample* last = nullptr;
  const Sample* first = nullptr;
  for (auto sample = samples_.rbegin(); sample != samples_.rend(); ++sample)
  {
    if (!std::isfinite(sample->position))
      continue;
    if (last == nullptr)
    {
      last = &*sample;
      continue;
    }
    if (first != nullptr && toSeconds(last->stamp - sample->stamp) > kSpeedWindow)
      break;
    first = &*sample;
  }
  return first == nullptr ? 0.0 : (last->position - first->position) / toSeconds(last->stamp - first->stamp);
}
}  // namespace weld_profiler
