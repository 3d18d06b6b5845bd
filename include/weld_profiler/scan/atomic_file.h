#pragma once

// The class lives in core, because geometry (calibration files) and simulation (truth files) need it as well.
#include "weld_profiler/core/atomic_file.h"
