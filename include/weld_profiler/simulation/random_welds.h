#pragma once

#include <cstdint>

#include "weld_profiler/simulation/scene_params.h"

namespace weld_profiler
{
/// A plausible weld, different for each seed, that accuracy is judged on: preset realistic, 20 mm scanned at a pitch of
/// 0.1 to 0.2 mm, a region of 1440x400 pixels that the whole stripe lies in. Kinds take turns (seed modulo 3): butt,
/// fillet, bead on plate. Width 4 to 20 mm; reinforcement 0 to 4 mm with flanks of at most 60 deg (fillets: -0.08 to
/// 0.18 of the width, so concave ones too); undercut up to 0.6 mm deep and 0.8 to 2 mm wide on either side;
/// yaw up to 20 deg either way everywhere along the scan, half of the paths bent; ripples, spatter, a part that does
/// not lie level. Butt welds have a misalignment of up to 1 mm and 15 % of the width, and an angle of 1 to 2 deg where
/// it is less than 0.15 mm (else they might as well be beads on one plate). The weld goes on beyond the scan at both
/// ends. Same seed, same scene.
SceneParams randomWeldScene(std::uint64_t seed);
}  // namespace weld_profiler
