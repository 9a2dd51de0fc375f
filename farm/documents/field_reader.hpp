#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace farm {

/// The members of a document, one by one. What is wrong first is kept, as one line: "line1.5: host: expected ...,
/// got 5"; what is asked for afterwards is empty.
class FieldReader {
 public:
  /// Reads @p text, which is the document @p subject.
  FieldReader(std::string_view subject, std::string_view text);
  /// Reads @p object, which is a part of the document @p subject.
  FieldReader(std::string subject, const nlohmann::json& object);

  /// Refuses members other than @p known.
  void allow_only(std::initializer_list<std::string_view> known);
  [[nodiscard]] bool has(const char* key) const { return object_.contains(key); }

  /// A whole number @p low to @p high; @p absent if there is none.
  [[nodiscard]] std::uint64_t number(const char* key, std::uint64_t low, std::uint64_t high, std::uint64_t absent);
  /// The same, which must be there.
  [[nodiscard]] std::uint64_t number(const char* key, std::uint64_t low, std::uint64_t high);
  /// True or false; @p absent if there is none.
  [[nodiscard]] bool flag(const char* key, bool absent);
  /// A text in one line, empty if there is none.
  [[nodiscard]] std::string text(const char* key);
  /// The name of a host; empty if there is none.
  [[nodiscard]] std::string name(const char* key);
  /// One name or a list of them; none if there is no such member.
  [[nodiscard]] std::vector<std::string> names(const char* key);
  /// An object, which must be there.
  [[nodiscard]] nlohmann::json object(const char* key);
  /// The objects of a list, each read as a part of this document; none if there is no such member.
  [[nodiscard]] std::vector<nlohmann::json> objects(const char* key);

  /// Keeps "SUBJECT: PATH: expected EXPECTED, got GOT" if nothing was wrong before.
  void fail(std::string_view path, std::string_view expected, const nlohmann::json& got);
  /// Keeps @p error, of a part, likewise.
  void take(const std::string& error);

  /// @p value, or what was wrong.
  template <class Value>
  [[nodiscard]] tl::expected<Value, std::string> result(Value value) {
    if (error_.empty()) return value;
    return tl::unexpected{std::move(error_)};
  }

 private:
  [[nodiscard]] const nlohmann::json* member(const char* key) const;

  std::string subject_;
  nlohmann::json object_ = nlohmann::json::object();
  std::string error_;
};

}  // namespace farm
