#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tools/canopen-check/core/sdo_client.hpp"

namespace conformance {

class Context;

/// An error that the tester has brought about, the emergency message of it, and what the node said of the error
/// while that lasted.
struct ToldError {
  std::size_t way = 0;               ///< in which it was brought about
  std::string name{};                ///< "the heartbeat of node 127 is lost"
  std::uint16_t code = 0;            ///< that CiA 301 has for it
  bool ends = false;                 ///< the tester can end it
  std::uint32_t identifier = 0;      ///< of emergency messages
  canopen::Frame message{};          ///< the emergency message
  SdoAnswer error_register{};        ///< 1001h
  std::vector<SdoAnswer> history{};  ///< 1003h: its count, its newest entry, the others that it counts
  std::vector<TimedFrame> traffic{};
};

/// What came of a while in which the client was silent in the middle of an upload in segments.
struct Silence {
  Multiplexor transfer{};
  std::string without_transfer{};          ///< why none was begun; else empty
  std::optional<canopen::Frame> answer{};  ///< of the server, in the middle of it
  SdoAnswer service{};                     ///< the answer to an upload of 1000h behind it
  std::vector<TimedFrame> traffic{};       ///< from the request for the upload on
};

/// What is right, as a check has seen beside its own matter; the check of it does not look once more then.
struct SeenRight {
  bool consumer_begins = false;              ///< error-control.consumer-begins
  bool consumer_return = false;              ///< error-control.consumer-return
  bool life_guarding_begins = false;         ///< error-control.life-guarding-begins
  bool remote_request_forbidden = false;     ///< pdo.remote-request-forbidden
  std::set<canopen::NmtState> no_rpdo_in{};  ///< nmt.no-rpdo-in-pre-operational, nmt.no-rpdo-in-stopped
};

/// A loss of the guarding master that the node has told, and what became of it with the next request.
struct GuardingLoss {
  bool end_is_told = false;
  std::vector<TimedFrame> traffic{};
};

/// What the node was seen to do, and how long it took for it.
struct SeenAtWork {
  bool tells_heartbeat_loss = false;                     ///< by an emergency message
  bool tells_guarding_loss = false;                      ///< likewise
  bool takes_rpdo_at_once = false;                       ///< directly behind Start
  std::optional<canopen::Duration> emergency_latency{};  ///< the longest of an emergency message after its error
  std::optional<canopen::Duration> request_latency{};    ///< the longest of an answer to a remote request
};

/// What a run has found out about the node, so that no later check waits for it once more.
struct Manners {
  bool boots_without_message = false;     ///< it came back from a reset without a boot-up message
  bool sends_no_emergency = false;        ///< none for any error that the tester can bring about
  bool errors_last = false;               ///< an error is not told again until the node is reset
  std::optional<ToldError> told_error{};  ///< what checks of emergency messages share
  std::optional<Silence> silence{};       ///< shared with a check that listens meanwhile
  SeenRight right{};
  std::optional<GuardingLoss> guarding_loss{};
  SeenAtWork at_work{};
  std::set<std::string_view> ahead{};          ///< checks that are still to run
  std::optional<std::uint8_t> free_node_id{};  ///< that no station has
  bool operational_asked = false;              ///< it is known whether it enters Operational
  std::string refuses_operational{};           ///< why it cannot be tested in Operational; empty if it enters it
};

/// Why the node does not enter Operational, with the error that it tells; empty if it does, or if it tells no
/// state. The node may be in any state afterwards.
[[nodiscard]] std::string refusal_of_operational(Context& context);

}  // namespace conformance
