#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace eds {

/// The character code of a text.
enum class Encoding : std::uint8_t {
  Ascii,   ///< what CiA 306 asks for
  Utf8,    ///< valid UTF-8 with characters beyond ASCII
  Latin1,  ///< bytes beyond ASCII that are not UTF-8
};

/// Bytes of the UTF-8 character that @p text begins with; 0 where it begins with none.
[[nodiscard]] std::size_t utf8_length(std::string_view text) noexcept;

/// The code of @p text.
[[nodiscard]] Encoding encoding_of(std::string_view text) noexcept;

/// The Latin-1 character @p byte as UTF-8.
[[nodiscard]] std::string utf8_of_latin1(unsigned char byte);

/// @p text without blanks and tabs at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text) noexcept;

/// @p text with the letters A to Z as a to z, and everything else as it is.
[[nodiscard]] std::string lower_case(std::string_view text);

/// True when the texts differ in the case of the letters A to Z at most.
[[nodiscard]] bool equal_in_any_case(std::string_view one, std::string_view other) noexcept;

/// True when @p text begins with @p prefix in any letter case, which then is taken off.
bool take_in_any_case(std::string_view& text, std::string_view prefix) noexcept;

}  // namespace eds
