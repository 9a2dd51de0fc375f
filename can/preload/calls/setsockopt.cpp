// setsockopt: what a program wants of a CAN socket. It returns when the hub has applied it.
#include <cerrno>
#include <cstring>

#include <linux/can/raw.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/descriptor.hpp"
#include "can/preload/hub.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/options.hpp"

namespace preload {

namespace {

using userbus::Kind;
using userbus::Name;
using userbus::Operation;
using userbus::OptionName;

/// A value as a program hands it over.
struct Value {
  const void* data;
  socklen_t size;

  [[nodiscard]] int number() const noexcept {
    int value = 0;
    memcpy(&value, data, sizeof value);
    return value;
  }
};

int set_in_hub(int descriptor, OptionName name, uint32_t value) noexcept {
  const userbus::Option option{.name = name, .value = value};
  if (tell(descriptor, Operation::SetOption, 0, &option, sizeof option) != 0) return -1;
  state_has_changed();
  return 0;
}

int set_filters(int descriptor, const Value& value) noexcept {
  constexpr socklen_t kMost = CAN_RAW_FILTER_MAX * sizeof(can_filter);
  if (value.size % sizeof(can_filter) != 0 || value.size > kMost) return failed(EINVAL);
  return tell(descriptor, Operation::SetFilters, 0, value.data, value.size);
}

int set_raw(int descriptor, int number, const Value& value) noexcept {
  if (number == CAN_RAW_FILTER) return set_filters(descriptor, value);
  const RawOption* const option = raw_option(number);
  if (option == nullptr) return failed(ENOPROTOOPT);
  if (value.size != sizeof(int)) return failed(EINVAL);
  const auto bits = static_cast<uint32_t>(value.number());
  const uint32_t kept = option->bits == 0 ? (bits != 0 ? 1 : 0) : bits & option->bits;
  return set_in_hub(descriptor, option->name, kept);
}

int set_stamps(int descriptor, const Name& name, int number, int value) noexcept {
  SocketState state;
  if (!state_of(descriptor, name, state)) return -1;
  if (socket_option(number) == SocketOption::SingleStamp)
    state.stamps.set_single(number, value != 0);
  else
    state.stamps.set_flags(number, static_cast<uint32_t>(value));
  return set_in_hub(descriptor, OptionName::Timestamps, state.stamps.value());
}

int set_socket(int descriptor, const Name& name, int number, const Value& value) noexcept {
  const SocketOption option = socket_option(number);
  const bool ours = option == SocketOption::SingleStamp || option == SocketOption::Stamping ||
                    option == SocketOption::CountDropped;
  if (!ours) return next().setsockopt(descriptor, SOL_SOCKET, number, value.data, value.size);
  if (name.kind == Kind::Down) return failed(ENETDOWN);
  if (value.size < sizeof(int)) return failed(EINVAL);
  if (option == SocketOption::Stamping && (value.number() & ~static_cast<int>(SOF_TIMESTAMPING_MASK)) != 0)
    return failed(EINVAL);
  if (option == SocketOption::CountDropped)
    return set_in_hub(descriptor, OptionName::CountDropped, value.number() != 0 ? 1 : 0);
  return set_stamps(descriptor, name, number, value.number());
}

}  // namespace

}  // namespace preload

PRELOAD_EXPORT int setsockopt(int descriptor, int level, int number, const void* value, socklen_t size) noexcept {
  userbus::Name name{};
  if (!preload::is_can(descriptor, name))
    return preload::next().setsockopt(descriptor, level, number, value, size);
  if (level == SOL_SOCKET) return preload::set_socket(descriptor, name, number, {value, size});
  if (name.kind == userbus::Kind::BroadcastManager) return preload::failed(EOPNOTSUPP);
  if (level != SOL_CAN_RAW) return preload::failed(EINVAL);
  if (name.kind == userbus::Kind::Down) return preload::failed(ENETDOWN);
  return preload::set_raw(descriptor, number, {value, size});
}
