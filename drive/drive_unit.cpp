#include "drive/drive_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "drive/axis/axis_step.hpp"
#include "drive/base/function_modules.hpp"
#include "drive/wiring.hpp"
#include "motor/data/control_period.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kDeviceFilter = 9;  // p0009

ObjectContext control_unit_context(const UnitConfiguration& configuration) noexcept {
  ObjectContext context{};
  context.kind = ObjectKind::ControlUnit;
  context.node_id = configuration.node_id;
  context.address_switch_off = configuration.address_switch_off;
  context.axis_count = static_cast<std::uint8_t>(configuration.axes.size());
  context.supply = configuration.supply;
  context.has_infeed = configuration.infeed;
  std::transform(configuration.axes.begin(), configuration.axes.end(), context.axes.begin(),
                 [](const AxisConfiguration& axis) { return axis.kind; });
  std::ranges::transform(configuration.axes, context.modules.begin(), function_module::of_new);
  return context;
}

}  // namespace

DriveUnit::DriveUnit(const UnitConfiguration& configuration, ParameterHost* host)
    : host_{host},
      dc_link_{configuration.supply},
      line_voltage_{configuration.supply.line_voltage},
      control_unit_{control_unit_context(configuration)} {
  if (configuration.infeed) {
    infeed_.emplace(ObjectContext{.kind = ObjectKind::Infeed, .supply = configuration.supply, .has_infeed = true});
    dc_link_.start(0.0);
    connect_line();
  }
  axes_.reserve(configuration.axes.size());
  for (const AxisConfiguration& axis : configuration.axes)
    axes_.emplace_back(axis, static_cast<std::uint8_t>(axes_.size()), configuration.node_id, configuration.supply,
                       configuration.infeed);
  fit_switches();
  wiring_ = std::make_unique<Wiring>(*this);
  group_inputs();
  for_each_object([this](DriveObject& object) { object.join(*this); });
}

DriveUnit::~DriveUnit() = default;

void DriveUnit::on_wiring_changed() noexcept {
  if (wiring_ != nullptr) wiring_->invalidate();
}

void DriveUnit::send_process_data() noexcept {
  wiring_->connect();
  wiring_->send();
}

void DriveUnit::exchange_process_data() noexcept {
  wiring_->connect();
  wiring_->convert_words();
  send_converted();
}

void DriveUnit::cycle(std::span<const bool> awake, double duration) noexcept {
  begin_cycle(awake, duration);
  make_steps();
  finish_cycle();
}

void DriveUnit::begin_cycle(std::span<const bool> awake, double duration) noexcept {
  wiring_->connect();
  wiring_->convert_words();
  for (std::size_t i = 0; i < axes_.size(); ++i) running_.runs[i] = awake[i] || !has_nothing_to_do(axes_[i]);
  run_for(duration);
  for (Axis* const axis : running_.all()) {
    axis->start_cycle(duration);
    axis->take_image();
    take_inputs(*axis, Phase::Sequence);
  }
  follow_unit_inputs();
  run_infeed(duration);
  for (Axis* const axis : running_.all()) axis->run(Phase::Sequence);
  for (const Phase phase : {Phase::Setpoint, Phase::Torque}) {
    wake_for(phase);
    run_phase(phase);
  }
  rest_others();
}

void DriveUnit::finish_cycle() noexcept {
  for (const Phase phase : kAfterTheSteps) {
    wake_for(phase);
    run_phase(phase);
  }
  end_cycle();
}

void DriveUnit::cycle(std::span<const std::optional<Setpoints>> setpoints, double duration) noexcept {
  wiring_->connect();
  run_infeed(duration);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    running_.runs[i] = setpoints[i].has_value();
    if (!running_.runs[i]) continue;
    axes_[i].command(*setpoints[i]);
    axes_[i].begin_cycle(duration);
  }
  run_for(duration);
  rest_others();
  make_steps();
  for (const Phase phase : kAfterTheSteps) run_phase(phase);
  end_cycle();
  wiring_->invalidate();  // the inputs do not hold what they are connected to
}

/// A cycle of @p duration (s) of the axes that are said to run.
void DriveUnit::run_for(double duration) noexcept {
  running_.duration = duration;
  running_.steps = std::lround(duration / motor::kControlPeriod);
  collect_running();
}

void DriveUnit::collect_running() noexcept {
  running_.count = 0;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (running_.runs[i]) running_.axes[running_.count++] = &axes_[i];
}

/// An axis at rest that @p phase brings something new goes on from there: what it has missed of the cycle would
/// have changed nothing.
void DriveUnit::wake_for(Phase phase) noexcept {
  if (running_.count == axes_.size()) return;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (running_.runs[i] || !has_new_inputs(axes_[i], phase)) continue;
    running_.runs[i] = true;
    axes_[i].start_cycle(running_.duration);
    for (const Phase missed : kBeforeTheSteps)
      if (missed < phase) axes_[i].run(missed);
  }
  collect_running();
}

/// All axes see of each other what the phase before has led to.
void DriveUnit::run_phase(Phase phase) noexcept {
  if (!Axis::inputs_of(phase).empty())
    for (const Axis* const axis : running_.all()) take_inputs(*axis, phase);
  for (Axis* const axis : running_.all()) axis->run(phase);
}

void DriveUnit::rest_others() noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (!running_.runs[i]) axes_[i].rest(running_.duration, dc_link_.voltage());
}

