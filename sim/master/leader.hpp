#pragma once

#include <cstdint>
#include <optional>

#include "sim/master/sdo_client.hpp"
#include "sim/master/station.hpp"
#include "sim/master/task.hpp"

namespace sim {

/// What a leader has to do with its unit.
struct LeaderPlan {
  std::uint8_t node_id = 1;
  unsigned axes = 1;
  bool is_cia402 = false;
  std::uint16_t heartbeat_ms = 100;  ///< 1017h of the unit, 0: the leader does not look at its heartbeat
  std::uint16_t inhibit_100us = 0;   ///< inhibit time of TPDO 2
  std::uint8_t transmission = 254;   ///< of TPDO 2
  bool by_rpdo = false;              ///< axis 1 is led by RPDO 2, else by SDO
  bool stores = false;               ///< it stores now and then
  bool restarts = false;             ///< it resets the node now and then, and takes it out of Operational
  std::uint64_t seed = 0;
};

/// A master that configures one unit, brings its axes into Operation enabled, moves them, and goes on with that
/// whatever happens to the unit or to the bus.
class Leader final : public Station {
 public:
  /// At @p medium under @p name. From @p calm on it does nothing but lead all axes to Operation enabled and keep
  /// them there.
  Leader(hub::Medium& medium, std::string_view name, const LeaderPlan& plan, canopen::TimePoint calm);

 private:
  void on_frame(const canopen::Frame& frame) noexcept override;

  Task<Done> lead();
  Task<bool> prepare();
  Task<Done> work();
  Task<bool> greet();
  Task<bool> answers();
  Task<bool> configure();
  Task<bool> configure_pdo();
  Task<bool> enable(unsigned axis);
  Task<bool> reset_fault(unsigned axis);
  Task<bool> bring_to(unsigned axis, std::uint16_t controlword, std::uint16_t state);
  Task<bool> command(unsigned axis, std::uint16_t controlword);
  Task<std::optional<std::uint16_t>> statusword(unsigned axis);
  Task<bool> stay();
  Task<bool> act();
  Task<bool> move();
  Task<bool> stop();
  Task<bool> store();
  Task<bool> read_around();
  Task<bool> restart();

  [[nodiscard]] bool is_lost() const noexcept;
  [[nodiscard]] bool is_calm() const noexcept { return now() >= calm_; }
  [[nodiscard]] static std::uint16_t object(std::uint16_t index, unsigned axis) noexcept;
  void command_node(std::uint8_t command) noexcept;

  LeaderPlan plan_;
  canopen::TimePoint calm_;
  SdoClient sdo_;
  Task<Done> task_;
  bool has_restarted_ = false;  ///< a boot-up message has come since greet()
  canopen::TimePoint heard_{};  ///< the last heartbeat
  bool consumes_heartbeat_ = false;
  std::int32_t target_ = 0;  ///< of axis 1, by RPDO
};

}  // namespace sim
