#include "unit/runner.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace unit {

Runner::Runner(const Configuration& configuration, ParameterKeeper& keeper)
    : keeper_{keeper},
      unit_{configuration.drive, &parameters_},
      storage_{unit_, parameters_, keeper, follow_ups_},
      presets_{configuration, unit_, {parameters_, storage_.groups()}},
      retained_(drive::retained_image::size(unit_)),
      idle_{(AxisMask{1} << unit_.axes().size()) - 1} {}

void Runner::attach(Face& face) {
  faces_.push_back(&face);
  lay_presets(ParameterGroup::All);
  face.adopt({.cause = Replacement::Cause::Loaded});
}

void Runner::replace(const Face& face, Face& other) noexcept {
  const auto place = std::ranges::find(faces_, &face);
  if (place != faces_.end()) *place = &other;
}

void Runner::start(TimePoint now) noexcept {
  set_now(now);
  clock_.begin(now);
  started_ = now;
  rested_until_ = now;
  adopt({.cause = Replacement::Cause::PowerOn});
  run_cycle(true, now);  // run-up: the first statusword is that of a unit that is ready
  for (Face* const face : faces_) face->show();
  tell_time(now);
  take_over_period();
}

void Runner::tell_time(TimePoint now) noexcept {
  now_ = now;
  const Duration running = now - started_.value_or(now);
  if (clock_.is_resting() && now > rested_until_) {
    unit_.rest(std::chrono::duration<double>{now - rested_until_}.count());
  }
  rested_until_ = now;
  const auto uptime = std::chrono::duration_cast<std::chrono::milliseconds>(running).count();
  unit_.set_time(static_cast<drive::Uptime>(uptime));
  if (unit_.control_unit().clock().asks_host()) [[unlikely]]
    ask_host();
}

void Runner::ask_host() noexcept {
  unit_.control_unit().take_host_time(host_clock_ != nullptr ? host_clock_->host_time() : std::nullopt);
  show_messages_later();
}

/// The cycle of the axes that ends at @p end, with what has come; @p all of them, or those that something has come
/// for.
void Runner::run_cycle(bool all, TimePoint end) noexcept {
  begin_cycle(all, end);
  unit_.make_steps();
  unit_.finish_cycle();
}

void Runner::begin_cycle(bool all, TimePoint end) noexcept {
  if (observer_ != nullptr) [[unlikely]]
    observer_->on_cycle_begin(end - clock_.period());
  for (Face* const face : faces_) face->bring();
  std::array<bool, drive::kMostAxes> awake{};
  const std::size_t axes = unit_.axes().size();
  for (std::size_t i = 0; i < axes; ++i) awake[i] = all || (idle_ >> i & 1U) == 0;
  unit_.begin_cycle({awake.data(), axes}, clock_.seconds());
}

void Runner::run_cycles() noexcept {
  tell_time(now_);
  const CycleClock::Due due = clock_.take_due(now_);
  skipped_cycles_ += static_cast<std::uint64_t>(due.skipped);
  const Duration period = clock_.period();
  TimePoint end = clock_.last() - due.run * period;
  for (std::int64_t i = 0; i < due.run; ++i) run_cycle(false, end += period);
  end_cycles();
}

/// Several cycles that are due are made up for at once, each by itself.
drive::DriveUnit* Runner::begin_due() noexcept {
  if (clock_.next() > now_) return nullptr;
  if (now_ - clock_.next() >= clock_.period()) return run_cycles(), nullptr;
  tell_time(now_);
  static_cast<void>(clock_.take_due(now_));
  begin_cycle(false, clock_.last());
  if (unit_.shares_steps()) return &unit_;
  unit_.make_steps();
  finish_due();
  return nullptr;
}

void Runner::finish_due() noexcept {
  unit_.finish_cycle();
  end_cycles();
}

void Runner::end_cycles() noexcept {
  see_what_rests();
  publish();
  const bool infeed_rests = unit_.infeed() == nullptr || unit_.infeed()->is_quiescent();
  if (observer_ == nullptr && infeed_rests && idle_ == (AxisMask{1} << unit_.axes().size()) - 1) clock_.rest();
}

/// An axis is idle when nothing moves there and nothing waits for it.
void Runner::see_what_rests() noexcept {
  AxisMask waiting = 0;
  for (const Face* const face : faces_) waiting |= face->waiting();
  idle_ = 0;
  const std::span<const drive::Axis> axes = std::as_const(unit_).axes();
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i].is_quiescent()) idle_ |= AxisMask{1} << i;
  idle_ &= ~waiting;
}

/// What a cycle has led to: values change at the faces here and nowhere else.
void Runner::publish() noexcept {
  for (Face* const face : faces_) face->show();
  tell_of_messages();
  for (Face* const face : faces_) face->on_cycles_over();
}