/// What is made of bits, and what is put out.
void DriveUnit::send_converted() noexcept {
  wiring_->convert_bits();
  wiring_->take(control_unit_, kBlock<TerminalInputs>);
  control_unit_.lead_outputs();
  wiring_->send();
}

void DriveUnit::end_cycle() noexcept {
  send_converted();
  if (observer_ != nullptr) [[unlikely]]
    observer_->on_cycle_end();
}

void DriveUnit::rest(double duration) noexcept {
  dc_link_.step(duration, 0.0);
  for (Axis& axis : axes_) axis.rest(duration, dc_link_.voltage());
}

DriveObject* DriveUnit::object(std::uint8_t number) noexcept {
  if (number == kControlUnitNumber) return &control_unit_;
  if (infeed_ && number == kInfeedNumber) return &*infeed_;
  const bool exists = number >= first_axis() && number < first_axis() + axes_.size();
  return exists ? &axes_[number - first_axis()] : nullptr;
}

const DriveObject* DriveUnit::object(std::uint8_t number) const noexcept {
  if (number == kControlUnitNumber) return &control_unit_;
  if (infeed_ && number == kInfeedNumber) return &*infeed_;
  const bool exists = number >= first_axis() && number < first_axis() + axes_.size();
  return exists ? &axes_[number - first_axis()] : nullptr;
}

void DriveUnit::set_time(Uptime now) noexcept {
  uptime_ = now;
  control_unit_.clock().tell(runtime());
}

void DriveUnit::continue_after(Uptime runtime) noexcept {
  former_runtime_ = runtime;
  control_unit_.clock().continue_at(this->runtime());
}

tl::expected<void, FaultError> DriveUnit::raise(std::uint8_t object, std::uint16_t number, std::uint32_t value,
                                                Cause cause) noexcept {
  const FaultRow* const row = find_fault(number);
  DriveObject* const origin = this->object(object);
  if (row == nullptr) return tl::unexpected{FaultError::Unknown};
  if (origin == nullptr) return tl::unexpected{FaultError::NotOnThisAxis};
  auto raised = origin->raise(number, value, cause);
  if (!raised || row->propagation == Propagation::Local) return raised;
  for_each_object([&](DriveObject& other) {
    if (&other != origin) static_cast<void>(other.raise(number, value, cause));
  });
  return raised;
}

void DriveUnit::withdraw(std::uint8_t object, std::uint16_t number) noexcept {
  const FaultRow* const row = find_fault(number);
  DriveObject* const origin = this->object(object);
  if (row == nullptr || origin == nullptr) return;
  if (row->propagation == Propagation::Local) return origin->withdraw(number);
  for_each_object([=](DriveObject& other) { other.withdraw(number); });
}

bool DriveUnit::acknowledge() noexcept {
  bool none_left = true;
  for_each_object([&](DriveObject& object) { none_left = object.acknowledge() && none_left; });
  return none_left;
}

bool DriveUnit::acknowledge(std::uint8_t object) noexcept {
  DriveObject* const owner = this->object(object);
  if (owner == nullptr) return true;
  const bool none_left = owner->acknowledge();
  while (true) {
    const auto alarms = owner->messages().alarms();
    const auto raised = std::ranges::find(alarms, Cause::Gone, &FaultEntry::cause);
    if (raised == alarms.end()) return none_left;
    withdraw(object, raised->row->number);
  }
}

void DriveUnit::power_off() noexcept {
  wiring_->invalidate();
  for_each_object([](DriveObject& object) { object.power_off(); });
}

void DriveUnit::restore_parameters() noexcept {
  restore_parameters(is_reset);
  leave_commissioning();
}

void DriveUnit::restore_parameters(RowFilter which) noexcept {
  for_each_object([=](DriveObject& object) { object.restore_parameters(which); });
}

void DriveUnit::leave_commissioning() noexcept {
  for (Axis& axis : axes_) axis.leave_commissioning();
  control_unit_.bring_in(kDeviceFilter, 0, 0.0);
  inhibit_axes(false);
  follow_function_modules();
}

std::optional<ObjectKind> DriveUnit::kind_of(std::uint8_t number) const noexcept {
  const DriveObject* const found = object(number);
  return found != nullptr ? std::optional{found->kind()} : std::nullopt;
}

std::optional<Refusal> DriveUnit::agree(const DriveObject& object, const ParameterRow& row, std::size_t index,
                                        double value) noexcept {
  const std::optional<Refusal> refused =
      host_ != nullptr ? host_->on_parameter(object, row, index, value) : std::nullopt;
  if (refused || row.number != kDeviceFilter) return refused;
  const bool commissions = value > 0.0;
  inhibit_axes(commissions);
  if (!commissions) follow_function_modules();
  return std::nullopt;
}

std::optional<double> DriveUnit::agreed_value(const DriveObject& object, const ParameterRow& row,
                                              std::size_t index) const noexcept {
  return host_ != nullptr ? host_->value_of(object, row, index) : std::nullopt;
}

std::optional<Refusal> DriveUnit::lock_on(const DriveObject& object, const ParameterRow& row,
                                          std::size_t index) const noexcept {
  return host_ != nullptr ? host_->lock_on(object, row, index) : std::nullopt;
}

void DriveUnit::inhibit_axes(bool inhibited) noexcept {
  if (infeed_) infeed_->inhibit(inhibited);
  for (Axis& axis : axes_) axis.inhibit(inhibited);
}

}  // namespace drive
