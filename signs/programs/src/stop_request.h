// SPDX-License-Identifier: Apache-2.0
// Ctrl-C and termination as a request that long work notices, so that unfinished files are removed.
#pragma once

#include "kinematics/result.h"

namespace auslan {

/// From now on SIGINT and SIGTERM set the request instead of ending the program; a second one ends it.
void watch_for_stop();
bool stop_requested();
/// What work that was stopped returns.
tl::unexpected<Error> stopped();

}  // namespace auslan
