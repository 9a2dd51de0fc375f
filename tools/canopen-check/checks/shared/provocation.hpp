#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

/// An emergency message.
struct Emergency {
  TimedFrame frame{};
  std::uint16_t code = 0;
  std::uint8_t error_register = 0;
};

/// The identifier of the node's emergency messages, as 1014h says; nothing while it is invalid, and
/// without 1014h.
[[nodiscard]] std::optional<std::uint32_t> emcy_identifier(Context& context);

/// The next emergency message of the node under @p identifier, or nothing.
[[nodiscard]] std::optional<Emergency> wait_for_emergency(Context& context, std::uint32_t identifier,
                                                          canopen::Duration patience);
/// The next one that tells an error; that a former one has ended may be under way.
[[nodiscard]] std::optional<Emergency> wait_for_error(Context& context, std::uint32_t identifier,
                                                      canopen::Duration patience);
/// The next one with @p code; others are passed over.
[[nodiscard]] std::optional<Emergency> wait_for_code(Context& context, std::uint32_t identifier,
                                                     std::uint16_t code, canopen::Duration patience);
/// The error code in an emergency message.
[[nodiscard]] std::uint16_t code_of(const canopen::Frame& message) noexcept;
/// "8130h, register 11h".
[[nodiscard]] std::string to_text(const Emergency& emergency);

/// A communication error that the tester can bring about, and end. What it writes is restored behind the check.
struct Provocation {
  std::string name{};                ///< "heartbeat of node 127 lost"
  std::uint16_t code = 0;            ///< that CiA 301 has for the error
  canopen::Duration delay{};         ///< from raise() to the error
  std::function<void()> raise = {};  ///< does what leads to the error
  std::function<void()> end = {};    ///< ends its cause; empty if the tester cannot
};

/// After which time without it a heartbeat counts as lost.
inline constexpr std::uint64_t kLossMilliseconds = 100;
inline constexpr canopen::Duration kLossTime = std::chrono::milliseconds{kLossMilliseconds};
/// Guard time (ms) and life time factor: a life time that a node which looks at it every 20 ms keeps.
inline constexpr std::uint64_t kGuardTime = 100, kLifeTimeFactor = 2;
inline constexpr canopen::Duration kLifeTime = std::chrono::milliseconds{kGuardTime * kLifeTimeFactor};

/// Loss of the heartbeat of a node that the tester plays; nothing where 1016h does not take it.
[[nodiscard]] std::optional<Provocation> heartbeat_loss(Context& context);
/// Loss of the guarding master; nothing where the node answers no guarding or 100Ch, 100Dh do not take it.
[[nodiscard]] std::optional<Provocation> guarding_loss(Context& context);
/// A SYNC of unexpected length; nothing without 1019h.
[[nodiscard]] std::optional<Provocation> sync_length(Context& context);
/// An RPDO without data, in Operational; nothing without a valid RPDO. It can be ended if a good RPDO does no
/// harm.
[[nodiscard]] std::optional<Provocation> short_rpdo(Context& context);

/// A way to provoke an error.
using Way = std::optional<Provocation> (*)(Context&);
/// Every way, in the order in which most checks try them.
inline constexpr std::array<Way, 4> kWays{heartbeat_loss, guarding_loss, sync_length, short_rpdo};

/// What has been seen to make the node send an emergency message, and that message.
struct Provoked {
  Way way = nullptr;
  Provocation how{};
  std::uint32_t identifier = 0;  ///< of emergency messages
  Emergency emergency{};
};
/// The first of @p ways for which the node sends an emergency message; the node is reset and they are tried once
/// more if it sends none for any of them, since an error may last. Nothing, and the check is skipped, if that does
/// not help. The error is not ended.
[[nodiscard]] std::optional<Provoked> provoke(Context& context, std::span<const Way> ways);

/// How long an emergency message may take after the error.
inline constexpr canopen::Duration kEmergencyPatience = std::chrono::milliseconds{200};

/// Keeps how long an emergency message took after its error.
void note_latency(Context& context, canopen::Duration latency);
/// How long an emergency message is waited for after the error that must not come: several times as long as one
/// was seen to take, kEmergencyPatience at most and before one was seen.
[[nodiscard]] canopen::Duration emergency_silence(const Context& context);

/// Ends the cause of the error where that is possible, and waits for the emergency message of it.
void end(Context& context, const Provoked& provoked);
/// Brings the error about: the emergency message, or nothing if none comes within @p patience after it.
[[nodiscard]] std::optional<Emergency> bring_about(Context& context, const Provoked& provoked,
                                                   canopen::Duration patience = kEmergencyPatience);

}  // namespace conformance
