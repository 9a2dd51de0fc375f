#pragma once

#include <cstdint>
#include <string_view>

namespace audit {

/// How bad it is to break a rule.
enum class Severity : std::uint8_t {
  Warning,  ///< legal, and unwise
  Error,    ///< against the standard, or without the effect that was meant
};

/// The word for @p severity in reports.
constexpr std::string_view word_of(Severity severity) noexcept {
  return severity == Severity::Error ? "error" : "warning";
}

/// Something that a master must not do, or should not.
struct Rule {
  std::string_view id;      ///< "sdo.overlap": stable, in reports and lists of deviations; a topic before the dot
  std::string_view text;    ///< what was done, as a sentence without a full stop
  std::string_view clause;  ///< what says otherwise: "CiA 301 7.2.4.2"
  Severity severity = Severity::Error;
  std::string_view why;   ///< what comes of it
  std::string_view mend;  ///< what the master should do instead
  std::string_view
      example;  ///< frames, a line each as `candump -L` writes them, that break this rule and no other
};

}  // namespace audit
