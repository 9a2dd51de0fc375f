#include "daemon/instance/bus_reports.hpp"

#include <chrono>
#include <utility>

#include "motor/data/machine_data.hpp"
#include "service/clock.hpp"

namespace axisd {
namespace {

constexpr canopen::Duration kRepeatedLogPeriod = std::chrono::seconds{10};

}  // namespace

void BusReports::on_open(const bus::Port& port) const {
  if (const auto buffer = port.receive_buffer(); buffer && buffer->bytes < buffer->wanted) {
    log_.warning("{}: receive buffer of {} bytes instead of {}: raise net.core.rmem_max", bus_name(),
                 buffer->bytes, buffer->wanted);
  } else if (buffer) {
    log_.info("{}: receive buffer of {} bytes", bus_name(), buffer->bytes);
  }
  if (!port.carries_remote_frames())
    log_.notice("{} carries no remote frames: no node guarding, no life guarding", bus_name());
}

void BusReports::on_foreign_frame(std::uint32_t identifier, int node_id) noexcept {
  ++foreign_frames_;
  const canopen::TimePoint now = read_clock();
  if (foreign_frames_ != 1 && now - foreign_logged_ < kRepeatedLogPeriod) return;
  foreign_logged_ = now;
  log_.warning("{}: identifier {}h came from another station: duplicate node-ID {}?", bus_name(),
               cob_id_field(identifier), node_id);
}

void BusReports::on_life_guarding_withheld() noexcept {
  if (std::exchange(withheld_logged_, true)) return;
  log_.warning("{}: life guarding (100Ch, 100Dh) is refused: the bus carries no remote frames; told once",
               bus_name());
}

void BusReports::on_restart(bus::Restart outcome) const noexcept {
  if (outcome == bus::Restart::Refused) {
    log_.warning("{}: the controller cannot be restarted without CAP_NET_ADMIN: waiting for its restart-ms",
                 bus_name());
  } else {
    log_.notice("{}: restart from bus-off", bus_name());
  }
}

void BusReports::look_at(const BusTurn& bus) noexcept {
  if (!full_logged_ && bus.queue().waiting() != 0) {
    full_logged_ = true;
    log_.notice("{}: the transmit queue of the interface is full, frames wait; told once (see the status)",
                bus_name());
  }
  messages_.look([this](std::uint8_t object, const ActiveMessages::Message& message, bool active) {
    log_message(object, message, active);
  });
  if (device_.skipped_cycles() != skipped_seen_) log_skipped_cycles();
  if (device_.held_back_axes() != held_back_seen_) log_held_back(device_.held_back_axes());
}

void BusReports::log_message(std::uint8_t object, const ActiveMessages::Message& message, bool active) const {
  const LogField axis = axis_of(object);
  const std::string place = axis.text == "0"        ? "control unit"
                            : axis.text == "infeed" ? axis.text
                                                    : fmt::format("axis {}", axis.text);
  const LogField code = fault_field(message_code(message.row->number, message.kind));
  if (!active) return log_.info("{}: {} is gone", place, code, axis);
  if (message.kind == drive::Kind::Fault)
    return log_.warning("{}: {} {}, value {}", place, code, message.row->name, message.value, axis);
  log_.notice("{}: {} {}, value {}", place, code, message.row->name, message.value, axis);
}

/// As the control socket names drive objects: 0 is the control unit.
LogField BusReports::axis_of(std::uint8_t object) const {
  const drive::DriveUnit& unit = device_.unit();
  if (unit.infeed() != nullptr && unit.infeed()->number() == object) return {"AXIS", "infeed"};
  return axis_field(object < unit.first_axis() ? 0 : object - unit.first_axis() + 1U);
}

void BusReports::log_skipped_cycles() noexcept {
  const canopen::TimePoint now = read_clock();
  if (skipped_seen_ != 0 && now - skipped_logged_ < kRepeatedLogPeriod) return;
  log_.warning("{} cycles of {} ms were skipped: the daemon was kept from running",
               device_.skipped_cycles() - skipped_seen_,
               std::chrono::duration<double, std::milli>{device_.cycle()}.count());
  skipped_seen_ = device_.skipped_cycles();
  skipped_logged_ = now;
}

void BusReports::log_held_back(std::uint32_t axes) noexcept {
  const std::uint32_t seen = std::exchange(held_back_seen_, axes);
  for (std::size_t axis = 1; axis <= configuration_.axes.size(); ++axis) {
    const std::uint32_t bit = 1U << (axis - 1);
    if ((axes & bit & ~seen) == 0) continue;
    log_.warning("axis {}: its load drives the shaft to {:.0f} rpm, where the rotor would burst: held there",
                 axis_field(axis), motor::bursting_speed(configuration_.axes[axis - 1].machine) / motor::kRpm);
  }
}

}  // namespace axisd
