#include "daemon/instance/instance.hpp"

#include <array>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "daemon/base/node_text.hpp"
#include "daemon/instance/device_setup.hpp"
#include "service/clock.hpp"

namespace axisd {
namespace {

/// The unit does not tell the warning limit apart.
constexpr device::BusState bus_state_of(bus::ErrorState state) noexcept {
  constexpr std::array kStates{device::BusState::Active, device::BusState::Active, device::BusState::Passive,
                               device::BusState::Off};
  return kStates[static_cast<std::size_t>(state)];
}

/// Cycles of units begin a multiple of this apart, so that a thread that runs many wakes for several at once.
constexpr canopen::Duration kGrid = std::chrono::microseconds{500};

/// The last point of the grid up to @p now.
canopen::TimePoint on_grid(canopen::TimePoint now) noexcept {
  return now - now.time_since_epoch() % kGrid;
}

std::vector<Instance::LoadTorque> load_torques(const Configuration& configuration) {
  std::vector<Instance::LoadTorque> torques;
  for (const AxisConfiguration& axis : configuration.axes)
    torques.push_back({axis.load.constant_torque, axis.load.friction_torque});
  return torques;
}

}  // namespace

Instance::Instance(const Configuration& configuration, const std::filesystem::path& folder, const Log& log,
                   InstanceListener& listener)
    : Instance{configuration, bus::open(configuration.address), folder, log, listener} {}

Instance::Instance(const Configuration& configuration, bus::Connection connection,
                   const std::filesystem::path& folder, const Log& log, InstanceListener& listener)
    : configuration_{configuration},
      log_{log},
      listener_{listener},
      started_{read_clock()},
      connection_{std::move(connection)},
      bus_{*connection_.port, *this},
      device_{device_plan(configuration, {*connection_.port, bus_.queue(), *this}, folder, log), *this},
      memory_{folder, device_, log},
      reports_{configuration, device_, log},
      recording_{{configuration, device_, frames_, events_, folder, started_}},
      load_torques_{load_torques(configuration)},
      rare_sources_{{memory_.descriptor(), this, &Instance::on_write_ended},
                    {connection_.link->descriptor(), this, &Instance::on_link}} {
  device_.attach(if1_);
  device_.unit().for_each_object(
      [this](const drive::DriveObject& object) { parameter_channels_.emplace_back(object.number()); });
  device_.runner().parameter_access().observe(*this);
  if (configuration.modbus) open_modbus(*configuration.modbus);
  if (const auto problem = configuration.trace ? trace_.problem_of(*configuration.trace) : std::nullopt)
    throw ConfigurationError{fmt::format("trace: {}: expected {}", problem->key, problem->expected)};
  if (!configuration.record) return;
  if (const auto signals = recording_.signals_of(*configuration.record); !signals)
    throw ConfigurationError{"record: " + signals.error()};
}

profidrive::ParameterChannel* Instance::parameter_channel(std::uint8_t object) noexcept {
  const auto found = std::ranges::find(parameter_channels_, object, &profidrive::ParameterChannel::object);
  return found != parameter_channels_.end() ? &*found : nullptr;
}

/// Somebody beside the bus has written a parameter.
void Instance::on_write(const drive::FoundParameter& parameter, double before, double value) noexcept {
  if (!events_.is_watched()) return;
  const drive::ParameterAddress at{parameter.object.number(), parameter.row().number, parameter.index};
  events_.on_parameter_written(at, value, before, device::node_time(device_.runner().now()));
}

void Instance::start() noexcept {
  if (configuration_.record) begin_recording();
  if (configuration_.audit) static_cast<void>(audit_.begin());  // there is room for it
  tell(record::EventKind::Power, true);
  load_faults();
  reports_.on_open(*connection_.port);
  if (modbus_) log_.info("Modbus TCP on {}", modbus_->server().place());
  if (connection_.link->state() == bus::LinkState::Up) return link_up();
  log_.notice("{} is down: waiting until it is up", bus_name());
  listener_.on_condition(*this, Condition::Down);
}

void Instance::look_around() noexcept {
  if (!ready_told_) tell_ready();
  reports_.look_at(bus_);
  memory_.look_at_unit();
  trace_.look_around();
  if (!events_.is_watched()) return;
  events_.look(frames_.now());
  if (const auto failure = recording_.take_failure()) log_.error("recording: {}; it has ended", *failure);
}

void Instance::begin_power_off() noexcept {
  tell(record::EventKind::Power, false);
  recording_.end();
  memory_.begin_power_off();
}

void Instance::power_off() noexcept {
  if (!memory_.has_begun_power_off()) begin_power_off();
  memory_.power_off();
  listener_.on_condition(*this, Condition::Off);
}

void Instance::tell_ready() noexcept {
  // The boot-up frame has to be out, if the node has one and no fault is there that may keep it.
  const bus::TransmitQueue& queue = std::as_const(bus_).queue();
  const bool is_silent = !faults_.is_empty() || device_.node_id() == canopen::kNoNodeId;
  const bool has_spoken = queue.counters().sent != sent_before_boot_up_;
  if (!bus_.is_open() || queue.waiting() != 0 || !(has_spoken || is_silent)) return;
  ready_told_ = true;
  log_.info("ready: {} on {}", node_text(device_.node_id()), bus_name());
  listener_.on_condition(*this, Condition::Ready);
}

void Instance::on_link() noexcept {
  if (const auto state = connection_.link->read()) {
    link_down();
    if (*state == bus::LinkState::Up) link_up();
  }
}

void Instance::link_up() noexcept {
  if (!bus_.open()) {
    log_.warning("{} is up but cannot be used", bus_name());
    return;
  }
  tell(record::EventKind::Link, true);
  sent_before_boot_up_ = bus_.queue().counters().sent;
  const canopen::TimePoint now = on_grid(read_clock());
  device_.start(now);
  if (!faults_.is_empty()) faults_.on_start(now);
  if (configuration_.trace && trace_.tracer().phase() == trace::Phase::Off)
    static_cast<void>(trace_.start(*configuration_.trace));  // it has been tried
  memory_.raise_faults();
  if (!ready_told_) return tell_ready();
  log_.notice("{} is up again", bus_name());
  listener_.on_condition(*this, Condition::UpAgain);
}

void Instance::link_down() noexcept {
  if (!bus_.is_open()) return;
  bus_.close();
  on_link_lost();
}

void Instance::on_link_lost() noexcept {
  tell(record::EventKind::Link, false);
  log_.warning("{} is down: waiting until it is up", bus_name());
  listener_.on_condition(*this, Condition::Down);
}

void Instance::on_error_state(bus::ErrorState state) noexcept {
  log_.warning("{}: {}", bus_name(), bus::name_of(state));
  const canopen::TimePoint now = read_clock();
  if (events_.is_watched()) events_.on_bus_state(state, frames_.now());
  if (!faults_.leads_bus_state()) device_.on_bus_state(bus_state_of(state), now);
}

/// What is refused at once is not saved either.
device::Keeping Instance::on_store(std::span<const std::byte> image) noexcept {
  const device::Keeping keeping = memory_.store(image);
  if (keeping != device::Keeping::Begun) tell(record::EventKind::Store, keeping == device::Keeping::Kept);
  return keeping;
}

std::optional<drive::UtcTime> Instance::host_time() noexcept {
  const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(os::wall_time()).count();
  return time >= 0 ? std::optional{static_cast<drive::UtcTime>(time)} : std::nullopt;
}

void Instance::on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept {
  if (events_.is_watched()) events_.on_nmt_state(from, to, frames_.now());
}

bool Instance::on_bus_restart() noexcept {
  if (faults_.is_bus_off()) return false;
  const bus::Restart outcome = bus_.restart_bus();
  reports_.on_restart(outcome);
  return outcome == bus::Restart::Done;
}

void Instance::open_modbus(const ModbusSettings& settings) {
  modbus_ = std::make_unique<ModbusDoor>(settings, device_, if1_);
  rare_sources_.push_back({modbus_->descriptor(), this, &Instance::on_modbus});
}

void Instance::on_modbus() noexcept {
  modbus_->handle(read_clock());
}

void Instance::on_burst_end() noexcept {
  device_.let_in(nullptr);
  const std::uint64_t lost = bus_.port().dropped();
  if (lost == std::exchange(overflows_seen_, lost)) return;
  device_.on_frames_lost(read_clock());
}

void Instance::set_load_torque(std::size_t axis, double torque, motor::LoadTorqueType type,
                               canopen::TimePoint now) noexcept {
  const bool friction = type == motor::LoadTorqueType::Friction;
  load_torques_[axis - 1] = {friction ? 0.0 : torque, friction ? torque : 0.0};
  device_.set_load_torque(axis, torque, now, type);
}

void Instance::tell(record::EventKind kind, bool active) noexcept {
  if (events_.is_watched()) events_.on_change(kind, active, frames_.now());
}

void Instance::tell_events(bool wanted) noexcept {
  if (!wanted) return events_.remove(*this);
  if (!events_.add(*this)) log_.error("{}: too many listen to the events of the unit", bus_name());
}

void Instance::begin_recording() noexcept {
  const auto begun = recording_.start(*configuration_.record, read_clock());
  if (!begun) log_.error("recording: {}", begun.error().message);
}

void Instance::on_tap(bool is_open) noexcept {
  has_listeners_ = is_open;
  connect();
}

/// Frames take the shortest way that passes those who want them: listeners hear what is on the bus, so they come
/// between that and the faults.
void Instance::connect() noexcept {
  const bool has_faults = !faults_.is_empty();
  bus_.lead_to(has_faults || has_listeners_ ? static_cast<Station&>(heard_) : *this);
  device_.send_to(has_faults       ? static_cast<canopen::FrameSink&>(faults_)
                  : has_listeners_ ? static_cast<canopen::FrameSink&>(frames_)
                                   : bus_.queue());
}

void Instance::set_bus_state(device::BusState state, canopen::TimePoint now) noexcept {
  constexpr std::array kStates{bus::ErrorState::Active, bus::ErrorState::Passive, bus::ErrorState::BusOff};
  const bus::ErrorState shown = kStates[static_cast<std::size_t>(state)];
  held_bus_state_ = state != device::BusState::Active ? std::optional{shown} : std::nullopt;
  if (events_.is_watched()) events_.on_bus_state(shown, now);
  device_.on_bus_state(state, now);
}

void Instance::load_faults() noexcept {
  for (const injection::Fault& fault : configuration_.inject)
    if (const auto loaded = faults_.add(fault); !loaded) log_.error("inject: {}", loaded.error());
}

double Instance::uptime_s() const noexcept {
  return std::chrono::duration<double>(read_clock() - started_).count();
}

}  // namespace axisd
