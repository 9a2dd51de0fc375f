#pragma once

#include <array>
#include <cstdint>

#include "drive/access/parameter_access.hpp"

namespace profidrive {

/// The parameter channel of a telegram (PKW): four words each way, one request at a time about a parameter of the
/// drive object of the telegram.
class ParameterChannel {
 public:
  /// PKE, IND, PWE1, PWE2.
  using Words = std::array<std::uint16_t, 4>;

  /// A channel of drive object @p object without a request.
  constexpr explicit ParameterChannel(std::uint8_t object) noexcept : object_{object} {}

  std::uint8_t object() const noexcept { return object_; }

  /// A controller sends @p request; the answer. A request is carried out on @p access once, when the words change;
  /// while they stay, what is read is read again.
  const Words& exchange(const Words& request, drive::ParameterAccess& access) noexcept;

 private:
  std::uint8_t object_;
  Words request_{};
  Words answer_{};
};

}  // namespace profidrive
