// SPDX-License-Identifier: Apache-2.0
#include "stop_request.h"

#include <csignal>

namespace auslan {
namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void request_stop(int signal) {
  requested = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_for_stop() {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

bool stop_requested() {
  return requested != 0;
}

tl::unexpected<Error> stopped() {
  return fail(ErrorCode::kUnwritable, "stopped before it was done; nothing unfinished was kept");
}

}  // namespace auslan
