#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace farm {

/// What the agent of a host tells of itself.
struct AgentBeat {
  std::string host{};
  std::uint64_t instance = 0;        ///< tells it from others that use the name of the host
  std::string version{};             ///< of the program
  std::string since{};               ///< when it was started, UTC in the form of ISO 8601; empty: unknown
  std::vector<std::string> buses{};  ///< whose units it takes; empty: those of all
  std::uint32_t capacity = 1;        ///< units that are its fair share
  std::uint32_t units = 0;           ///< that it runs
  bool draining = false;             ///< gives its units away
  std::uint64_t sent_ms = 0;         ///< when, by a clock of its own (ms)

  friend bool operator==(const AgentBeat&, const AgentBeat&) = default;
};

inline constexpr std::uint32_t kGreatestCapacity = 1'000'000;

/// Reads @p text, which came at @p subject; the error is one line.
[[nodiscard]] tl::expected<AgentBeat, std::string> parse_agent_beat(std::string_view subject,
                                                                    std::string_view text);
[[nodiscard]] std::string text_of(const AgentBeat& beat);

}  // namespace farm
