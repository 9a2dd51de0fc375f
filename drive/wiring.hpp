#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "drive/axis_inputs.hpp"
#include "drive/signal_source.hpp"

namespace drive {

/// The BICO interconnections of a unit, made ready for the cycle: what is constant is settled once, what is not is
/// a list of sources. In a cycle come, in this order, for the control unit and then the axes:
/// 1. connector-binector converters (p8899 -> r8894, r8895), with what the bus has brought for this cycle;
/// 2. the inputs of every axis, before any of them begins the cycle: a source on an axis has its value of the last
///    cycle;
/// 3. when the motors have moved, p2151 and p8785 to p8787 (feedback());
/// 4. when the statuswords are there, binector-connector converters (p8880 to p8884 -> r8889) and then the words
/// to
///    be sent (p8851, p8861).
class Wiring {
 public:
  /// Of @p unit, which outlives this; to be made when all drive objects exist.
  explicit Wiring(DriveUnit& unit);

  /// Inputs or references have changed: everything is found anew before it is next used.
  void invalidate() noexcept { valid_ = false; }
  /// Finds all sources if need be.
  void connect() noexcept;

  /// Step 1 of the cycle.
  void convert_words() noexcept;
  /// Step 2: what the inputs of drive object @p object (0 = control unit, then the axes) bring.
  AxisInputs inputs(std::size_t object) const noexcept;
  /// The same of the infeed, which the unit has as a drive object.
  AxisInputs infeed_inputs() const noexcept { return inputs(objects_.size() - 1); }
  /// Step 3, of axis @p axis (from 0).
  AxisFeedback feedback(std::size_t axis) const noexcept;
  /// Step 4.
  void convert_bits() noexcept;
  void send() noexcept;

  /// The digital outputs of the control unit (p0738 to p0745), in step 4 too.
  void lead_outputs() noexcept;

  /// p2102, of the control unit: acknowledges all.
  bool acknowledge_all() const noexcept { return acknowledge_all_.bit(); }

 private:
  template <class Member>
  struct Link {
    Member member;
    SignalSource source{};
    double full = 0.0;
  };
  /// A bit or a word of process data.
  struct Place {
    std::size_t word = 0;
    std::size_t bit = 0;
    SignalSource source{};
  };
  /// All of one drive object that changes from cycle to cycle, and what does not.
  struct Object {
    DriveObject* object = nullptr;
    AxisInputs constant_inputs{};
    std::vector<Link<bool AxisInputs::*>> bits{};
    std::vector<Link<double AxisInputs::*>> values{};
    SignalSource message_setpoint{};
    double reference_speed = 0.0;  // rad/s
    std::vector<Link<bool AxisFeedback::*>> status_bits{};
    AxisFeedback constant_feedback{};
    std::vector<Place> words_of_bits{};
    std::array<std::uint16_t, 5> constant_words_of_bits{};
    std::vector<Place> bits_of_words{};
    std::array<std::uint16_t, 2> inverted_words{};
    std::vector<Place> sent_words{};
    std::vector<Place> sent_double_words{};
  };

  static void reserve(Object& entry);
  void connect(Object& entry) noexcept;
  void connect_inputs(Object& entry) noexcept;
  void connect_feedback(Object& entry) noexcept;
  void connect_converters(Object& entry) noexcept;
  void connect_sent(Object& entry) noexcept;
  SignalSource source(const DriveObject& object, std::uint16_t number, std::size_t index = 0) const noexcept;

  DriveUnit& unit_;
  std::vector<Object> objects_;  // control unit, axes, infeed if it is a drive object
  SignalSource acknowledge_all_;
  std::array<SignalSource, Terminals::kOutputs> outputs_{};
  bool valid_ = false;
};

}  // namespace drive
