#include "eds/sheet/field_reader.hpp"

#include <fmt/format.h>

#include "eds/document/encoding.hpp"
#include "text/number.hpp"

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

template <class T>
Stated<T> FieldReader::without_comment(const Line& line) const {
  Stated<T> result{.section = &section_, .line = &line, .value = {}};
  const std::size_t semicolon = line.value().find(';');
  if (semicolon == std::string_view::npos) return result;
  findings_.warning("comment-place", result.place(), "a comment on a line of its own", line.value());
  result.before_comment = trimmed(line.value().substr(0, semicolon));
  return result.before_comment.empty() ? Stated<T>{} : result;
}

Stated<std::string_view> FieldReader::word(std::string_view key) const {
  const Line* const line = stated_line(section_, key);
  if (line == nullptr) return {};
  auto result = without_comment<std::string_view>(*line);
  if (result.stated()) result.value = result.text();
  return result;
}

Stated<std::uint64_t> FieldReader::number(std::string_view key, std::uint64_t highest) const {
  const Line* const line = stated_line(section_, key);
  return line == nullptr ? Stated<std::uint64_t>{} : number(*line, highest);
}

Stated<std::uint64_t> FieldReader::number(const Line& line, std::uint64_t highest) const {
  auto result = without_comment<std::uint64_t>(line);
  if (!result.stated()) return result;
  const auto read = parse_integer(result.text());
  if (!read || read->node_relative) {
    findings_.error("number-form", result.place(), "a decimal, 0x hexadecimal or 0 octal number", result.text());
  } else if (read->value.negative || read->value.magnitude > highest) {
    findings_.error("number-range", result.place(), fmt::format("0 to {}", highest), result.text());
  } else {
    result.value = read->value.magnitude;
  }
  return result;
}

Stated<bool> FieldReader::boolean(std::string_view key) const {
  const auto read = number(key, 1);
  return {.section = read.section,
          .line = read.line,
          .value = read ? std::optional{*read != 0} : std::nullopt,
          .before_comment = read.before_comment};
}

Stated<Value> FieldReader::value(std::string_view key, const DataTypeRow* type) const {
  const Line* const line = stated_line(section_, key);
  return line == nullptr ? Stated<Value>{} : value(*line, type);
}

Stated<Value> FieldReader::value(const Line& line, const DataTypeRow* type) const {
  if (type == nullptr || type->kind == ValueKind::Text) {
    Stated<Value> result{.section = &section_, .line = &line, .value = {}};
    if (type != nullptr)
      result.value = Value{.kind = type->kind, .integer = {}, .text = std::string{line.value()}};
    return result;
  }
  auto result = without_comment<Value>(line);
  if (!result.stated()) return result;
  auto read = parse_value(result.text(), *type, nodes_);
  if (read) {
    result.value = *std::move(read);
  } else {
    findings_.error(read.error().out_of_range ? "value-range" : "value-form", result.place(),
                    read.error().expected, result.text());
  }
  return result;
}

std::optional<std::uint64_t> entry_number(std::string_view key) noexcept {
  const auto number = text::integer<std::uint64_t>(key);
  return number != 0U ? number : std::nullopt;
}

}  // namespace eds
