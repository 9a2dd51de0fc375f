#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace modbus {

/// The registers through which records (DS47) are carried: control, function with length, and data. A request is
/// written behind them and runs when 1 is written to the control; the answer takes its place. Registers are
/// counted from 0 here, which is the control.
class RecordMailbox {
 public:
  static constexpr std::size_t kDataRegisters = 120;
  static constexpr std::size_t kRegisters = 2 + kDataRegisters;
  static constexpr std::size_t kMostBytes = 2 * kDataRegisters;

  /// What the control reads.
  enum class Control : std::uint16_t {
    Idle = 0,
    Active = 1,  ///< a request runs; written: carry the request out
    Done = 2     ///< the answer is there, or the error
  };
  /// What the first word of data reads if there is no answer.
  enum class Error : std::uint16_t {
    WrongLength = 1,
    WrongState = 2,  ///< a request runs already
    WrongFunction = 3,
    NotReady = 4,
    Internal = 5
  };

  /// The value of register @p place.
  std::uint16_t read(std::size_t place) const noexcept;
  /// Writes registers from @p first on, as far as there are some.
  void write(std::size_t first, std::span<const std::uint16_t> values) noexcept;

  /// Whether a request is to be carried out.
  bool is_pending() const noexcept { return is_pending_; }
  /// That request.
  std::span<const std::uint8_t> request() const noexcept { return std::span{request_}.first(request_bytes_); }
  /// The request has led to @p answer; none: it could not be carried out.
  void finish(std::span<const std::uint8_t> answer) noexcept;

 private:
  void activate() noexcept;
  void show(Control control, std::size_t bytes) noexcept;
  void show(Control control, Error error) noexcept;

  std::array<std::uint16_t, kRegisters> registers_{};
  std::array<std::uint8_t, kMostBytes> request_{};
  std::size_t request_bytes_ = 0;
  bool is_pending_ = false;
  bool was_busy_ = false;  ///< another request was refused while this one runs
};

}  // namespace modbus