void Runner::tell_of_messages() noexcept {
  follow_ups_.drop(FollowUp::ShowMessages);
  const bool changed = messages_.look(unit_);
  for (Face* const face : faces_) face->show_messages(changed);
}

void Runner::show_messages() noexcept {
  tell_of_messages();
  wake();
}

bool Runner::make_up_cycle() noexcept {
  const CycleClock::Due due = clock_.take_first_due(now_);
  if (due.run == 0) return false;
  skipped_cycles_ += static_cast<std::uint64_t>(due.skipped);
  tell_time(now_);
  run_cycle(false, clock_.last());
  return true;
}

void Runner::observe(CycleObserver* observer) noexcept {
  observer_ = observer;
  unit_.observe(observer);
  if (observer != nullptr && is_on()) wake_clock();
}

void Runner::wake_clock() noexcept {
  if (clock_.is_resting()) tell_time(now_);
  clock_.wake(now_);
}

void Runner::end_rest(TimePoint arrival) noexcept {
  if (!clock_.is_resting()) return;
  const TimePoint now = now_;
  tell_time(std::min(now, arrival));
  clock_.wake(std::exchange(now_, now));
}

std::uint8_t Runner::object_of(std::size_t axis) const noexcept {
  return axis == 0 ? drive::kControlUnitNumber : unit_.axes()[axis - 1].number();
}

tl::expected<void, drive::FaultError> Runner::raise(std::size_t axis, std::uint16_t number, std::uint32_t value,
                                                    TimePoint now) noexcept {
  tell_time(now);
  auto raised = unit_.raise(object_of(axis), number, value);
  show_messages();
  return raised;
}

bool Runner::acknowledge(std::size_t axis, TimePoint now) noexcept {
  tell_time(now);
  const bool clear = unit_.acknowledge(object_of(axis));
  show_messages();
  return clear;
}

void Runner::acknowledge() noexcept {
  tell_time(now_);
  unit_.for_each_object([this](const drive::DriveObject& object) { unit_.acknowledge(object.number()); });
  show_messages();
}

void Runner::set_line_voltage(double voltage, TimePoint now) noexcept {
  tell_time(now);
  unit_.set_line_voltage(voltage);
  wake();
}

void Runner::set_input(unsigned number, bool high, TimePoint now) noexcept {
  tell_time(now);
  unit_.control_unit().terminals().apply(number, high);
  wake();
}

void Runner::set_analog_input(double voltage, TimePoint now) noexcept {
  tell_time(now);
  unit_.control_unit().terminals().apply_analog(voltage);
  wake();
}

void Runner::set_plant(std::size_t axis, const motor::PlantSettings& settings, TimePoint now) noexcept {
  tell_time(now);
  unit_.axes()[axis - 1].set_plant(settings);
  wake(mask_of(axis));
}

void Runner::fail_encoder(std::size_t axis, motor::EncoderDefect defect, TimePoint now) noexcept {
  tell_time(now);
  unit_.axes()[axis - 1].fail_encoder(defect);
  wake(mask_of(axis));
}

void Runner::set_load_torque(std::size_t axis, double torque, TimePoint now, motor::LoadTorqueType type) noexcept {
  set_now(now);
  unit_.axes()[axis - 1].set_load_torque(torque, type);
  wake(mask_of(axis));
}

std::optional<drive::PanelRefusal> Runner::take_control(std::size_t axis, double timeout, TimePoint now) noexcept {
  tell_time(now);
  const std::optional<drive::PanelRefusal> refusal = unit_.take_control(axis - 1, timeout);
  if (!refusal) wake(mask_of(axis));
  return refusal;
}

bool Runner::command_by_panel(std::size_t axis, bool on, double speed, TimePoint now) noexcept {
  tell_time(now);
  return unit_.axes()[axis - 1].block<drive::OperatorPanel>().command(on, speed);
}

bool Runner::give_control_back(std::size_t axis, TimePoint now) noexcept {
  tell_time(now);
  return unit_.axes()[axis - 1].block<drive::OperatorPanel>().give_back();
}

bool Runner::is_moving() const noexcept {
  return !clock_.is_resting() && std::ranges::any_of(unit_.axes(), [](const drive::Axis& axis) {
    return axis.actual().pulses_enabled || std::abs(axis.actual().speed) > 0.0;
  });
}

AxisMask Runner::held_back_axes() const noexcept {
  AxisMask axes = 0;
  for (const drive::Axis& axis : unit_.axes())
    if (axis.drive_train().is_held_back()) axes |= mask_of(axis.axis_number());
  return axes;
}

}  // namespace unit
