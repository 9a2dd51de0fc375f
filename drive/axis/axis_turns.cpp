// What the blocks of an axis do in their turns, which the schedule calls.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "drive/axis/axis.hpp"
#include "drive/sequence_control/statusword.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kOnIsPresent = 7200;
constexpr std::uint16_t kTorqueControlImpossible = 7430;

}  // namespace

void Axis::follow_panel() noexcept {
  auto& panel = block<OperatorPanel>();
  auto& sequence = block<SequenceControl>();
  if (panel.begin_cycle(duration_, sequence.pulses_enabled())) sequence.withhold_on();
  block<SpeedControl>().lead_speed(panel.is_active());
}

void Axis::choose_mode() noexcept {
  if (!block<SpeedControl>().begin_cycle() && block<SequenceControl>().pulses_enabled())
    static_cast<void>(raise(kTorqueControlImpossible));
}

void Axis::follow_jog_bits() noexcept {
  block<Jog>().begin_cycle();
}

/// The inputs of the enables and of messages, to the state that they lead to.
void Axis::control_sequence() noexcept {
  auto& sequence = block<SequenceControl>();
  const bool acknowledges = block<ExternalMessages>().acknowledges();
  auto& panel = block<OperatorPanel>();
  sequence.begin_cycle(panel.is_active() ? std::optional{panel.gives_on()} : std::nullopt);
  if (apply(Event::Initialised)) return;
  if (panel.awaits_off1()) {
    if (!sequence.withholds_on()) panel.see_off1();
    follow({kOnIsPresent, panel.awaits_off1(), 0});
  }
  const auto tell = [this](std::uint16_t number, bool present, bool) { follow({number, present, 0}); };
  sequence.follow_messages(tell);
  block<ExternalMessages>().follow(tell);
  if (acknowledges) {
    const State unacknowledged = sequence.state();
    acknowledge();
    if (sequence.state() != unacknowledged)
      return;  // Switch on disabled is seen for a cycle, whatever the word says
  }
  const bool link = block<PowerUnit>().has_link();
  sequence.follow_jog(block<Jog>().wants() && !panel.is_active(), block<Jog>().wanted());
  apply(sequence.command(link));
  if (const auto missing = sequence.await_power(link, duration_)) static_cast<void>(raise(*missing));
  if (!is_braking(sequence.state())) return;
  const double closing_time = has_brake() ? block<HoldingBrake>().settings.closing_time : 0.0;
  if (sequence.brakes_to_standstill(duration_, actual_.speed, block<SetpointChannel>().output(), closing_time))
    apply(Event::Standstill);
}

void Axis::lead_setpoint() noexcept {
  const auto& sequence = block<SequenceControl>();
  auto& channel = block<SetpointChannel>();
  channel.inputs.speed_setpoint_2 = block<SpeedSetpoint2>().inputs.speed;
  const auto& panel = block<OperatorPanel>();
  channel.begin_cycle(block<SpeedControl>().has_ramp_bits(),
                      panel.is_active() ? std::optional{panel.speed()} : std::nullopt);
  channel.choose(sequence.jogs() ? std::optional{block<Jog>().setpoint()} : std::nullopt);
  if (!sequence.operates() || block<Identification>().leads())
    channel.follow_zero();
  else if (positions() && block<PositionControl>().is_enabled())
    channel.follow_position(block<SpeedSetpoint2>().inputs.speed);
  else if (sequence.halts())
    channel.halt(sequence.settings.halt_option, train_.signals().measured_speed);
  else
    channel.follow();
  channel.begin_way();
}

void Axis::begin_sums() noexcept {
  command_ = {.pulses_enabled = block<SequenceControl>().pulses_enabled()};
  measured_ = false;
  block<PowerUnit>().begin_cycle();
  train_.begin_sums();
}

