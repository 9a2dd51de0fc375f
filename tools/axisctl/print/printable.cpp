#include "tools/axisctl/print/printable.hpp"

#include <fmt/format.h>

namespace axisctl {
namespace {

constexpr unsigned char kFirstPrintable = 0x20, kDelete = 0x7F;
/// First byte of U+0080 to U+00BF in UTF-8, and the second byte of the last C1 control.
constexpr unsigned char kLatinLead = 0xC2, kLastC1 = 0x9F, kFirstC1 = 0x80;

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const auto next = static_cast<unsigned char>(at + 1 < text.size() ? text[at + 1] : '\0');
    if (byte < kFirstPrintable || byte == kDelete) {
      result += fmt::format("\\u{:04x}", byte);
    } else if (byte == kLatinLead && next >= kFirstC1 && next <= kLastC1) {
      result += fmt::format("\\u{:04x}", next);
      ++at;
    } else {
      result += text[at];
    }
  }
  return result;
}

nlohmann::json printable_values(const nlohmann::json& value) {
  if (value.is_string()) return printable(value.get_ref<const std::string&>());
  if (value.is_array()) {
    nlohmann::json array = nlohmann::json::array();
    for (const nlohmann::json& element : value) array.push_back(printable_values(element));
    return array;
  }
  if (!value.is_object()) return value;
  nlohmann::json object = nlohmann::json::object();
  for (const auto& item : value.items()) object[printable(item.key())] = printable_values(item.value());
  return object;
}

}  // namespace axisctl
