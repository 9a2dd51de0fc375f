#include "daemon/daemon.hpp"

#include <array>
#include <chrono>

#include <sys/epoll.h>
#include <systemd/sd-daemon.h>

#include "daemon/clock.hpp"
#include "daemon/control_methods.hpp"

namespace axisd {
namespace {

constexpr canopen::Duration kRepeatedLogPeriod = std::chrono::seconds{10};

std::vector<device::ParameterPreset> presets_of(const std::vector<ParameterValue>& parameters) {
  std::vector<device::ParameterPreset> presets;
  presets.reserve(parameters.size());
  for (const ParameterValue& parameter : parameters)
    presets.push_back({parameter.number, parameter.value, parameter.index});
  return presets;
}

device::AxisSetup setup_of(const AxisConfiguration& axis) {
  return {.drive = {.machine = axis.machine,
                    .load = axis.load,
                    .kind = axis.kind,
                    .inverter = axis.inverter,
                    .deviation = axis.deviation,
                    .setpoint_channel = axis.setpoint_channel},
          .presets = presets_of(axis.parameters)};
}

/// What is saved in @p folder is read where the address switch stands at 0.
device::Configuration device_configuration(const Configuration& configuration, const bus::Port& port,
                                           const std::filesystem::path& folder, const Log& log) {
  device::Configuration result{.node_id = static_cast<std::uint8_t>(configuration.node_id),
                               .address_switch_off = configuration.node_id == kAddressSwitchOff,
                               .axes = {},
                               .presets = presets_of(configuration.parameters),
                               .supply = configuration.supply,
                               .infeed = configuration.infeed.has_value(),
                               .infeed_presets = configuration.infeed
                                                     ? presets_of(configuration.infeed->parameters)
                                                     : std::vector<device::ParameterPreset>{},
                               .sdo_block = configuration.sdo_block,
                               .fault_on_leaving_operational = configuration.fault_on_leaving_operational,
                               .remote_frames = port.carries_remote_frames()};
  for (const AxisConfiguration& axis : configuration.axes) result.axes.push_back(setup_of(axis));
  if (result.address_switch_off)
    result.node_id = device::address_without_switch(result, UnitMemory::saved_parameters(folder, log));
  return result;
}

/// The unit does not tell the warning limit apart.
constexpr device::BusState bus_state_of(bus::ErrorState state) noexcept {
  constexpr std::array kStates{device::BusState::Active, device::BusState::Active, device::BusState::Passive,
                               device::BusState::Off};
  return kStates[static_cast<std::size_t>(state)];
}

}  // namespace

Daemon::Daemon(const Configuration& configuration, const std::filesystem::path& state_root,
               const std::string& control, const Log& log)
    : configuration_{configuration},
      log_{log},
      started_{read_clock()},
      lock_{state_root, configuration.address, configuration.node_id},
      bus_{bus::open(configuration.address)},
      loop_{*bus_.port, *this},
      device_{device_configuration(configuration, *bus_.port, lock_.directory(), log), loop_.queue(), *this},
      events_{[this] { stop(); }},
      memory_{lock_.directory(), device_, events_, log},
      load_torques_{load_torques(configuration)} {
  if (configuration.node_id == kAddressSwitchOff) lock_.serve(configuration.address, device_.node_id());
  memory_.load();
  loop_.watch(events_.descriptor());
  link_source_ = events_.watch(bus_.link->descriptor(), EPOLLIN, &Daemon::on_link, this);
  if (!control.empty()) {
    control_.emplace(events_, control, [this](std::string_view line) { return answer_request(*this, line); });
  }
  log_receive_buffer();
  if (!loop_.port().carries_remote_frames())
    log_.notice("{} carries no remote frames: no node guarding, no life guarding", bus_name());
}

std::vector<Daemon::LoadTorque> Daemon::load_torques(const Configuration& configuration) {
  std::vector<LoadTorque> torques;
  for (const AxisConfiguration& axis : configuration.axes)
    torques.push_back({axis.load.constant_torque, axis.load.friction_torque});
  return torques;
}

void Daemon::log_receive_buffer() const {
  const auto buffer = loop_.port().receive_buffer();
  if (!buffer) return;
  if (buffer->bytes < buffer->wanted) {
    log_.warning("{}: receive buffer of {} bytes instead of {}: raise net.core.rmem_max", bus_name(),
                 buffer->bytes, buffer->wanted);
  } else {
    log_.info("{}: receive buffer of {} bytes", bus_name(), buffer->bytes);
  }
}

void Daemon::run() {
  if (bus_.link->state() == bus::LinkState::Up) {
    link_up();
  } else {
    log_.notice("{} is down: waiting until it is up", bus_name());
    sd_notifyf(0, "STATUS=%s is down", bus_name().c_str());
  }
  while (!stopping_) {
    loop_.turn();
    look_around();
  }
  sd_notify(0, "STOPPING=1\nSTATUS=");
  memory_.power_off();
  log_.info("power-off");
}

/// What a turn may have changed without telling.
void Daemon::look_around() noexcept {
  if (!ready_told_) tell_ready();
  if (!full_logged_ && loop_.queue().waiting() != 0) log_full_queue();
  if (device_.skipped_cycles() != skipped_seen_) log_skipped_cycles();
  if (device_.held_back_axes() != held_back_seen_) log_held_back();
  memory_.look_at_unit();
}

void Daemon::tell_ready() noexcept {
  // The boot-up frame has to be out.
  const bus::TransmitQueue& queue = loop_.queue();
  if (!loop_.is_open() || queue.waiting() != 0 || queue.counters().sent == sent_before_boot_up_) return;
  ready_told_ = true;
  log_.info("ready: node {} on {}", device_.node_id(), bus_name());
  sd_notifyf(0, "READY=1\nSTATUS=node %d on %s", int{device_.node_id()}, bus_name().c_str());
}

int Daemon::on_link(sd_event_source*, int, std::uint32_t, void* self) noexcept {
  auto& daemon = *static_cast<Daemon*>(self);
  if (const auto state = daemon.bus_.link->read()) {
    daemon.link_down();
    if (*state == bus::LinkState::Up) daemon.link_up();
  }
  return 0;
}

void Daemon::log_skipped_cycles() noexcept {
  const canopen::TimePoint now = read_clock();
  if (skipped_seen_ != 0 && now - skipped_logged_ < kRepeatedLogPeriod) return;
  log_.warning("{} cycles of {} ms were skipped: the daemon was kept from running",
               device_.skipped_cycles() - skipped_seen_,
               std::chrono::duration<double, std::milli>{device_.cycle()}.count());
  skipped_seen_ = device_.skipped_cycles();
  skipped_logged_ = now;
}

void Daemon::log_held_back() noexcept {
  const std::uint32_t seen = std::exchange(held_back_seen_, device_.held_back_axes());
  for (std::size_t axis = 1; axis <= configuration_.axes.size(); ++axis) {
    const std::uint32_t bit = 1U << (axis - 1);
    if ((held_back_seen_ & bit & ~seen) == 0) continue;
    log_.warning("axis {}: its load drives the shaft to {:.0f} rpm, where the rotor would burst: held there", axis,
                 motor::bursting_speed(configuration_.axes[axis - 1].machine) / motor::kRpm);
  }
}

void Daemon::log_full_queue() noexcept {
  full_logged_ = true;
  log_.notice("{}: the transmit queue of the interface is full, frames wait; told once (see the status)",
              bus_name());
}

void Daemon::link_up() noexcept {
  if (!loop_.open()) {
    log_.warning("{} is up but cannot be used", bus_name());
    return;
  }
  sent_before_boot_up_ = loop_.queue().counters().sent;
  device_.start(read_clock());
  memory_.raise_faults();
  if (ready_told_) {
    log_.notice("{} is up again", bus_name());
    sd_notifyf(0, "STATUS=node %d on %s", int{device_.node_id()}, bus_name().c_str());
  } else {
    tell_ready();
  }
}

void Daemon::link_down() noexcept {
  if (!loop_.is_open()) return;
  loop_.close();
  on_link_lost();
}

void Daemon::on_link_lost() noexcept {
  log_.warning("{} is down: waiting until it is up", bus_name());
  sd_notifyf(0, "STATUS=%s is down", bus_name().c_str());
}

void Daemon::on_error_state(bus::ErrorState state) noexcept {
  log_.warning("{}: {}", bus_name(), bus::name_of(state));
  device_.on_bus_state(bus_state_of(state), read_clock());
}

bool Daemon::on_bus_restart() noexcept {
  const bus::Restart outcome = loop_.restart_bus();
  if (outcome == bus::Restart::Refused) {
    log_.warning("{}: the controller cannot be restarted without CAP_NET_ADMIN: waiting for its restart-ms",
                 bus_name());
  } else {
    log_.notice("{}: restart from bus-off", bus_name());
  }
  return outcome == bus::Restart::Done;
}

bool Daemon::restart_bus() noexcept {
  return device_.restart_bus(read_clock());
}

void Daemon::on_burst_end() noexcept {
  const std::uint64_t lost = receive_overflows();
  if (lost == std::exchange(overflows_seen_, lost)) return;
  device_.on_frames_lost(read_clock());
}

void Daemon::on_subscriptions_changed() noexcept {
  loop_.follow_subscriptions();
}

void Daemon::on_foreign_frame(std::uint32_t identifier) noexcept {
  ++foreign_frames_;
  const canopen::TimePoint now = read_clock();
  if (foreign_frames_ != 1 && now - foreign_logged_ < kRepeatedLogPeriod) return;
  foreign_logged_ = now;
  log_.warning("{}: identifier {:03X}h came from another station: duplicate node-ID {}?", bus_name(), identifier,
               device_.node_id());
}

void Daemon::on_life_guarding_withheld() noexcept {
  if (withheld_logged_) return;
  withheld_logged_ = true;
  log_.warning("{}: life guarding (100Ch, 100Dh) is refused: the bus carries no remote frames; told once",
               bus_name());
}

tl::expected<void, drive::FaultError> Daemon::raise(std::size_t axis, std::uint16_t number,
                                                    std::uint32_t value) noexcept {
  return device_.raise(axis, number, value, read_clock());
}

bool Daemon::acknowledge(std::size_t axis) noexcept {
  return device_.acknowledge(axis, read_clock());
}

void Daemon::set_load_torque(std::size_t axis, double torque, motor::LoadTorqueType type) noexcept {
  const bool friction = type == motor::LoadTorqueType::Friction;
  load_torques_[axis - 1] = {friction ? 0.0 : torque, friction ? torque : 0.0};
  device_.set_load_torque(axis, torque, read_clock(), type);
}

void Daemon::set_line_voltage(double voltage) noexcept {
  device_.set_line_voltage(voltage, read_clock());
}

void Daemon::fail_encoder(std::size_t axis, motor::EncoderDefect defect) noexcept {
  device_.fail_encoder(axis, defect, read_clock());
}

void Daemon::set_input(unsigned number, bool high) noexcept {
  device_.set_input(number, high, read_clock());
}

double Daemon::uptime_s() const noexcept {
  return std::chrono::duration<double>(read_clock() - started_).count();
}

}  // namespace axisd
