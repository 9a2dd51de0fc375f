#pragma once

#include <string>

#include "tools/canrec/server/store.hpp"

namespace canrec {

/// A subject of our own on a server, to which answers come.
class Inbox {
 public:
  /// On the server of @p store, which outlives this.
  [[nodiscard]] static Expected<Inbox> open(Store& store);

  [[nodiscard]] const std::string& subject() const noexcept { return subject_; }
  /// Waits for the next message, up to Store::kPatience; it lives until the next call.
  [[nodiscard]] Expected<natsMsg*> receive();

 private:
  explicit Inbox(Store& store) noexcept : store_{&store} {}

  Store* store_;
  std::string subject_;
  nats::Subscription subscription_;
  nats::Message message_;
};

}  // namespace canrec
