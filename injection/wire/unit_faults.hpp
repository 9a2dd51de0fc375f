#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "injection/wire/address_shift.hpp"
#include "injection/wire/delayed_frames.hpp"
#include "injection/wire/drive_faults.hpp"
#include "injection/wire/kinds.hpp"
#include "injection/wire/passing.hpp"
#include "injection/wire/unit_hooks.hpp"
#include "libcanopen/service/subscription.hpp"

namespace injection {

/// The faults of one unit on the wire. While any is loaded this stands between the unit and its bus: frames of the
/// bus come to on_frame(), those of the unit to send(). Without any it is not in their way, and costs nothing.
class UnitFaults final : public canopen::FrameSink, private CycleListener {
 public:
  static constexpr std::size_t kMost = 64;
  static constexpr std::size_t kMostSubscriptions = 2048;

  /// Faults of @p device, whose frames go on to @p bus; all arguments outlive this.
  UnitFaults(device::Device& device, canopen::FrameSink& bus, UnitHooks& hooks);
  ~UnitFaults() override = default;
  UnitFaults(const UnitFaults&) = delete;
  UnitFaults& operator=(const UnitFaults&) = delete;

  /// Loads @p fault, of unit_kinds(): its number. Refused if the unit has not what it names, or has kMost.
  tl::expected<std::uint32_t, std::string> add(const Fault& fault);
  /// Takes fault @p id back; false if there is none.
  bool remove(std::uint32_t id);
  /// Takes all back: how many there were.
  std::size_t remove_all();
  /// Those that are loaded, in their order; what is over stays until it is taken back.
  std::span<const Loaded> loaded() const noexcept { return loaded_; }
  bool is_empty() const noexcept { return loaded_.empty(); }

  /// A frame has come from the bus at @p now.
  void on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept;
  /// deadline() may have come; the unit is told the time after that.
  void on_time(canopen::TimePoint now) noexcept;
  canopen::TimePoint next_deadline() const noexcept;
  /// A frame, or the time, has been handled: what faults do to the unit itself.
  void settle(canopen::TimePoint now) noexcept;
  /// The unit sends @p frame.
  void send(const canopen::Frame& frame, canopen::Delivery delivery) override;

  /// The unit has been switched on, or its bus is back: what the controller is said to be is said again, and what
  /// waited for that happens.
  void on_start(canopen::TimePoint now) noexcept;

  /// What must be received for the unit and for events that are counted.
  std::span<const canopen::Subscription> subscriptions() noexcept;
  /// Whether a bus-off that is held keeps the controller from its restart.
  bool is_bus_off() const noexcept { return is_off_; }
  /// Whether a fault says what state the controller is in, whatever that says.
  bool leads_bus_state() const noexcept { return bus_state_ != device::BusState::Active; }

 private:
  void on_cycle() noexcept override;

  template <class Fits>
  void judge(const Occurrence& occurrence, const Fits& fits) noexcept;
  void pass(Passing& passing) noexcept;
  bool judge_unit(Loaded& loaded, const Occurrence& occurrence) noexcept;
  void overhear(const Occurrence& occurrence) noexcept;
  bool is_allowed(const Loaded& loaded) const noexcept;
  bool is_in_state(State state, const Loaded& loaded) const noexcept;
  void abort(const Passing& passing, Transfer& transfer) noexcept;
  void emit(const canopen::Frame& frame, canopen::Delivery delivery, canopen::Duration delay) noexcept;
  Transfer* transfer_of(const Role& role) noexcept;
  std::optional<AddressShift> shift() const noexcept;
  void carry_out(Loaded& loaded) noexcept;
  void begin(Loaded& loaded) noexcept;
  void end(Loaded& loaded) noexcept;
  bool has_begun(Doing doing) const noexcept;
  void reset(const Loaded& loaded) noexcept;
  void lead_identifiers() noexcept;
  void lead_bus_state() noexcept;
  void storm(Loaded& loaded) noexcept;
  std::optional<std::string> objection_to(const Fault& fault) const;
  void on_change() noexcept;

  device::Device& device_;
  canopen::FrameSink& bus_;
  UnitHooks& hooks_;
  std::vector<Loaded> loaded_;
  std::vector<Transfer> transfers_;  ///< one a server
  std::vector<canopen::Subscription> subscriptions_;
  DriveFaults drive_faults_{device_, loaded_, *this};
  DelayedFrames delayed_;
  std::optional<std::uint8_t> other_node_id_{};  ///< under which the unit is on the bus
  canopen::TimePoint now_{};
  canopen::TimePoint dark_until_{};                        ///< of a unit that is being switched off and on
  device::BusState bus_state_ = device::BusState::Active;  ///< as faults have it
  std::uint32_t last_id_ = 0;
  std::uint32_t dark_by_ = 0;  ///< the fault that has switched the unit off
  bool is_dark_ = false;
  bool is_gone_ = false;
  bool is_off_ = false;
  bool answers_guard_ = false;
  bool is_settling_ = false;
};

}  // namespace injection
