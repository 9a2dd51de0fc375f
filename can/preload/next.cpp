#include "can/preload/next.hpp"

#include <atomic>

#include "can/preload/look_up.hpp"

namespace preload {

namespace {

Next calls;
std::atomic<bool> looked_up;

void look_up() noexcept {
  const Entry entries[] = {
      {"socket", address_of(calls.socket)},
      {"bind", address_of(calls.bind)},
      {"connect", address_of(calls.connect)},
      {"close", address_of(calls.close)},
      {"setsockopt", address_of(calls.setsockopt)},
      {"getsockopt", address_of(calls.getsockopt)},
      {"getsockname", address_of(calls.getsockname)},
      {"ioctl", address_of(calls.ioctl)},
      {"read", address_of(calls.read)},
      {"readv", address_of(calls.readv)},
      {"recv", address_of(calls.recv)},
      {"recvfrom", address_of(calls.recvfrom)},
      {"recvmsg", address_of(calls.recvmsg)},
      {"recvmmsg", address_of(calls.recvmmsg)},
      {"__read_chk", address_of(calls.read_chk)},
      {"__recv_chk", address_of(calls.recv_chk)},
      {"__recvfrom_chk", address_of(calls.recvfrom_chk)},
      {"write", address_of(calls.write)},
      {"writev", address_of(calls.writev)},
      {"send", address_of(calls.send)},
      {"sendto", address_of(calls.sendto)},
      {"sendmsg", address_of(calls.sendmsg)},
      {"sendmmsg", address_of(calls.sendmmsg)},
      {"if_nametoindex", address_of(calls.if_nametoindex)},
      {"if_indextoname", address_of(calls.if_indextoname)},
      {"if_nameindex", address_of(calls.if_nameindex)},
  };
  static_assert(sizeof entries / sizeof *entries == sizeof(Next) / sizeof(void*), "every call is looked up");
  look_up_all(entries);
  looked_up.store(true, std::memory_order_release);
}

}  // namespace

const Next& next() noexcept {
  if (!looked_up.load(std::memory_order_acquire)) look_up();
  return calls;
}

}  // namespace preload
