#include "daemon/configuration/json_reader.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "daemon/configuration/configuration.hpp"

namespace axisd {
namespace {

constexpr std::size_t kLongestQuote = 60;

/// Levels of objects and arrays that a file may have; values are copied and printed by recursion.
constexpr std::size_t kDeepestFile = 32;

/// Offset of the first bracket in the JSON @p text that opens a level beyond @p deepest, if there is one.
constexpr std::optional<std::size_t> find_too_deep(std::string_view text, std::size_t deepest) noexcept {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (in_string) {
      if (c == '\\') ++at;
      in_string = c != '"';
    } else if (c == '{' || c == '[') {
      if (++depth > deepest) return at;
    } else if (c == '}' || c == ']') {
      if (depth != 0) --depth;
    } else {
      in_string = c == '"';
    }
  }
  return std::nullopt;
}

/// "line 3, column 7" of byte @p offset, which counts from 1.
std::string position_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(text.size(), offset == 0 ? 0 : offset - 1));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0: the first line
  return fmt::format("line {}, column {}", line, before.size() - line_start + 1);
}

std::string quote(const nlohmann::json& value) {
  std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (text.size() > kLongestQuote) text = text.substr(0, kLongestQuote) + "...";
  return text;
}

/// @p key in a path: whatever it holds, the message is one line.
std::string quoted_key(const std::string& key) {
  const std::string quoted = quote(nlohmann::json(key));
  return quoted.substr(1, quoted.size() - 2);
}

/// Notices keys that an object has twice while it is parsed.
class KeyWatch {
 public:
  explicit KeyWatch(const std::string& file) : file_{file} {}

  /// What the parser calls; throws ConfigurationError at a key that is there already.
  bool operator()(nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    switch (event) {
      case Event::object_start:
      case Event::array_start:
        count();
        levels_.push_back({.array = event == Event::array_start});
        break;
      case Event::object_end:
      case Event::array_end:
        levels_.pop_back();
        break;
      case Event::key:
        see(parsed);
        break;
      case Event::value:
        count();
        break;
    }
    return true;
  }

 private:
  /// An object or array that is not yet at its end.
  struct Level {
    bool array = false;
    std::size_t values = 0;  // of an array
    std::string key{};       // of an object, the last one
    std::set<std::string> keys{};
  };

  void count() {
    if (!levels_.empty() && levels_.back().array) ++levels_.back().values;
  }
  void see(const nlohmann::json& key) {
    Level& level = levels_.back();
    level.key = key.get<std::string>();
    if (level.keys.insert(level.key).second) return;
    throw ConfigurationError{fmt::format("{}: {}: expected once, is there twice", file_, path())};
  }
  std::string path() const {
    std::string path;
    for (const Level& level : levels_)
      path += "/" + (level.array ? std::to_string(level.values - 1) : quoted_key(level.key));
    return path;
  }

  const std::string& file_;
  std::vector<Level> levels_;
};

}  // namespace

JsonReader JsonReader::parse(std::string_view text, const std::string& file) {
  if (const auto at = find_too_deep(text, kDeepestFile))
    throw ConfigurationError{fmt::format("{}: {}: expected at most {} levels of objects and arrays", file,
                                         position_of(text, *at + 1), kDeepestFile)};
  try {
    KeyWatch watch{file};
    const auto on_event = [&watch](int, nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
      return watch(event, parsed);
    };
    return JsonReader{nlohmann::json::parse(text, on_event), file, ""};
  } catch (const nlohmann::json::parse_error& error) {
    throw ConfigurationError{fmt::format("{}: {}: expected valid JSON", file, position_of(text, error.byte))};
  } catch (const nlohmann::json::out_of_range&) {
    throw ConfigurationError{fmt::format("{}: expected valid JSON, got a number that is too large", file)};
  }
}

std::string JsonReader::place() const {
  return file_ + ": " + (path_.empty() ? "/" : path_);
}

void JsonReader::fail(const std::string& expected) const {
  throw ConfigurationError{fmt::format("{}: expected {}, got {}", place(), expected, quote(value_))};
}

void JsonReader::fail_below(const std::string& path, const std::string& expected) const {
  throw ConfigurationError{fmt::format("{}: {}/{}: expected {}", file_, path_, quoted_key(path), expected)};
}

void JsonReader::expect_object(std::span<const std::string_view> keys) const {
  if (!value_.is_object()) fail("an object");
  for (const auto& item : value_.items()) {
    if (std::find(keys.begin(), keys.end(), item.key()) != keys.end()) continue;
    throw ConfigurationError{fmt::format("{}/{}: unknown key, expected one of: {}", file_ + ": " + path_,
                                         quoted_key(item.key()), fmt::join(keys, ", "))};
  }
}

void JsonReader::expect_array(std::size_t low, std::size_t high) const {
  if (value_.is_array() && value_.size() >= low && value_.size() <= high) return;
  fail(low == high ? fmt::format("an array of {}", low) : fmt::format("an array of {} to {}", low, high));
}

JsonReader JsonReader::at(const std::string& key) const {
  return {value_.at(key), file_, path_ + "/" + key};
}

JsonReader JsonReader::at(std::size_t position) const {
  return {value_.at(position), file_, path_ + "/" + std::to_string(position)};
}

std::vector<std::string> JsonReader::keys() const {
  std::vector<std::string> keys;
  for (const auto& item : value_.items()) keys.push_back(item.key());
  return keys;
}

std::string JsonReader::text() const {
  if (!value_.is_string()) fail("a string");
  return value_.get<std::string>();
}

bool JsonReader::boolean() const {
  if (!value_.is_boolean()) fail("true or false");
  return value_.get<bool>();
}

int JsonReader::integer(int low, int high) const {
  const bool fits = value_.is_number_integer() && value_ >= low && value_ <= high;
  if (!fits) fail(fmt::format("an integer {} to {}", low, high));
  return value_.get<int>();
}

double JsonReader::number(double low, double high) const {
  const bool fits = value_.is_number() && value_.get<double>() >= low && value_.get<double>() <= high;
  if (!fits) {
    if (std::isinf(low)) fail("a number");
    fail(std::isinf(high) ? fmt::format("a number not below {}", low)
                          : fmt::format("a number {} to {}", low, high));
  }
  return value_.get<double>();
}

}  // namespace axisd
