#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "can/port/port.hpp"
#include "daemon/watch/active_messages.hpp"
#include "daemon/watch/frame_tap.hpp"
#include "daemon/watch/unit_event.hpp"
#include "daemon/watch/write_watch.hpp"
#include "device/device.hpp"

namespace axisd {

/// Makes events of what happens in a unit: of its frames, of what it tells, and by comparing its states and
/// messages with those before. While nobody listens it neither hears nor compares anything.
class EventWatch final : private FrameListener {
 public:
  /// Both arguments outlive this.
  EventWatch(const device::Device& device, FrameTap& tap) noexcept : device_{device}, tap_{tap} {}
  ~EventWatch() override = default;
  EventWatch(const EventWatch&) = delete;
  EventWatch& operator=(const EventWatch&) = delete;

  /// @p listener is told what happens from now on; false if there are too many. Allocates.
  [[nodiscard]] bool add(EventListener& listener);
  void remove(EventListener& listener) noexcept;
  bool is_watched() const noexcept { return !listeners_.is_empty(); }

  /// Tells what has changed by @p now without a frame or time having been told to the unit.
  void look(canopen::TimePoint now) noexcept;

  // What the unit tells. The axis of a drive object is filled in.
  void tell(UnitEvent event) noexcept;
  void on_nmt_state(canopen::NmtState from, canopen::NmtState to, canopen::TimePoint now) noexcept;
  void on_bus_state(bus::ErrorState state, canopen::TimePoint now) noexcept;
  /// What is on or off, up or down, done or failed.
  void on_change(record::EventKind kind, bool active, canopen::TimePoint now) noexcept {
    tell({.time = now, .kind = kind, .active = active});
  }
  /// Whether @p text, of @p method for @p axis, is another one than at the last call; remembers it. Allocates.
  [[nodiscard]] bool is_other_command(std::string_view method, unsigned axis, std::string_view text);
  /// A client of the control socket has carried @p method out, a text that lasts, with the parameters @p text.
  void on_action(std::string_view method, std::string_view text, canopen::TimePoint now) noexcept {
    tell({.time = now,
          .kind = record::EventKind::Control,
          .origin = record::Origin::Control,
          .text = method,
          .note = record::Note{text}});
  }
  /// The parameter @p at has @p value, in its own unit, by somebody beside the bus.
  void on_parameter_written(const device::ParameterWindow::Target& at, double value, std::optional<double> before,
                            canopen::TimePoint now) noexcept;
  /// The same of an object of the dictionary.
  void on_object_written(std::uint16_t index, std::uint8_t sub_index, double value, std::optional<double> before,
                         canopen::TimePoint now) noexcept;

 private:
  /// The state of a drive object as it was told.
  struct Seen {
    std::uint8_t object = 0;
    std::optional<drive::State> state{};
  };
  /// What a client of the control socket has commanded last.
  struct Command {
    std::string_view method{};
    unsigned axis = 0;
    std::string text{};
  };
  /// What is there only while somebody listens.
  struct Past {
    WriteWatch writes;
    ActiveMessages messages;
    std::vector<Seen> objects{};
    std::vector<Command> commands{};
    bus::ErrorState bus = bus::ErrorState::Active;
  };

  void on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept override;
  void on_handled(canopen::TimePoint now) noexcept override { look(now); }

  std::optional<drive::State> state_of(std::uint8_t object) const noexcept;
  std::uint8_t axis_of(std::uint8_t object) const noexcept;
  void look_at_states(canopen::TimePoint now) noexcept;
  void look_at_messages(canopen::TimePoint now) noexcept;
  void on_sent(const canopen::Frame& frame, canopen::TimePoint time) noexcept;

  const device::Device& device_;
  FrameTap& tap_;
  Listeners<EventListener> listeners_;
  std::unique_ptr<Past> past_;
};

}  // namespace axisd
