#include "daemon/control/objects/object_address.hpp"

#include <limits>
#include <optional>

#include <fmt/format.h>

#include "text/number.hpp"

namespace axisd {
namespace {

using nlohmann::json;

constexpr std::string_view kIndex = "index";
constexpr std::string_view kSubIndex = "sub_index";
constexpr int kHexadecimal = 16;

/// A number as it is, a text in hexadecimal.
template <class Number>
std::optional<Number> number_of(std::string_view text) noexcept {
  if (text.starts_with("0x") || text.starts_with("0X")) text.remove_prefix(2);
  if (text.ends_with('h') || text.ends_with('H')) text.remove_suffix(1);
  return text::integer<Number>(text, kHexadecimal);
}
template <class Number>
std::optional<Number> number_of(const json& value) {
  constexpr auto kHighest = std::numeric_limits<Number>::max();
  if (value.is_string()) return number_of<Number>(std::string_view{value.get_ref<const std::string&>()});
  const bool fits = value.is_number_integer() && value >= 0 && value <= kHighest;
  return fits ? std::optional{value.get<Number>()} : std::nullopt;
}

}  // namespace

Taken<ObjectAddress> object_address(const json& params) {
  const Arguments arguments{params};
  const json* index = arguments.find(kIndex);
  const json* const sub_index = arguments.find(kSubIndex);
  json before, behind = 0;
  const auto* const text = index != nullptr ? index->get_ptr<const std::string*>() : nullptr;
  if (const auto colon = text != nullptr ? text->find(':') : std::string::npos;
      colon != std::string::npos && sub_index == nullptr) {
    before = text->substr(0, colon);
    behind = text->substr(colon + 1);
  }
  const auto number =
      index != nullptr ? number_of<std::uint16_t>(before.is_null() ? *index : before) : std::nullopt;
  const auto place = number_of<std::uint8_t>(sub_index != nullptr ? *sub_index : behind);
  if (number && place) return ObjectAddress{*number, *place};
  if (number && sub_index != nullptr)
    return tl::unexpected{unexpected_value(kSubIndex, "0 to 255, or hexadecimal as 0x1F", sub_index)};
  return tl::unexpected{unexpected_value(kIndex, "an object as 6040h, 0x1018 or 1018:04", index)};
}

std::string address_text(const ObjectAddress& address) {
  return fmt::format("{:04X}h:{:02X}", address.index, address.sub_index);
}

}  // namespace axisd
