#pragma once

#include <memory>
#include <string>
#include <vector>

#include "can/nats/nats_handles.hpp"
#include "can/nats/session.hpp"
#include "tools/canrec/server/recording.hpp"

namespace canrec {

using StreamInfoList = std::unique_ptr<jsStreamInfoList, nats::Destroyer<jsStreamInfoList_Destroy>>;

/// Header of a message with the time stamp of its frames in the log that they come from (ns since 1970).
inline constexpr const char* kLogTimeHeader = "Can-Time";

/// Largest message that a stream of a recording takes that is stopped (bytes): none of a bus is so small.
inline constexpr int kStoppedMessageSize = 1;

/// What the server says of the stream of a recording.
[[nodiscard]] Recording recording_of(const jsStreamInfo& info);

/// The recordings among all streams of a server.
[[nodiscard]] std::vector<Recording> recordings_of(const jsStreamInfoList& list);

/// Whether the recording has begun to follow its bus.
[[nodiscard]] bool is_following(const jsStreamInfo& info) noexcept;

/// Description of the stream of a recording that is made of the frames of @p interface in a log.
[[nodiscard]] std::string description_of_log(const std::string& interface);

/// Gives @p recording, which is of a log, the times of the log in place of those of the server, as far as that
/// tells them.
void read_log_times(const nats::Session& session, Recording& recording);

}  // namespace canrec
