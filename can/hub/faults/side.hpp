#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "can/hub/medium/interfaces.hpp"
#include "can/hub/medium/medium.hpp"

namespace hub::faults {

/// Some of those who take part in a bus, by the words with which the hub's statistics show them.
class Side {
 public:
  static constexpr std::string_view kRule =
      "process identifiers, kinds (raw, bcm, port, socketcand), interfaces or URLs of bridges, with commas "
      "between";

  /// Nobody.
  Side() = default;
  /// Whom the @p words name; a name of an interface is taken up in @p interfaces.
  Side(std::string_view words, Interfaces& interfaces);

  /// The word of @p words that names nobody there could be.
  static std::optional<std::string> find_wrong(std::string_view words);

  [[nodiscard]] bool has(const Identity& who) const noexcept;

 private:
  std::vector<std::string> names_;
  std::vector<std::int32_t> processes_;
  std::vector<int> interfaces_;
};

}  // namespace hub::faults
