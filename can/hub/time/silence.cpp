#include "can/hub/time/silence.hpp"

#include <fstream>

#include <fmt/format.h>

namespace hub {

namespace {

/// The letter of the state of a process (proc_pid_stat(5)); '?' if it has none.
char state_of(pid_t process) {
  std::ifstream file{fmt::format("/proc/{}/stat", process)};
  std::string text;
  std::getline(file, text);
  const std::size_t name_end = text.rfind(')');
  constexpr std::size_t kToState = 2;
  return name_end == std::string::npos || name_end + kToState >= text.size() ? '?' : text[name_end + kToState];
}

const char* meaning_of(char state) noexcept {
  switch (state) {
    case 'T':
    case 't':
      return "is stopped";
    case 'R':
      return "computes";
    case '?':
    case 'Z':
      return "has ended";
    default:
      return "waits for something else than the bus's time";
  }
}

}  // namespace

std::string describe_silent(pid_t process) {
  std::ifstream file{fmt::format("/proc/{}/comm", process)};
  std::string name;
  std::getline(file, name);
  return fmt::format("{} (process {}), which {}", name.empty() ? "a program" : name, process,
                     meaning_of(state_of(process)));
}

}  // namespace hub
