#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <span>

#include "motor/control/field/field_without_encoder.hpp"
#include "motor/control/field/induction_field.hpp"
#include "motor/control/field/synchronous_field.hpp"
#include "motor/control/field/voltage_frequency.hpp"
#include "motor/drive_train.hpp"
#include "motor/lockstep/lane_group.hpp"
#include "motor/lockstep/lanes.hpp"
#include "motor/plant/encoder_track.hpp"
#include "motor/plant/plant_motion.hpp"
#include "motor/train_state.hpp"

namespace motor {

/// The drive trains of some axes in lanes. Only what every step changes or needs is there; the rest stays with
/// each drive train, which is asked where it counts: when temperatures are to be brought up to date, and at zero
/// marks.
template <class Number>
class LaneTrain final : public LaneGroup {
 public:
  LaneTrain(const LaneKind& kind, std::span<const LaneAxis> axes) noexcept : kind_{kind}, count_{axes.size()} {
    for (std::size_t lane = 0; lane < kLanes<Number>; ++lane) {
      const LaneAxis& axis = axes[lane < count_ ? lane : 0];
      axes_[lane] = axis.run;
      dc_voltage_[lane] = axis.dc_voltage;
      trains_[lane] = axes_[lane]->train;
      setpoints_[lane] = axes_[lane]->setpoints;
      led_ = led_ || !setpoints_[lane].empty();
    }
    enter_trains();
    take_commands();
  }

  MOTOR_IN_ONE bool step(std::size_t period, double* drawn) noexcept override {
    if (led_) [[unlikely]]
      lead(period);
    const Number link{[this](auto lane) { return *dc_voltage_[lane]; }};
    const SpaceVectorOf<Number> wanted = control(link);
    move(link);
    state_.next = wanted;
    observe();
    const Number energy = plant_.energies.electrical + state_.inverter_losses;
    energy.copy_to(drawn, std::experimental::element_aligned);
    return !any(signals_.current > trip_current_);
  }
  void leave() noexcept override;

 private:
  using SynchronousControl = FieldControl<SynchronousField<Number>>;
  using InductionControl = FieldControl<InductionField<Number>>;
  using FrequencyControl = VoltageFrequencyControl<Number>;

  /// Room for one of several types.
  template <class... Types>
  struct alignas(Number) Room {
    std::array<std::byte, std::max({sizeof(Types)...})> bytes;

    template <class Type>
    Type& as() noexcept {
      return *std::launder(reinterpret_cast<Type*>(bytes.data()));
    }
  };

  // How axes enter and leave (lane_passage.hpp).
  void enter_trains() noexcept;
  void show() noexcept;
  void give_signals(std::size_t lane) noexcept;
  void take_commands() noexcept;
  [[gnu::noinline]] void warm() noexcept;
  [[gnu::noinline]] void pass_marks() noexcept;
  template <class Visitor>
  void visit_common(Visitor visit) noexcept;
  template <class Visitor>
  void visit_machine(Visitor visit) noexcept;
  template <class Visitor>
  void visit_shaft(Visitor visit) noexcept;
  template <class Visitor>
  void visit_control(Visitor visit) noexcept;
  template <class Find>
  LaneObjects<Number> of_each(Find find) noexcept;

  // What happens in a period (lane_step.hpp).
  void lead(std::size_t period) noexcept;
  SpaceVectorOf<Number> control(const Number& dc_voltage) noexcept;
  void move(const Number& dc_voltage) noexcept;
  void observe() noexcept;
  template <class Control, bool WithEncoder>
  SpaceVectorOf<Number> control_by(const Number& dc_voltage) noexcept;
  void turn(const SpaceVectorOf<Number>& voltage) noexcept;
  template <class Machine, class Shaft>
  void turn_shaft(const SpaceVectorOf<Number>& voltage) noexcept;

  LaneKind kind_;
  std::size_t count_;  // of the lanes that are axes; the others do what the first does
  bool led_ = false;
  bool shown_ = false;                               // the plants, as they are now
  std::array<const AxisRun*, kLanes<Number>> axes_;  // while they enter
  std::array<DriveTrain*, kLanes<Number>> trains_;
  std::array<const double*, kLanes<Number>> dc_voltage_;
  std::array<std::span<const SpeedStep>, kLanes<Number>> setpoints_;
  Number trip_current_;
  DriveCommandOf<Number> command_;
  SignalsOf<Number> signals_;
  StepSums<Number> sums_;
  TrainState<Number> state_;
  InverterLosses<Number> inverter_;
  EncoderTrack<Number> encoder_;
  Number counting_;       // 1 where an encoder is, 0 elsewhere
  Number counted_ = 0.0;  // increments since the encoders were told
  PlantMotion<Number> plant_;
  LaneProfiles<Number> profiles_;
  Room<SynchronousControl, InductionControl, FrequencyControl> control_;
  Room<SynchronousEquations<Number>, InductionEquations<Number>> machine_;
  Room<RigidShaft<true, Number>, RigidShaft<false, Number>, ElasticShaftOf<Number>> shaft_;
};

}  // namespace motor
