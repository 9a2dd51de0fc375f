#pragma once

#include "sim/master/station.hpp"
#include "sim/master/task.hpp"

namespace sim {

/// A master that guards one node by remote frames (CiA 301 7.2.8.2.2.1), though others consume its heartbeat.
class Guardian final : public Station {
 public:
  /// Node @p node_id every @p period, at @p medium.
  Guardian(hub::Medium& medium, std::uint8_t node_id, canopen::Duration period, Draw draw)
      : Station{medium, "guard", draw}, node_id_{node_id}, period_{period}, task_{guard()} {
    task_.start();
  }

 private:
  Task<Done> guard() {
    while (true) {
      co_await sleep(period_);
      send({.id = canopen::function_code::kErrorControl + node_id_, .length = 1, .remote = true});
    }
  }

  std::uint8_t node_id_;
  canopen::Duration period_;
  Task<Done> task_;
};

}  // namespace sim
