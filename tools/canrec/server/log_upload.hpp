#pragma once

#include <cstdint>
#include <string>

#include "can/hub/trunk/message.hpp"
#include "tools/canrec/frames/frame_source.hpp"
#include "tools/canrec/server/inbox.hpp"
#include "tools/canrec/server/store.hpp"

namespace canrec {

/// Publishes the frames of a log to a recording, as messages of one hub that has sent them all: frames of one time
/// stamp are one message.
class LogUpload {
 public:
  /// To the recording @p name of @p store, which outlives this.
  [[nodiscard]] static Expected<LogUpload> open(Store& store, const std::string& name);

  [[nodiscard]] Expected<void> add(const TimedFrame& frame);
  /// Sends the rest, and waits until the server has taken all.
  [[nodiscard]] Expected<void> finish();
  [[nodiscard]] std::uint64_t frames() const noexcept { return counter_ - 1; }

 private:
  LogUpload(Store& store, std::string name, Inbox inbox)
      : store_{&store}, name_{std::move(name)}, inbox_{std::move(inbox)} {}

  [[nodiscard]] Expected<void> send();
  [[nodiscard]] Expected<void> confirm();

  Store* store_;
  std::string name_;
  Inbox inbox_;
  hub::trunk::Writer writer_;
  std::chrono::nanoseconds at_{};  ///< of the frames in the message
  std::uint64_t counter_ = 1;      ///< number of the next frame
  int pending_ = 0;                ///< messages that the server has not confirmed
};

}  // namespace canrec
