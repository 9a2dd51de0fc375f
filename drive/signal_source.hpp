#pragma once

#include <cstdint>
#include <optional>

#include "drive/drive_unit.hpp"

namespace drive {

/// Where a BICO input gets its value from: a constant, or a parameter of a drive object. It is found once, when
/// the input is connected; the value is then taken without any search.
class SignalSource {
 public:
  /// The constant 0.
  SignalSource() = default;
  /// What the input of @p own that holds @p packed is connected to; a source that does not exist gives 0. Holds
  /// until a reference (p2000 to p2007) or the scaling of a drive object of @p unit changes.
  SignalSource(const DriveUnit& unit, const DriveObject& own, std::uint32_t packed) noexcept;

  /// Whether the value can never change.
  bool is_constant() const noexcept { return object_ == nullptr; }
  /// The value of a binector.
  bool bit() const noexcept;
  /// The value of a connector for an input in which @p full is 100 %: a quantity relative to its reference (p2000
  /// to p2007 of the drive object that it comes from), process data relative to their own 100 %, a number without
  /// unit as it is.
  double value(double full) const noexcept;
  /// The same as a word or double word of process data: a quantity saturates at the ends of @p Int, of a number
  /// the lower bits count.
  template <class Int>
  Int process_data() const noexcept;

 private:
  const DriveObject* object_ = nullptr;  ///< of the parameter; none for a constant
  const PlacedRow* placed_ = nullptr;
  std::uint16_t position_ = 0;
  bool is_quantity_ = true;
  double scale_ = 0.0;  ///< 1 / what is 100 %; of a constant the share of 100 %
};

/// What is 100 % of @p quantity on @p object, in SI units; 0 if nothing is.
double reference(const DriveObject& object, Quantity quantity) noexcept;

/// The drive object that the connector or binector input of @p own with @p source is connected to, or nullptr.
const DriveObject* connected_object(const DriveUnit& unit, const DriveObject& own,
                                    const BicoSource& source) noexcept;

}  // namespace drive
