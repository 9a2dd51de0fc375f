#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <tl/expected.hpp>

#include "drive/drive_unit.hpp"

namespace drive {

/// What an access to a parameter leads to outside the drive unit.
class AccessListener {
 public:
  virtual ~AccessListener() = default;
  /// Whether nothing may be written now (a save runs).
  virtual bool is_locked() const noexcept { return false; }
  /// A parameter is about to be read or written: time is told.
  virtual void on_access() noexcept {}
  /// Parameter @p number of drive object @p object was written. What follows from that beyond the drive object
  /// waits until the answer is out.
  virtual void on_written(std::uint8_t object, std::uint16_t number) noexcept {
    static_cast<void>(object), static_cast<void>(number);
  }
};

struct FoundParameter;

/// Whoever wants to know what is written.
class WriteObserver {
 public:
  virtual ~WriteObserver() = default;
  /// @p parameter was @p before and was set to @p value, both in its own unit.
  virtual void on_write(const FoundParameter& parameter, double before, double value) noexcept = 0;
};

/// What somebody asks for: it need not exist.
struct ParameterAddress {
  std::uint8_t object = 0;  ///< number of the drive object
  std::uint16_t number = 0;
  std::size_t index = 0;
};

/// An index of a parameter of a drive object.
struct FoundParameter {
  DriveObject& object;
  const PlacedRow& placed;
  std::size_t index;

  const ParameterRow& row() const noexcept { return *placed.row; }
};

/// A value on its way to a parameter.
struct TransferredValue {
  std::uint32_t bits = 0;          ///< the lowest `size` bytes count
  std::size_t size = 0;            ///< bytes
  std::optional<DataType> type{};  ///< nothing: any type of that size
};

/// Whether @p value is one of the type of @p row. A BICO source is a U32 too.
constexpr bool fits(const TransferredValue& value, const ParameterRow& row) noexcept {
  if (value.size != row_of(row.type).size) return false;
  return !value.type || *value.type == row.type || (*value.type == DataType::U32 && is_bico_input(row.type));
}

/// Whence a write comes, as far as p0927 can take the right to it away.
enum class Door : std::uint8_t {
  Any,      ///< one that p0927 does not name: the CAN bus, the control socket
  Record,   ///< acyclic: DS47, registers
  Channel,  ///< PKW
};

/// The one way in which masters read and write parameters, whatever door they come through.
class ParameterAccess {
 public:
  /// Both outlive this.
  ParameterAccess(DriveUnit& unit, AccessListener& listener) noexcept : unit_{unit}, listener_{listener} {}

  /// From now on @p observer, which outlives this, is told of every write that was not refused.
  void observe(WriteObserver& observer) noexcept { observer_ = &observer; }

  bool has_object(std::uint8_t number) const noexcept { return unit_.object(number) != nullptr; }
  /// The parameter that @p address names. NoDriveObject, NoParameter, NotIndexed or NoIndex, in this order.
  [[nodiscard]] tl::expected<FoundParameter, ParameterError> find(const ParameterAddress& address) const noexcept;

  /// What it reads as.
  ParameterValue read(const FoundParameter& parameter) noexcept;
  [[nodiscard]] tl::expected<ParameterValue, ParameterError> read(const ParameterAddress& address) noexcept;

  /// Why nobody may write it now through @p door, whatever the value: ReadOnly, NoAuthority, NotNow while a save
  /// runs, then the state of the drive object.
  std::optional<Refusal> write_refusal(const FoundParameter& parameter, Door door = Door::Any) const noexcept;
  /// Writes it. Refused in this order: ReadOnly, WrongType, as write_refusal(), for the value.
  [[nodiscard]] tl::expected<void, ParameterError> write(const FoundParameter& parameter,
                                                         const TransferredValue& value,
                                                         Door door = Door::Any) noexcept;
  /// The same of a number in the unit of the parameter.
  [[nodiscard]] tl::expected<void, ParameterError> write(const FoundParameter& parameter, double value,
                                                         Door door = Door::Any) noexcept;

 private:
  std::optional<Refusal> door_refusal(const FoundParameter& parameter, Door door) const noexcept;

  DriveUnit& unit_;
  AccessListener& listener_;
  WriteObserver* observer_ = nullptr;
};

}  // namespace drive
