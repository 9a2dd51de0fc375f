#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <linux/can.h>

namespace hub {

/// Which frames a raw socket wants: CAN_RAW_FILTER, CAN_RAW_ERR_FILTER and CAN_RAW_JOIN_FILTERS, with the meaning
/// that the kernel gives them (net/can/af_can.c, net/can/raw.c).
class FilterSet {
 public:
  /// At first one filter that lets every frame pass, and no error frame.
  FilterSet();

  /// Replaces the filters; none = no frame passes.
  void assign(std::span<const can_filter> filters);
  /// The filters as they were given.
  [[nodiscard]] std::span<const can_filter> filters() const noexcept { return given_; }
  /// Classes of errors (CAN_ERR_MASK) whose frames pass.
  void set_error_mask(std::uint32_t mask) noexcept { error_mask_ = mask & CAN_ERR_MASK; }
  /// True: a frame must pass all filters, not just one of them.
  void set_joined(bool joined) noexcept { joined_ = joined; }

  /// True if a frame with @p id, flags included, passes.
  [[nodiscard]] bool passes(canid_t id) const noexcept;

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

  std::vector<can_filter> given_;
  std::vector<Rule> rules_;
  std::uint32_t error_mask_ = 0;
  bool joined_ = false;
};

}  // namespace hub
