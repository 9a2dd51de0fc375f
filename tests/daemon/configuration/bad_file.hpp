#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "tests/daemon/configuration/parse.hpp"

namespace axisd {

/// What the key "interface" and the option of that name take.
inline const std::string kForms =
    "a name of 1 to 15 characters without spaces, unix:PATH, udp-multicast://GROUP:PORT[?interface=NAME] or "
    "socketcand://HOST:PORT/NAME";

/// The message of the ConfigurationError that @p read throws.
template <class Read>
std::string message_of(const Read& read) {
  try {
    read();
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "accepted";
}

/// Text of a configuration file and the whole message it earns.
struct BadFile {
  std::string_view text;
  std::string message;
};
/// How GoogleTest names a case, and this function.
// NOLINTNEXTLINE(readability-identifier-naming)
inline void PrintTo(const BadFile& c, std::ostream* out) {
  *out << c.message;
}

}  // namespace axisd
