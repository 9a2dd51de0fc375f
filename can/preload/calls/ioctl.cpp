// ioctl: what programs ask of interfaces and of the last message.
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <ctime>

#include <linux/can.h>
#include <linux/sockios.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/descriptor.hpp"
#include "can/preload/interface.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/state.hpp"

namespace preload {

namespace {

using userbus::Name;

constexpr int64_t kNanosecondsInSecond = 1'000'000'000;
constexpr int64_t kNanosecondsInMicrosecond = 1000;

// Each fills in what one request asks of the interface that has `index`.

void give_index(ifreq& request, int index) noexcept {
  request.ifr_ifindex = index;
}

void give_mtu(ifreq& request, int) noexcept {
  request.ifr_mtu = CAN_MTU;
}

void give_flags(ifreq& request, int) noexcept {
  request.ifr_flags = IFF_UP | IFF_RUNNING | IFF_NOARP;
}

void give_hardware_address(ifreq& request, int) noexcept {
  memset(&request.ifr_hwaddr, 0, sizeof request.ifr_hwaddr);
  request.ifr_hwaddr.sa_family = ARPHRD_CAN;
}

void give_queue_length(ifreq& request, int) noexcept {
  constexpr int kLength = 1000;  // as vcan
  request.ifr_qlen = kLength;
}

/// A request that names an interface.
struct InterfaceRequest {
  unsigned long number;
  void (*give)(ifreq& request, int index);
};

constexpr InterfaceRequest kInterfaceRequests[] = {
    {SIOCGIFINDEX, give_index},         {SIOCGIFMTU, give_mtu},
    {SIOCGIFFLAGS, give_flags},         {SIOCGIFHWADDR, give_hardware_address},
    {SIOCGIFTXQLEN, give_queue_length},
};

const InterfaceRequest* interface_request(unsigned long number) noexcept {
  for (const InterfaceRequest& request : kInterfaceRequests)
    if (request.number == number) return &request;
  return nullptr;
}

/// Whether @p request, for which CAN socket @p member asks (-1: another descriptor), names an interface of the
/// hub. Of sockets that are not CAN sockets the hub's names are answered, too: programs ask through any.
bool is_for_hub(unsigned long number, const void* request) noexcept {
  return interface_request(number) != nullptr && request != nullptr &&
         is_can_interface(static_cast<const ifreq*>(request)->ifr_name);
}

bool is_socket(int descriptor) noexcept {
  int type = 0;
  socklen_t size = sizeof type;
  return next().getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &size) == 0;
}

int answer_interface(unsigned long number, ifreq& request, int member) noexcept {
  const int index = index_of_interface(request.ifr_name, member);
  if (index == 0) return -1;
  interface_request(number)->give(request, index);
  return 0;
}

int answer_name(ifreq& request, int member) noexcept {
  char name[IF_NAMESIZE];
  if (!name_of_interface(request.ifr_ifindex, member, name)) return -1;
  memcpy(request.ifr_name, name, sizeof name);
  return 0;
}

/// SIOCGSTAMP (microseconds) or SIOCGSTAMPNS.
int answer_stamp(unsigned long number, void* room, int descriptor, const Name& name) noexcept {
  const int64_t time = last_received(descriptor, name);
  if (time == 0) return failed(ENOENT);
  const int64_t fraction = time % kNanosecondsInSecond;
  const bool nanoseconds = number == SIOCGSTAMPNS_OLD || number == SIOCGSTAMPNS_NEW;
  const int64_t stamp[] = {time / kNanosecondsInSecond,
                           nanoseconds ? fraction : fraction / kNanosecondsInMicrosecond};
  static_assert(sizeof(timespec) == sizeof stamp && sizeof(timeval) == sizeof stamp);
  memcpy(room, stamp, sizeof stamp);
  return 0;
}

bool asks_for_stamp(unsigned long number) noexcept {
  return number == SIOCGSTAMP_OLD || number == SIOCGSTAMP_NEW || number == SIOCGSTAMPNS_OLD ||
         number == SIOCGSTAMPNS_NEW;
}

int answer_can_socket(int descriptor, const Name& name, unsigned long number, void* argument) noexcept {
  if (asks_for_stamp(number)) return answer_stamp(number, argument, descriptor, name);
  const int member = name.kind == userbus::Kind::Down ? -1 : descriptor;
  if (number == SIOCGIFNAME) return answer_name(*static_cast<ifreq*>(argument), member);
  if (is_for_hub(number, argument)) return answer_interface(number, *static_cast<ifreq*>(argument), member);
  return next().ioctl(descriptor, number, argument);
}

}  // namespace

}  // namespace preload

PRELOAD_EXPORT int ioctl(int descriptor, unsigned long number, ...) noexcept {
  va_list arguments;
  va_start(arguments, number);
  void* const argument = va_arg(arguments, void*);
  va_end(arguments);
  userbus::Name name{};
  if (preload::is_can(descriptor, name)) return preload::answer_can_socket(descriptor, name, number, argument);
  if (preload::is_for_hub(number, argument) && preload::is_socket(descriptor))
    return preload::answer_interface(number, *static_cast<ifreq*>(argument), -1);
  return preload::next().ioctl(descriptor, number, argument);
}
