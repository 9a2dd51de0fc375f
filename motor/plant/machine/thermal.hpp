#pragma once

#include <array>
#include <cmath>

#include "motor/data/machine_data.hpp"

namespace motor {

/// The share of a deviation that a first-order lag makes up in a step, kept for steps of equal length.
class LagShare {
 public:
  /// Of @p time_constant (s, positive).
  explicit LagShare(double time_constant) noexcept : rate_{1.0 / time_constant} {}
  /// For a step of @p dt (s): 0..1, exact for any length.
  double of(double dt) noexcept {
    if (dt < dt_ || dt > dt_) {
      dt_ = dt;
      share_ = -std::expm1(-rate_ * dt);
    }
    return share_;
  }

 private:
  double rate_;      // 1/s
  double dt_ = 0.0;  // s
  double share_ = 0.0;
};

/// True temperatures of a machine: winding and frame as two bodies, exact for steps of any length with constant
/// losses. What the drive believes is another matter (OverloadModel).
class MotorThermal {
 public:
  /// Everything at the temperature of the air.
  explicit MotorThermal(const ThermalData& data) noexcept;

  /// Heats for @p dt (s, positive) with the losses of the winding and those of iron and bearings, means over dt
  /// (W).
  void step(double dt, double copper_losses, double iron_losses) noexcept;
  /// The air has @p temperature (°C) from now on.
  void set_ambient(double temperature) noexcept { data_.ambient = temperature; }
  /// Sets both bodies to @p temperature (°C).
  void start(double temperature) noexcept { winding_ = frame_ = temperature; }
  /// Winding, which the sensor and the stator resistance follow (°C).
  double winding() const noexcept { return winding_; }
  /// Frame; rotor and magnets are taken to be as warm (°C).
  double frame() const noexcept { return frame_; }

 private:
  ThermalData data_;
  double step_ = 0.0;  // s, for which transition_ holds
  std::array<double, 4> transition_{1.0, 0.0, 0.0,
                                    1.0};  // of the deviations of winding and frame over a step, by rows
  double winding_;                         // °C
  double frame_;                           // °C
};

/// Settings of an overload model.
struct OverloadData {
  double reference_current = 8.0;  ///< that it carries for ever (A rms), positive
  double time_constant = 2400.0;   ///< p0611 (s), positive
  double rise = 80.0;              ///< p0627, at the reference current (K)
  double ambient = 20.0;           ///< p0613 (°C)
};

/// I²t: a first-order lag of the square of the current. For a motor it is the drive's thermal model 1 (p0612.0),
/// which knows the current only and not the true temperature.
class OverloadModel {
 public:
  explicit OverloadModel(const OverloadData& data) noexcept : data_{data}, share_{data.time_constant} {}

  /// Goes on for @p dt (s) with the mean of the squared current (A² rms); exact for any length.
  void step(double dt, double mean_square_current) noexcept {
    const double reached = mean_square_current / (data_.reference_current * data_.reference_current);
    utilisation_ += share_.of(dt) * (reached - utilisation_);
  }
  /// r0034 or r0036 (1 = the reference current for ever).
  double utilisation() const noexcept { return utilisation_; }
  /// What the model takes for the temperature (°C).
  double temperature() const noexcept { return data_.ambient + data_.rise * utilisation_; }
  /// Starts as cold as the air.
  void reset() noexcept { utilisation_ = 0.0; }

 private:
  OverloadData data_;
  LagShare share_;
  double utilisation_ = 0.0;
};

}  // namespace motor
