#pragma once

#include <optional>
#include <string_view>

#include "eds/document/document.hpp"

namespace eds {

/// What an entry of a file states: where it stands, and its value where it is well formed. An entry with an empty
/// value states nothing. Points into the document.
template <class T>
struct Stated {
  const Section* section = nullptr;
  const Line* line = nullptr;  ///< null where nothing is stated
  std::optional<T> value{};
  std::string_view before_comment{};  ///< the text where a comment stands behind it; else empty

  /// True when the file says something, well formed or not.
  [[nodiscard]] bool stated() const noexcept { return line != nullptr; }
  /// True when there is a value.
  explicit operator bool() const noexcept { return value.has_value(); }
  const T& operator*() const { return *value; }
  const T* operator->() const { return &*value; }
  /// The value, or @p otherwise.
  [[nodiscard]] T value_or(T otherwise) const { return value.value_or(std::move(otherwise)); }
  /// As written, without a comment behind it; empty where nothing is stated.
  [[nodiscard]] std::string_view text() const noexcept {
    if (line == nullptr || !before_comment.empty()) return before_comment;
    return line->value();
  }
  /// Where it stands; for what is stated only.
  [[nodiscard]] Place place() const noexcept {
    return {.section = section->name(), .key = line->key(), .line = line->number()};
  }
};

}  // namespace eds
