#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "tools/canrec/frames/transcript.hpp"
#include "tools/canrec/server/inbox.hpp"
#include "tools/canrec/server/store.hpp"

namespace canrec {

/// The messages of a recording, from the first to that which was the last when it was opened; a part at a time is
/// asked of the server.
class Messages {
 public:
  /// Of @p recording in @p store, which outlives this.
  [[nodiscard]] static Expected<Messages> open(Store& store, const Recording& recording);

  /// The next message, whose bytes live until the next call; nothing at the end.
  [[nodiscard]] Expected<std::optional<Message>> next();

 private:
  /// Messages that are asked for at once.
  static constexpr int kBatch = 500;

  Messages(Store& store, const Recording& recording, Inbox inbox)
      : store_{&store},
        name_{recording.name},
        next_{recording.messages == 0 ? recording.last + 1 : recording.first},
        last_{recording.last},
        inbox_{std::move(inbox)} {}

  [[nodiscard]] Expected<void> consume();
  [[nodiscard]] Expected<void> ask();
  [[nodiscard]] Expected<void> take_status(natsMsg* message);
  [[nodiscard]] Expected<std::optional<Message>> taken(natsMsg* message);
  [[nodiscard]] Expected<std::string_view> header(natsMsg* message, const char* name) const;

  Store* store_;
  std::string name_;
  std::uint64_t next_;  ///< sequence of the message that is wanted next
  std::uint64_t last_;
  Inbox inbox_;
  std::string consumer_;  ///< empty: none
  int coming_ = 0;        ///< messages that the server was asked for and that have not come
};

}  // namespace canrec
