#include "can/nats/inbox.hpp"

#include <memory>
#include <new>

#include "can/nats/nats_handles.hpp"
#include "can/nats/tls/openssl.hpp"

namespace nats {

std::string new_inbox() {
  natsInbox* made = nullptr;
  if (!open_openssl() || natsInbox_Create(&made) != NATS_OK) throw std::bad_alloc{};
  const std::unique_ptr<natsInbox, Destroyer<natsInbox_Destroy>> inbox{made};
  return inbox.get();
}

std::string new_nuid() {
  const std::string inbox = new_inbox();
  return inbox.substr(inbox.rfind('.') + 1);
}

}  // namespace nats
