#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eds {

/// How grave a finding is: an error breaks CiA 306 or CiA 301, a warning is unusual or outdated.
enum class Severity : std::uint8_t { Error, Warning };

/// Where something stands in a file.
struct Place {
  std::string_view section{};  ///< empty before the first section
  std::string_view key{};      ///< empty where the section or a whole line is meant
  unsigned line = 0;           ///< from 1; 0 where there is no line, as for what is missing in the whole file
};

/// Something in a file that is not as it should be. All texts are printable UTF-8.
struct Finding {
  Severity severity = Severity::Error;
  std::string_view check{};  ///< short stable word, listed in docs/reference/eds-checks.md
  std::string file{};
  unsigned line = 0;  ///< as in Place
  std::string section{};
  std::string key{};
  std::string expected{};
  std::string found{};

  friend bool operator==(const Finding&, const Finding&) = default;
};

/// One line: "FILE:LINE: error: [SECTION] KEY: expected E, got F (check)"; what is not there is left out.
[[nodiscard]] std::string to_text(const Finding& finding);

/// @p text as printable UTF-8: control characters as \xNN, bytes that are not UTF-8 taken as Latin-1, and cut
/// after some 120 characters.
[[nodiscard]] std::string printable(std::string_view text);

/// Collects what is found in one file.
class Findings {
 public:
  /// @p file is the name that every finding bears.
  explicit Findings(std::string file) : file_{std::move(file)} {}

  /// Something that breaks a rule.
  void error(std::string_view check, const Place& place, std::string_view expected, std::string_view found) {
    add(Severity::Error, check, place, expected, found);
  }
  /// Something unusual.
  void warning(std::string_view check, const Place& place, std::string_view expected, std::string_view found) {
    add(Severity::Warning, check, place, expected, found);
  }
  /// A finding of a severity that a table gives.
  void add(Severity severity, std::string_view check, const Place& place, std::string_view expected,
           std::string_view found);

  [[nodiscard]] const std::vector<Finding>& all() const& noexcept { return all_; }
  [[nodiscard]] std::vector<Finding> all() && noexcept { return std::move(all_); }
  /// True when nothing was found.
  [[nodiscard]] bool empty() const noexcept { return all_.empty(); }
  /// True when an error was found.
  [[nodiscard]] bool has_error() const noexcept;
  /// Orders the findings by line; those of a line stay in the order in which they came.
  void sort();

 private:
  std::string file_{};
  std::vector<Finding> all_;
};

}  // namespace eds
