// SPDX-License-Identifier: Apache-2.0
#include "terminal/stop_on_signal.hpp"

#include <chrono>

namespace xgm::cli {

StopOnSignal::StopOnSignal() {
  interruptible_.emplace();
  watch_ = std::jthread([this](const std::stop_token& end) {
    constexpr std::chrono::milliseconds kPeriod{10};
    while (!end.stop_requested() && Interruptible::signal() == 0) {
      std::this_thread::sleep_for(kPeriod);
    }
    if (Interruptible::signal() == 0) return;
    interruptible_.reset();
    run_.request_stop();
  });
}

}  // namespace xgm::cli
