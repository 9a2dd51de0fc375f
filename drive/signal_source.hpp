#pragma once

#include <cstdint>
#include <optional>

#include "drive/drive_unit.hpp"
#include "drive/parameter/rounding.hpp"

namespace drive {

/// Where a BICO input gets its value from: a constant, or a parameter of a drive object. It is found once, when
/// the input is connected; in the cycle a function brings the number that lies there, without any search. What
/// bits and values become of that number changes with it alone.
class SignalSource {
 public:
  /// The constant 0.
  SignalSource() = default;
  /// What the input of @p own that holds @p packed is connected to; a source that does not exist gives 0. Holds
  /// until a reference (p2000 to p2007) or the scaling of a drive object of @p unit changes.
  SignalSource(const DriveUnit& unit, const DriveObject& own, std::uint32_t packed) noexcept;

  /// From now on a connector brings its number as it is, not as a share.
  void take_plain() noexcept;

  /// Whether the value can never change.
  bool is_constant() const noexcept { return placed_ == nullptr; }
  /// The number that a connector brings now, and the one whose bits a binector brings; 0 of a constant.
  double number() const noexcept { return number_at(index_); }
  double word() const noexcept { return number_at(word_index_); }

  /// The value of a binector, now or where word() is @p word.
  bool bit() const noexcept { return bit(word()); }
  bool bit(double word) const noexcept {
    return is_constant() ? scale_ > 0.0 : (static_cast<std::int64_t>(word) >> bit_ & 1) != 0;
  }
  /// Whether @p other has the same word().
  bool shares_word(const SignalSource& other) const noexcept {
    return object_ == other.object_ && placed_ == other.placed_ && word_index_ == other.word_index_;
  }
  /// The value of a connector for an input in which @p full is 100 %, now or where number() is @p number: a
  /// quantity relative to its reference (p2000 to p2007 of the drive object that it comes from), process data
  /// relative to their own 100 %, a number without unit as it is.
  double value(double full) const noexcept { return value(number(), full); }
  double value(double number, double full) const noexcept {
    if (is_constant()) return scale_ * full;
    const double value = parameter(number);
    return is_quantity_ ? value * scale_ * full : value;
  }
  /// The same as a word or double word of process data: a quantity saturates at the ends of @p Int, of a number
  /// the lower bits count.
  template <class Int>
  Int process_data() const noexcept {
    return process_data<Int>(number());
  }
  /// The same where number() is @p number.
  template <class Int>
  Int process_data(double number) const noexcept;

 private:
  /// What makes the parameter, in its own unit, of the number.
  enum class Conversion : std::uint8_t {
    None,         ///< it is that
    Unit,         ///< it is in SI units
    RoundedUnit,  ///< the same; a setting, which is read as it was written
  };

  void look_into(const Home& home) noexcept;
  double number_at(std::size_t index) const noexcept {
    if (get_ != nullptr) return get_(place_, index);
    return is_constant() ? 0.0 : object_->value(*placed_, index);
  }
  double parameter(double number) const noexcept {
    if (conversion_ == Conversion::None) return number;
    const double in_unit = number / unit_;
    return conversion_ == Conversion::RoundedUnit ? rounded(in_unit) : in_unit;
  }

  const DriveObject* object_ = nullptr;  ///< of the parameter; none for a constant
  const PlacedRow* placed_ = nullptr;
  double (*get_)(const void* place, std::size_t index) noexcept = nullptr;  ///< if the number lies in a block
  const void* place_ = nullptr;
  std::uint16_t index_ = 0;
  std::uint16_t word_index_ = 0;
  std::uint16_t bit_ = 0;
  Conversion conversion_ = Conversion::None;
  bool is_quantity_ = true;
  double unit_ = 1.0;   ///< of the parameter, in SI units
  double scale_ = 0.0;  ///< 1 / what is 100 %; of a constant the share of 100 %
};

/// What is 100 % of @p quantity on @p object, in SI units; 0 if nothing is.
double reference(const DriveObject& object, Quantity quantity) noexcept;

/// The drive object that the connector or binector input of @p own with @p source is connected to, or nullptr.
const DriveObject* connected_object(const DriveUnit& unit, const DriveObject& own,
                                    const BicoSource& source) noexcept;

}  // namespace drive
