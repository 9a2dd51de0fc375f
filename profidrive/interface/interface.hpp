#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "profidrive/interface/assignment.hpp"
#include "profidrive/interface/exchange.hpp"
#include "unit/face.hpp"
#include "unit/parameter_owner.hpp"
#include "unit/runner.hpp"

namespace profidrive {

/// IF1: the process data that a controller exchanges with the drive objects of a unit beside its CAN bus, over
/// whatever door they come (PROFIdrive). It runs in cycles of p2048: what has come acts from the start of a cycle,
/// what is sent is sampled at the end of one. The telegrams of p0922 and p2079 are wired and locked here.
class Interface final : public unit::Face, private unit::ParameterOwner, private unit::ParameterLock {
 public:
  /// Of the unit that @p runner runs, which outlives this; to be attached to it. Nothing is allocated after that.
  explicit Interface(unit::Runner& runner);

  /// Whether drive object @p object exchanges process data here; false for all while p8839 assigns IF1 nothing.
  bool has(std::uint8_t object) const noexcept;
  bool is_assigned() const noexcept { return assignment_.if1; }
  /// A controller sends the words of drive object @p object from word @p first (0..) on; they act with the next
  /// cycle. Words that the drive object does not have are dropped. Monitoring (p2040) begins, or begins anew. The
  /// time is what the runner was told.
  void receive(std::uint8_t object, std::span<const std::uint16_t> words, std::size_t first = 0) noexcept;
  /// A controller has looked at process data of @p object: monitoring that runs begins anew.
  void touch(std::uint8_t object) noexcept;
  /// A connection that had brought process data of @p object is gone: A01925, until some come again.
  void on_connection_lost(std::uint8_t object) noexcept;
  /// The words that @p object sends (r2053), as of the end of the last cycle.
  std::span<const std::uint16_t> sent(std::uint8_t object) const noexcept;
  /// The words that @p object has received (r2050), as they act.
  std::span<const std::uint16_t> received(std::uint8_t object) const noexcept;
  /// So many words @p object sends by its telegram and its interconnections.
  std::size_t words_to_send(std::uint8_t object) const noexcept;
  /// How the exchange with @p object stands.
  Monitoring::Stage stage(std::uint8_t object) const noexcept;
  /// What p0922 and p2079 of @p object select.
  Selection selection(std::uint8_t object) const noexcept;

  /// The configuration asks for Modbus TCP: p2030 reads 13, and nobody writes it.
  void serve_modbus() noexcept { serves_modbus_ = true; }

  // unit::Face
  void bring() noexcept override;
  unit::AxisMask waiting() const noexcept override;
  void show() noexcept override;
  void on_cycles_over() noexcept override;
  void adopt(const unit::Replacement& replacement) noexcept override;

 private:
  // interface_parameters.cpp
  std::optional<double> value_of(const unit::ParameterPlace& place) const noexcept override;
  std::optional<drive::Refusal> take(const unit::ParameterPlace& place, double value) noexcept override;
  bool holds(const drive::DriveObject& object, std::uint16_t number, std::size_t index) const noexcept override;
  void select(Exchange& exchange, const Selection& selection) noexcept;
  void follow(std::uint16_t number, double value) noexcept;
  void follow_cycle(double period) noexcept;
  std::optional<drive::Refusal> select_standard(Exchange& exchange, double telegram) noexcept;
  std::optional<drive::Refusal> select_extended(Exchange& exchange, double telegram) noexcept;
  void follow_selection(Exchange& exchange) noexcept;

  Exchange* find(std::uint8_t object) noexcept;
  const Exchange* find(std::uint8_t object) const noexcept;
  drive::DriveObject& control_unit() const noexcept { return runner_.unit().control_unit(); }
  void begin(Exchange& exchange) noexcept;
  void watch_sign_of_life(Exchange& exchange) noexcept;
  void monitor(Exchange& exchange) noexcept;
  void tell(Exchange& exchange, std::uint16_t message, bool present) noexcept;
  void assign() noexcept;
  void shut_can_out() noexcept;

  unit::Runner& runner_;
  std::vector<Exchange> exchanges_;
  Assignment assignment_{};
  unit::Duration limit_{};    ///< p2040
  unit::Duration further_{};  ///< p2047
  bool serves_modbus_ = false;
  bool is_used_ = false;         ///< something has come, or a telegram is selected
  unsigned cycles_of_unit_ = 1;  ///< cycles of the unit (p8848) in one of the interface (p2048)
  unsigned cycle_ = 0;           ///< of the unit since the last one of the interface began
};

}  // namespace profidrive
