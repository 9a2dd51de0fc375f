// getsockname, if_nametoindex, if_indextoname, if_nameindex: which interface a socket or a number means.
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <net/if.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/descriptor.hpp"
#include "can/preload/hub.hpp"
#include "can/preload/interface.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/address.hpp"
#include "can/preload/socket/state.hpp"

namespace preload {

namespace {

constexpr int kNoMember = -1;
constexpr size_t kMostEntries = userbus::kLongestMessage / sizeof(userbus::InterfaceEntry);

/// The hub's interfaces, for which no hub is started.
struct Interfaces {
  size_t count;
  userbus::InterfaceEntry entries[kMostEntries];
};

void list_interfaces(Interfaces& list) noexcept {
  list.count = 0;
  const int error = errno;
  const int member = join_served_bus();
  if (member >= 0) {
    const userbus::Answer answer =
        ask(member, userbus::Operation::Interfaces, 0, list.entries, sizeof list.entries);
    if (answer.error == 0) list.count = answer.size / sizeof *list.entries;
    next().close(member);
  }
  errno = error;
}

/// Appends the interfaces of @p list to @p real, which it takes over; both are what if_freenameindex(3) expects:
/// names and array from malloc. nullptr with errno if there is no memory.
struct if_nameindex* append(struct if_nameindex* real, const Interfaces& list) noexcept {
  size_t count = 0;
  while (real[count].if_index != 0) ++count;
  auto* const all =
      static_cast<struct if_nameindex*>(realloc(real, (count + list.count + 1) * sizeof(struct if_nameindex)));
  if (all == nullptr) {
    if_freenameindex(real);
    errno = ENOBUFS;
    return nullptr;
  }
  for (size_t i = 0; i < list.count; ++i) {
    const userbus::InterfaceEntry& entry = list.entries[i];
    char* const name = strndup(entry.name, sizeof entry.name);
    if (name == nullptr) break;
    all[count++] = {.if_index = static_cast<unsigned>(entry.index), .if_name = name};
  }
  all[count] = {.if_index = 0, .if_name = nullptr};
  return all;
}

int give_name(int descriptor, const userbus::Name& name, sockaddr* address, socklen_t* length) noexcept {
  if (name.kind == userbus::Kind::BroadcastManager) {
    errno = EOPNOTSUPP;
    return -1;
  }
  const SocketState state = state_or_default(descriptor, name);
  give_address(state.interface_index > 0 ? state.interface_index : 0, address, *length);
  return 0;
}

}  // namespace

}  // namespace preload

using preload::next;

PRELOAD_EXPORT int getsockname(int descriptor, sockaddr* address, socklen_t* length) noexcept {
  userbus::Name name{};
  if (!preload::is_can(descriptor, name)) return next().getsockname(descriptor, address, length);
  return preload::give_name(descriptor, name, address, length);
}

PRELOAD_EXPORT unsigned if_nametoindex(const char* name) noexcept {
  if (!preload::is_can_interface(name)) return next().if_nametoindex(name);
  return static_cast<unsigned>(preload::index_of_interface(name, preload::kNoMember));
}

PRELOAD_EXPORT char* if_indextoname(unsigned index, char* name) noexcept {
  const int error = errno;
  if (char* const real = next().if_indextoname(index, name); real != nullptr) return real;
  char found[IF_NAMESIZE];
  if (index < preload::kFirstIndex) return nullptr;
  if (!preload::name_of_interface(static_cast<int>(index), preload::kNoMember, found)) {
    errno = ENXIO;
    return nullptr;
  }
  memcpy(name, found, sizeof found);
  errno = error;
  return name;
}

PRELOAD_EXPORT struct if_nameindex* if_nameindex() noexcept {
  struct if_nameindex* const real = next().if_nameindex();
  if (real == nullptr) return nullptr;
  preload::Interfaces list{};
  preload::list_interfaces(list);
  return list.count == 0 ? real : preload::append(real, list);
}
