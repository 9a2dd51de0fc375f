#include "tools/canrec/server/inbox.hpp"

#include <memory>

namespace canrec {

Expected<Inbox> Inbox::open(Store& store) {
  Inbox inbox{store};
  natsInbox* subject = nullptr;
  natsStatus status = natsInbox_Create(&subject);
  const std::unique_ptr<natsInbox, nats::Destroyer<natsInbox_Destroy>> owned{subject};
  natsSubscription* made = nullptr;
  if (status == NATS_OK) status = natsConnection_SubscribeSync(&made, store.session().connection.get(), subject);
  inbox.subscription_.reset(made);
  if (status != NATS_OK) return tl::unexpected{store.failure_of(status, {}, {})};
  inbox.subject_ = subject;
  return inbox;
}

Expected<natsMsg*> Inbox::receive() {
  constexpr std::chrono::milliseconds kLimit = Store::kPatience;
  message_.reset();
  natsMsg* message = nullptr;
  const natsStatus status = natsSubscription_NextMsg(&message, subscription_.get(), kLimit.count());
  if (status != NATS_OK) return tl::unexpected{store_->failure_of(status, {}, {})};
  message_.reset(message);
  return message;
}

}  // namespace canrec
