#pragma once

#include "sim/master/station.hpp"
#include "sim/master/task.hpp"

namespace sim {

/// A master that sends SYNC (80h) and nothing else.
class SyncProducer final : public Station {
 public:
  /// Every @p period, at @p medium.
  SyncProducer(hub::Medium& medium, canopen::Duration period, Draw draw)
      : Station{medium, "sync", draw}, period_{period}, task_{produce()} {
    task_.start();
  }

 private:
  Task<Done> produce() {
    constexpr std::uint32_t kSync = 0x80;
    while (true) {
      co_await sleep(period_);
      send({.id = kSync});
    }
  }

  canopen::Duration period_;
  Task<Done> task_;
};

}  // namespace sim
