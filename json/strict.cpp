#include "json/strict.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <fmt/format.h>

namespace json_text {
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

/// A key that an object has twice, as the path to it.
struct Twice {
  std::string path;
};

/// Notices keys that an object has twice while it is parsed.
class KeyWatch {
 public:
  /// What the parser calls; throws Twice at a key that is there already.
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
    throw Twice{path()};
  }
  std::string path() const {
    std::string path;
    for (const Level& level : levels_)
      path += "/" + (level.array ? std::to_string(level.values - 1) : quoted_key(level.key));
    return path;
  }

  std::vector<Level> levels_;
};

}  // namespace

tl::expected<nlohmann::json, std::string> parse(std::string_view text) {
  if (const auto at = find_too_deep(text, kDeepestFile))
    return tl::unexpected{fmt::format("{}: expected at most {} levels of objects and arrays",
                                      position_of(text, *at + 1), kDeepestFile)};
  try {
    KeyWatch watch;
    const auto on_event = [&watch](int, nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
      return watch(event, parsed);
    };
    return nlohmann::json::parse(text, on_event);
  } catch (const Twice& twice) {
    return tl::unexpected{twice.path + ": expected once, is there twice"};
  } catch (const nlohmann::json::parse_error& error) {
    return tl::unexpected{position_of(text, error.byte) + ": expected valid JSON"};
  } catch (const nlohmann::json::out_of_range&) {
    return tl::unexpected{std::string{"expected valid JSON, got a number that is too large"}};
  }
}

std::string quote(const nlohmann::json& value) {
  std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (text.size() > kLongestQuote) text = text.substr(0, kLongestQuote) + "...";
  return text;
}

std::string quoted_key(const std::string& key) {
  const std::string quoted = quote(nlohmann::json(key));
  return quoted.substr(1, quoted.size() - 2);
}

}  // namespace json_text
