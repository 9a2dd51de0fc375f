#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "audit/network/network.hpp"
#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/object_index.hpp"

namespace audit {

/// The records of a PDO: communication and mapping.
struct PdoRecord {
  bool is_receive = false;
  std::uint16_t number = 1;  ///< from 1

  [[nodiscard]] constexpr std::uint16_t communication() const noexcept {
    return static_cast<std::uint16_t>(
        (is_receive ? canopen::object::kRpdoParameter : canopen::object::kTpdoParameter) + number - 1);
  }
  [[nodiscard]] constexpr std::uint16_t mapping() const noexcept {
    return static_cast<std::uint16_t>(
        (is_receive ? canopen::object::kRpdoMapping : canopen::object::kTpdoMapping) + number - 1);
  }
  friend constexpr auto operator<=>(const PdoRecord&, const PdoRecord&) = default;
};

/// The PDO that @p index is a record of; nothing for other objects.
[[nodiscard]] std::optional<PdoRecord> pdo_at(std::uint16_t index) noexcept;
/// "RPDO 1".
[[nodiscard]] std::string name_of(const PdoRecord& record);

/// Sub-indices of the communication record.
inline constexpr std::uint8_t kCobIdSub = 1, kTypeSub = 2, kInhibitSub = 3;

/// Whether @p node is known to have the PDO in use; nothing: not known.
[[nodiscard]] std::optional<bool> is_valid(const Node& node, const PdoRecord& record);

/// An object in a PDO.
struct MappedObject {
  canopen::sdo::Address at{};
  unsigned first_bit = 0;
  unsigned bits = 0;
};

/// How many bytes a PDO of @p objects has.
[[nodiscard]] unsigned bytes_of(const std::vector<MappedObject>& objects) noexcept;

/// What is mapped; nothing if that is not known as a whole.
[[nodiscard]] std::optional<std::vector<MappedObject>> mapping_of(const Node& node, const PdoRecord& record);

}  // namespace audit
