#pragma once

#include "sim/master/station.hpp"
#include "sim/master/task.hpp"

namespace sim {

/// A station that sends what nobody should: frames of the services of one node with whatever data and length,
/// until the world is to be calm.
class Intruder final : public Station {
 public:
  /// To node @p node_id, until @p calm, at @p medium.
  Intruder(hub::Medium& medium, std::uint8_t node_id, canopen::TimePoint calm, Draw draw);

 private:
  Task<Done> intrude();
  [[nodiscard]] canopen::Frame next_frame() noexcept;

  std::uint8_t node_id_;
  canopen::TimePoint calm_;
  Task<Done> task_;
};

}  // namespace sim
