#pragma once

#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "eds/catalogue/catalogue.hpp"

namespace eds {

/// The text of an EDS under construction, a line a call.
class Lines {
 public:
  /// Opens section @p name.
  void section(std::string_view name) { fmt::format_to(end(), "{}[{}]\n", text_.empty() ? "" : "\n", name); }
  /// An entry of the open section.
  template <class T>
  void add(std::string_view key, const T& value) {
    fmt::format_to(end(), "{}={}\n", key, value);
  }
  /// The text so far; nothing may be added afterwards.
  std::string take() { return std::move(text_); }

 private:
  std::back_insert_iterator<std::string> end() { return std::back_inserter(text_); }

  std::string text_;
};

/// The entries of an object description (CiA 306) of @p entry, without the section.
void write_entry(Lines& lines, const Entry& entry);

/// A section @p name that counts @p objects under @p count_key and lists their indices.
void write_index_list(Lines& lines, std::string_view name, std::string_view count_key,
                      std::span<const Object* const> objects);

/// The sections of @p object and its sub-indices; @p prefix stands before the index in their names.
void write_object(Lines& lines, std::string_view prefix, const Object& object);

}  // namespace eds
