#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "tools/canopen-check/core/check.hpp"

namespace conformance {

/// Entries of the dictionary: every one from one index to another, of every one from one sub-index to another.
struct ObjectRange {
  std::uint16_t first = 0, last = 0xFFFF;
  std::uint8_t first_sub = 0, last_sub = 0xFF;

  /// True where @p subject lies within; objects 6000h to 67FFh stand for those of every axis, 800h apart.
  [[nodiscard]] bool contains(const Subject& subject) const noexcept;
};

/// Reads "1003h", "1400h-15C7h:02", "1003h:02-52", several separated by commas; nothing if it is none.
[[nodiscard]] std::optional<std::vector<ObjectRange>> parse_objects(std::string_view text);

/// A difference from the standard that the maker of the device has stated.
struct Deviation {
  std::string check{};                 ///< id
  std::vector<ObjectRange> objects{};  ///< none: every finding of the check
  std::string reason{};
  std::string source{};
  bool seen = false;

  [[nodiscard]] bool covers(const Finding& finding) const noexcept;
};

/// A list of deviations.
class Deviations {
 public:
  /// Reads the JSON list @p text of {check, reason, source} and, where only some objects are meant, "object". The
  /// error says what was wrong, where, and what was expected.
  [[nodiscard]] static tl::expected<Deviations, std::string> parse(std::string_view text);

  /// Marks every finding of @p result that is listed. A check with an entry that none of its findings shows gets
  /// a finding for it.
  void judge(CheckResult& result);
  [[nodiscard]] const std::vector<Deviation>& all() const noexcept { return all_; }

 private:
  std::vector<Deviation> all_;
};

}  // namespace conformance
