#include "eds/sheet/field_reader.hpp"

#include <charconv>

#include <fmt/format.h>

namespace eds {
namespace {

/// The entry of @p key, if it says anything.
const Line* stated_line(const Section& section, std::string_view key) {
  const Line* const line = section.find(key);
  return line != nullptr && !line->value().empty() ? line : nullptr;
}

}  // namespace

Stated<std::string_view> FieldReader::text(std::string_view key) const {
  const Line* const line = stated_line(section_, key);
  if (line == nullptr) return {};
  return {.section = &section_, .line = line, .value = line->value()};
}

Stated<std::uint64_t> FieldReader::number(std::string_view key, std::uint64_t highest) const {
  const Line* const line = stated_line(section_, key);
  return line == nullptr ? Stated<std::uint64_t>{} : number(*line, highest);
}

Stated<std::uint64_t> FieldReader::number(const Line& line, std::uint64_t highest) const {
  Stated<std::uint64_t> result{.section = &section_, .line = &line, .value = {}};
  const auto read = parse_integer(line.value());
  if (!read || read->node_relative) {
    findings_.error("number-form", result.place(), "a decimal, 0x hexadecimal or 0 octal number", line.value());
  } else if (read->value.negative || read->value.magnitude > highest) {
    findings_.error("number-range", result.place(), fmt::format("0 to {}", highest), line.value());
  } else {
    result.value = read->value.magnitude;
  }
  return result;
}

Stated<bool> FieldReader::boolean(std::string_view key) const {
  const auto read = number(key, 1);
  return {.section = read.section, .line = read.line, .value = read ? std::optional{*read != 0} : std::nullopt};
}

Stated<Value> FieldReader::value(std::string_view key, const DataTypeRow* type) const {
  const Line* const line = stated_line(section_, key);
  return line == nullptr ? Stated<Value>{} : value(*line, type);
}

Stated<Value> FieldReader::value(const Line& line, const DataTypeRow* type) const {
  Stated<Value> result{.section = &section_, .line = &line, .value = {}};
  if (type == nullptr) return result;
  auto read = parse_value(line.value(), *type);
  if (read) {
    result.value = *std::move(read);
  } else {
    findings_.error(read.error().out_of_range ? "value-range" : "value-form", result.place(),
                    read.error().expected, line.value());
  }
  return result;
}

std::optional<std::uint64_t> entry_number(std::string_view key) noexcept {
  std::uint64_t number = 0;
  const char* const end = key.data() + key.size();
  const auto [stop, error] = std::from_chars(key.data(), end, number);
  if (error != std::errc{} || stop != end || number == 0) return std::nullopt;
  return number;
}

}  // namespace eds
