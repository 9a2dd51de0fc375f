#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "eds/document/finding.hpp"
#include "eds/sheet/section_name.hpp"

namespace eds {

/// A key that CiA 306 knows.
struct KnownKey {
  SectionKind section;
  std::string_view key;               ///< "#" at the end stands for a number from 1, "%" for hexadecimal digits
  std::optional<Severity> missing{};  ///< of a finding where it is missing
};

/// Every known key, by section.
[[nodiscard]] std::span<const KnownKey> known_keys() noexcept;

/// True when @p key is what @p row says.
[[nodiscard]] bool is_known(const KnownKey& row, std::string_view key) noexcept;

}  // namespace eds
