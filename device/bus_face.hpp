#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "device/bus/axis_defect.hpp"
#include "device/bus/axis_view.hpp"
#include "device/bus/bus_state.hpp"
#include "device/bus/indicator_leds.hpp"
#include "drive/explain/views/state_machine_view.hpp"
#include "drive/images/image_format.hpp"
#include "drive/object/drive_object.hpp"
#include "libcanopen/node/node.hpp"
#include "unit/face.hpp"

namespace device {

class ParameterWindow;

/// What the node tells the program around it. Called from within the functions of a BusFace.
class BusListener {
 public:
  virtual ~BusListener() = default;
  /// The identifiers to be received have changed: see BusFace::subscriptions().
  virtual void on_subscriptions_changed() noexcept = 0;
  /// Another station has sent @p identifier, which belongs to this node-ID.
  virtual void on_foreign_frame(std::uint32_t identifier) noexcept = 0;
  /// Life guarding was asked for and stays off (see device::Configuration::remote_frames).
  virtual void on_life_guarding_withheld() noexcept {}
  /// When the RPDO that wakes the resting unit at @p now has come from the bus: @p now, or earlier if the program
  /// was kept from running.
  virtual canopen::TimePoint frame_arrival(canopen::TimePoint now) noexcept { return now; }
  /// The node asks for the controller to be restarted from bus-off. True if the bus can be used now, false if it
  /// cannot yet: BusFace::on_bus_state() tells when.
  virtual bool on_bus_restart() noexcept { return true; }
  /// The NMT state has changed.
  virtual void on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept {
    static_cast<void>(from), static_cast<void>(to);
  }
  /// A save of the parameters is over; @p kept: with success.
  virtual void on_saved(bool kept) noexcept { static_cast<void>(kept); }
};

/// The drive unit as a CANopen node: what master and program see of it, whatever profile the node follows. It is
/// fed frames, and time that the runner has been told, and hands its frames to a sink. The time is that of the
/// runner.
class BusFace : public unit::Face {
 public:
  /// The unit is on, or the bus is back: sends the boot-up message and starts the communication afresh. If the
  /// node was Operational, that is leaving Operational.
  virtual void start() noexcept = 0;
  /// A frame from the bus; SDO requests are answered within the call, but saves: see Face::on_stored().
  virtual void on_frame(const canopen::Frame& frame) noexcept = 0;
  /// Handles what is due of what is missing or lost, before the cycles that are due, and of the node, after them.
  virtual void before_cycles() noexcept = 0;
  virtual void after_cycles() noexcept = 0;
  /// When they are wanted next.
  virtual canopen::TimePoint next_deadline() const noexcept = 0;

  /// The CAN controller is in error state @p state now. While the bus is off the unit sends nothing and hears
  /// nothing but SDO requests.
  virtual void on_bus_state(BusState state) noexcept = 0;
  /// The controller is to be restarted from bus-off; false if the bus is not off.
  virtual bool restart_bus() noexcept = 0;
  /// Frames that had arrived were lost before on_frame().
  virtual void on_frames_lost() noexcept = 0;
  /// From now on frames go to @p sink, which outlives this.
  virtual void send_to(canopen::FrameSink& sink) noexcept = 0;

  virtual const canopen::Node& node() const noexcept = 0;
  /// Before somebody beside the bus changes anything: the services of the node are told the time.
  virtual void tell_time() noexcept = 0;
  /// Somebody beside the bus writes the number, or the text, @p entry of dictionary(), as a master over SDO does;
  /// what it leads to is carried out at once. A save that this begins goes on.
  virtual canopen::Result<void> write_object(const canopen::Entry& entry, std::int64_t value) noexcept = 0;
  virtual canopen::Result<void> write_object(const canopen::Entry& entry,
                                             std::span<const std::uint8_t> text) noexcept = 0;

  virtual const canopen::Dictionary& dictionary() const noexcept = 0;
  virtual canopen::Dictionary& objects() noexcept = 0;
  /// What the parameters of the drive objects are on the SDO servers; nullptr where no master sees any.
  virtual const ParameterWindow* window() const noexcept { return nullptr; }
  /// What must be received (see canopen::Node::subscriptions()).
  virtual std::span<const canopen::Subscription> subscriptions() const noexcept = 0;
  /// What the LEDs of the CANopen interface show.
  virtual IndicatorLeds leds() const noexcept = 0;
  /// Frames of asynchronous RPDOs whose values were overwritten before a cycle has taken them.
  virtual std::uint64_t lost_telegrams() const noexcept { return 0; }

  /// Before the first start(): what was saved. An image that does not fit changes nothing.
  [[nodiscard]] virtual tl::expected<void, drive::image_format::Error> load(
      std::span<const std::byte> image) noexcept = 0;
  /// What can be saved has the values of a new unit, as with 1011h; the reason if it cannot be now.
  [[nodiscard]] virtual std::optional<drive::Refusal> restore() noexcept = 0;
  /// A save runs: nothing that is saved may be written.
  virtual bool is_saving() const noexcept = 0;
  /// Whether anything was saved, or loaded.
  virtual bool is_stored() const noexcept = 0;

  /// Why axis @p number (1..axes) does not turn, for people, between cycles: it allocates. @p commanding: what is
  /// said instead of an axis that something else than the bus commands.
  virtual std::vector<std::string> explain(std::size_t number, std::vector<std::string> commanding) const = 0;
  /// Axis @p number (1..axes) as it is now.
  virtual AxisView view(std::size_t number) const noexcept = 0;
  /// What the transitions of axis @p number (1..axes) need. For people: it allocates.
  virtual std::vector<drive::TransitionView> state_machine(std::size_t number) const = 0;
  /// Acknowledges the faults of @p axis (0..axes; 0: the control unit) for somebody beside the bus; true if no
  /// fault is left.
  virtual bool acknowledge(std::size_t axis) noexcept = 0;
  /// Axis @p number (1..axes) has @p defect from now on; false if the words of this face do not come to the axis
  /// at once, so that they can be changed on their way.
  virtual bool spoil(std::size_t number, const AxisDefect& defect) noexcept {
    return static_cast<void>(number), static_cast<void>(defect), false;
  }
};

}  // namespace device