/// A halt in torque control takes the setpoint to zero, the rated torque in the time of the ramp or at once.
void Axis::lead_torque() noexcept {
  const auto& sequence = block<SequenceControl>();
  const auto& control = block<SpeedControl>();
  auto& channel = block<SetpointChannel>();
  auto& torque = block<TorqueSetpoint>();
  TorqueSetpoint::Turn turn{
      .leads = control.torque_control() && sequence.operates() && !block<Identification>().leads(),
      .enabled = control.inputs.enable,
      .halts = sequence.halts()};
  if (turn.leads && turn.halts) {
    const double time = channel.halt_time(sequence.settings.halt_option);
    const double rated = block<MotorModel>().settings.rated_torque;
    turn.halt_step = time > 0.0 ? rated / time * duration_ : std::numeric_limits<double>::infinity();
  }
  if (turn.leads || torque.led()) channel.track(train_.signals().measured_speed);
  torque.run(turn, command_);
}

/// Opens the brake with the pulses, and closes it at the end of a braking ramp while the motor still holds.
void Axis::lead_brake() noexcept {
  if (!has_brake()) return train_.set_brake(false);
  const auto& sequence = block<SequenceControl>();
  auto& brake = block<HoldingBrake>();
  const bool open = sequence.pulses_enabled() && !(is_braking(sequence.state()) && stands());
  train_.set_brake(!open || brake.is_held_closed());
  brake.lead(open, duration_);
  if (brake.is_opening()) block<SetpointChannel>().wait();  // the setpoint waits for the brake
}

void Axis::lead_identification() noexcept {
  if (block<Identification>().leads()) lead_measurement();
}

void Axis::plan_ramp() noexcept {
  if (command_.pulses_enabled && !measured_) block<SetpointChannel>().plan();
}

motor::AxisRun Axis::plan_steps(StepPlan& plan, std::size_t count) noexcept {
  auto& channel = block<SetpointChannel>();
  plan.ramp_before.reset();
  motor::AxisRun run{.train = &train_, .trip_current = block<PowerUnit>().trip_current()};
  if (measured_) {
    step_measurement();
  } else if (command_.pulses_enabled && channel.rests()) {
    command_.speed_setpoint = channel.total();
    command_.acceleration_setpoint = channel.acceleration();
  } else if (command_.pulses_enabled) {
    plan.ramp_before = channel.ramp();
    for (std::size_t i = 0; i < count; ++i) {
      const double speed = channel.step(motor::kControlPeriod);
      plan.setpoints[i] = {speed, channel.acceleration()};
    }
    plan.count = count;
    run.setpoints = std::span{plan.setpoints}.first(count);
  }
  run.command = command_;
  return run;
}

void Axis::take_steps(const StepPlan& plan, const motor::RunResult& done) noexcept {
  auto& channel = block<SetpointChannel>();
  if (plan.ramp_before && static_cast<std::size_t>(done.periods) < plan.count) [[unlikely]] {
    channel.set_ramp(*plan.ramp_before);
    for (long i = 0; i < done.periods; ++i) static_cast<void>(channel.step(motor::kControlPeriod));
  }
  const bool sound = block<PowerUnit>().watch(done, train_.sums(), train_.signals(), train_.plant_state().current);
  if (!sound) command_.pulses_enabled = false;
}

double Axis::step(double dc_voltage) noexcept {
  StepPlan plan;
  motor::AxisRun run = plan_steps(plan, 1);
  if (!run.setpoints.empty()) {
    run.command.speed_setpoint = plan.setpoints[0].speed;
    run.command.acceleration_setpoint = plan.setpoints[0].acceleration;
  }
  const double drawn = train_.step(dc_voltage, run.command);
  take_steps(plan, {1, dc_voltage, dc_voltage, dc_voltage});
  return drawn;
}

