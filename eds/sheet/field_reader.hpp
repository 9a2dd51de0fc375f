#pragma once

#include <cstdint>
#include <string_view>

#include "eds/document/finding.hpp"
#include "eds/document/value.hpp"
#include "eds/sheet/stated.hpp"

namespace eds {

/// Reads the entries of one section as what they should be; what is something else becomes a finding.
class FieldReader {
 public:
  FieldReader(const Section& section, Findings& findings, NodeRange nodes = kAnyNode)
      : section_{section}, findings_{findings}, nodes_{nodes} {}

  /// The text of @p key.
  [[nodiscard]] Stated<std::string_view> text(std::string_view key) const;
  /// The same of what is never more than a word, so that a comment may be told from it.
  [[nodiscard]] Stated<std::string_view> word(std::string_view key) const;
  /// A whole number 0 to @p highest, without the node-ID.
  [[nodiscard]] Stated<std::uint64_t> number(std::string_view key, std::uint64_t highest) const;
  /// The same of the entry @p line of the section.
  [[nodiscard]] Stated<std::uint64_t> number(const Line& line, std::uint64_t highest) const;
  /// 0 or 1.
  [[nodiscard]] Stated<bool> boolean(std::string_view key) const;
  /// A value of @p type; stated without a value where @p type is null.
  [[nodiscard]] Stated<Value> value(std::string_view key, const DataTypeRow* type) const;
  /// The same of the entry @p line of the section.
  [[nodiscard]] Stated<Value> value(const Line& line, const DataTypeRow* type) const;

  [[nodiscard]] const Section& section() const noexcept { return section_; }
  [[nodiscard]] Findings& findings() const noexcept { return findings_; }

 private:
  /// What @p line states, before a comment behind it; nothing where that is all.
  template <class T>
  [[nodiscard]] Stated<T> without_comment(const Line& line) const;

  const Section& section_;
  Findings& findings_;
  NodeRange nodes_;
};

/// The number of a numbered entry such as "12": decimal, from 1; nothing for any other key.
[[nodiscard]] std::optional<std::uint64_t> entry_number(std::string_view key) noexcept;

}  // namespace eds
