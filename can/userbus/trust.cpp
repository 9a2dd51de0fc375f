#include "can/userbus/trust.hpp"

#include <cstdlib>

#include <sys/socket.h>
#include <unistd.h>

namespace userbus {

namespace {

/// The user of $CAN_BUS_USER; false if it names none.
bool named_user(uid_t& user) noexcept {
  constexpr int kDecimal = 10;
  const char* const text = secure_getenv("CAN_BUS_USER");
  if (text == nullptr || *text < '0' || *text > '9') return false;
  char* end = nullptr;
  const unsigned long number = strtoul(text, &end, kDecimal);
  user = static_cast<uid_t>(number);
  return *end == '\0' && user == number;
}

}  // namespace

bool is_trusted_user(uid_t user) noexcept {
  uid_t named = 0;
  return user == geteuid() || user == 0 || (named_user(named) && user == named);
}

bool is_trusted_peer(int descriptor) noexcept {
  ucred peer{};
  socklen_t size = sizeof peer;
  return getsockopt(descriptor, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && is_trusted_user(peer.uid);
}

}  // namespace userbus