void Axis::measure() noexcept {
  auto& measurement = block<Measurement>();
  measurement.measure(train_);
  if (!positions()) block<ActualPosition>().note(measurement.counts(), measurement.speed());
  actual_.speed = measurement.speed();
  actual_.torque_demand = measurement.torque_demand();
  actual_.torque = measurement.torque();
  actual_.encoder_counts = measurement.counts();
  actual_.encoder_position = static_cast<std::int32_t>(static_cast<std::uint32_t>(measurement.counts()));
  block<SetpointChannel>().end_way(measurement.duration());
}

/// A measurement has led the speed, from which the ramp goes on.
void Axis::track_measurement() noexcept {
  if (measured_) block<SetpointChannel>().track(command_.speed_setpoint);
}

void Axis::watch_speed() noexcept {
  const auto& channel = block<SetpointChannel>();
  const bool pulses = block<SequenceControl>().pulses_enabled();
  block<SpeedMessages>().run({.duration = duration_,
                              .speed = actual_.speed,
                              .ramp_input = channel.input(),
                              .forward_limit = channel.forward_limit(),
                              .backward_limit = channel.backward_limit(),
                              .at_torque_limit = pulses && std::abs(channel.total()) > 0.0 &&
                                                 train_.signals().torque_limit_reached &&
                                                 !block<TorqueSetpoint>().inputs.travels_to_fixed_stop});
}

void Axis::follow_encoder_word() noexcept {
  if (block<EncoderInterface>().is_asked()) answer_encoder_word();
}

[[gnu::noinline]] void Axis::answer_encoder_word() noexcept {
  const bool cause_present =
      std::ranges::any_of(causes_of<Measurement>, [this](const auto& row) { return causes_.holds(row.message); });
  block<EncoderInterface>().run({.position = static_cast<std::uint32_t>(actual_.encoder_position),
                                 .faulty = has_encoder_fault(),
                                 .cause_present = cause_present});
}

void Axis::observe_motor() noexcept {
  block<PowerUnit>().observe(train_.signals());
  block<MotorMonitoring>().observe(train_.signals());
  block<Measurement>().observe(train_.encoder());
}

/// Which messages follow from what has come of the cycle.
void Axis::judge_causes() noexcept {
  causes_.update(duration_, blocks_, block<SequenceControl>().pulses_enabled(),
                 [this](const Verdict& verdict) { follow(verdict); });
}

void Axis::conclude_measurement() noexcept {
  if (measured_) end_measurement();
}

void Axis::refresh_status() noexcept {
  const auto& sequence = block<SequenceControl>();
  const auto& speed = block<SpeedMessages>();
  const FreeStatusBits::Inputs& free = block<FreeStatusBits>().inputs;
  actual_.state = sequence.state();
  actual_.pulses_enabled = sequence.pulses_enabled();
  actual_.speed_demand = block<SetpointChannel>().total();
  actual_.mode = block<SpeedControl>().mode();
  actual_.statusword = statusword(sequence.state(), {.no_off2 = !sequence.effective().has_off2(),
                                                     .no_off3 = !sequence.effective().has_off3(),
                                                     .fault = !messages().faults().empty(),
                                                     .alarm = !messages().alarms().empty(),
                                                     .remote = !block<OperatorPanel>().is_active(),
                                                     .target_reached = speed.target_reached(),
                                                     .torque_limit_reached = is_at_torque_limit(),
                                                     .speed_zero = speed.is_zero(actual_.speed),
                                                     .free_bit_8 = free.bit_8,
                                                     .free_bit_14 = free.bit_14,
                                                     .free_bit_15 = free.bit_15});
}

/// The free bits may come of what the word itself or other axes have come to.
void Axis::show_free_bits() noexcept {
  actual_.statusword = with_free_bits(actual_.statusword, block<FreeStatusBits>().inputs);
  settled_ = actual_ == before_;
}

void Axis::rest(double duration, double dc_voltage) noexcept {
  block<PowerUnit>().rest(dc_voltage);
  train_.rest(duration);
}

}  // namespace drive
