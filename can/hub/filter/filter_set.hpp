#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <linux/can.h>

namespace hub {

/// Data and remote frames of the standard format, a bit each, at their standard_number().
using StandardFrames = std::array<std::uint64_t, 64>;
inline constexpr std::size_t kStandardFrames = std::size_t{2} * (CAN_SFF_MASK + 1);

/// The number of a data or remote frame of the standard format, below kStandardFrames: its identifier, remote
/// frames behind the others.
constexpr std::size_t standard_number(canid_t id) noexcept {
  return (id & CAN_SFF_MASK) + ((id & CAN_RTR_FLAG) != 0 ? CAN_SFF_MASK + 1 : 0);
}

/// Which frames a raw socket wants: CAN_RAW_FILTER, CAN_RAW_ERR_FILTER and CAN_RAW_JOIN_FILTERS, with the meaning
/// that the kernel gives them (net/can/af_can.c, net/can/raw.c).
class FilterSet {
 public:
  /// How many of the extended frames pass, as far as it can be said shortly. Listed: those of exact_extended().
  /// Judged: passes() has to be asked.
  enum class Extended : std::uint8_t { None, Listed, Judged, All };

  /// At first one filter that lets every frame pass, and no error frame.
  FilterSet();

  /// Replaces the filters; none = no frame passes. std::bad_alloc: nothing has changed.
  void assign(std::span<const can_filter> filters);
  /// The filters as they were given.
  [[nodiscard]] std::span<const can_filter> filters() const noexcept { return given_; }
  /// Classes of errors (CAN_ERR_MASK) whose frames pass.
  void set_error_mask(std::uint32_t mask) noexcept { error_mask_ = mask & CAN_ERR_MASK; }
  /// True: a frame must pass all filters, not just one of them.
  void set_joined(bool joined) noexcept { joined_ = joined; }

  /// True if a frame with @p id, flags included, passes.
  [[nodiscard]] bool passes(canid_t id) const noexcept;

  // The same for many frames at a time.

  /// The standard frames that pass.
  [[nodiscard]] StandardFrames standard() const noexcept;
  [[nodiscard]] Extended extended() const noexcept;
  /// If these are Extended::Listed, the identifiers with flags of all that pass; std::bad_alloc.
  [[nodiscard]] std::vector<canid_t> exact_extended() const;
  /// False if no error frame can pass.
  [[nodiscard]] bool takes_errors() const noexcept;

 private:
  /// A filter in the form in which it is compared.
  struct Rule {
    canid_t id;
    canid_t mask;
    bool inverted;
    bool for_errors;  ///< looks at error frames, and at nothing else
  };

  static Rule prepare(const can_filter& filter) noexcept;
  [[nodiscard]] static bool matches(const Rule& rule, canid_t id) noexcept;
  [[nodiscard]] static StandardFrames standard(const Rule& rule) noexcept;
  [[nodiscard]] static Extended extended(const Rule& rule) noexcept;

  std::vector<can_filter> given_;
  std::vector<Rule> rules_;
  std::uint32_t error_mask_ = 0;
  bool joined_ = false;
};

}  // namespace hub
