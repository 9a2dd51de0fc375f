#include "can/hub/member/requests.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <string_view>
#include <type_traits>

#include <fcntl.h>
#include <sys/socket.h>

#include "can/hub/faults/answer.hpp"
#include "can/userbus/ancillary.hpp"

namespace hub {

namespace {

using userbus::Operation;

/// The payload of a reply while it is written.
class Payload {
 public:
  static constexpr std::size_t kRoom = userbus::kLongestMessage - sizeof(userbus::Reply);

  /// False if there is no room for it.
  template <class T>
  bool add(const T& value) noexcept {
    static_assert(std::is_trivially_copyable_v<T>);
    return append(std::as_bytes(std::span{&value, 1}));
  }
  bool append(std::span<const std::byte> bytes) noexcept {
    if (bytes.size() > bytes_.size() - size_) return false;
    if (!bytes.empty()) std::memcpy(&bytes_[size_], bytes.data(), bytes.size());
    size_ += bytes.size();
    return true;
  }
  [[nodiscard]] std::span<std::byte> bytes() noexcept { return std::span{bytes_}.first(size_); }

 private:
  std::array<std::byte, kRoom> bytes_{};
  std::size_t size_ = 0;
};

/// What came with the request, and where the answer's payload goes.
struct Call {
  const Asking& asking;
  int value;
  std::span<const std::byte> payload;
  Payload& reply;
  int reply_socket;  ///< where the reply goes; to be duplicated by who replies later
};

struct Result {
  int error = 0;
  int value = 0;
  int descriptor = -1;    ///< that goes with the reply; the hub's own
  bool is_later = false;  ///< somebody else replies
};

/// The payload as one @p T; false if it has another size.
template <class T>
bool read_as(std::span<const std::byte> payload, T& value) noexcept {
  static_assert(std::is_trivially_copyable_v<T>);
  if (payload.size() != sizeof value) return false;
  std::memcpy(&value, payload.data(), sizeof value);
  return true;
}

bool is_interface(const Call& call, int index) noexcept {
  return !call.asking.core.interfaces.name_of(index).empty();
}

Result hello(const Call& call) noexcept {
  constexpr int kBridge = 1;
  std::uint32_t most = 1;
  const bool is_asked = read_as(call.payload, most);
  if (!call.payload.empty() && (!is_asked || most == 0)) return {.error = EINVAL};
  call.asking.member.set_bridge(call.value == kBridge);
  const auto taken = static_cast<std::uint32_t>(call.asking.member.agree_on_frames(most));
  if (is_asked) call.reply.add(taken);
  return {.value = static_cast<int>(call.asking.core.medium.bit_rate())};
}

Result bind(const Call& call) noexcept {
  if (call.value != 0 && !is_interface(call, call.value)) return {.error = ENODEV};
  call.asking.member.bind(call.value);
  return {};
}

Result read_state(const Call& call) noexcept {
  call.reply.add(call.asking.member.state());
  return {};
}

Result set_option(const Call& call) noexcept {
  userbus::Option option{};
  if (!read_as(call.payload, option)) return {.error = EINVAL};
  return {.error = call.asking.member.set_option(option)};
}

Result set_filters(const Call& call) noexcept {
  std::array<can_filter, CAN_RAW_FILTER_MAX> filters{};
  const std::span<const std::byte> payload = call.payload;
  if (payload.size() > sizeof filters || payload.size() % sizeof(can_filter) != 0) return {.error = EINVAL};
  if (!payload.empty()) std::memcpy(filters.data(), payload.data(), payload.size());
  return {.error = call.asking.member.set_filters(std::span{filters}.first(payload.size() / sizeof(can_filter)))};
}

Result read_filters(const Call& call) noexcept {
  call.reply.append(std::as_bytes(call.asking.member.filters()));
  return {};
}

Result interface_index(const Call& call) noexcept {
  const std::string_view name{reinterpret_cast<const char*>(call.payload.data()), call.payload.size()};
  const int index = call.asking.core.interfaces.index_of(name);
  return index == 0 ? Result{.error = ENODEV} : Result{.value = index};
}

Result interface_name(const Call& call) noexcept {
  const std::string_view name = call.asking.core.interfaces.name_of(call.value);
  call.reply.append(std::as_bytes(std::span{name}));
  return {.error = name.empty() ? ENODEV : 0};
}

Result interfaces(const Call& call) noexcept {
  call.reply.append(std::as_bytes(call.asking.core.interfaces.entries()));
  return {};
}

Result broadcast(const Call& call) noexcept {
  if (call.value != 0 && !is_interface(call, call.value)) return {.error = ENODEV};
  return {.error = call.asking.member.broadcast(call.payload, call.value, call.asking.now)};
}

Result statistics(const Call& call) noexcept {
  const Core& core = call.asking.core;
  std::uint32_t rows = 0;
  userbus::BusStatistics bus{.frames = core.medium.passed(), .bit_rate = core.medium.bit_rate(), .members = 0};
  call.reply.add(bus);
  const auto add_row = [&](const userbus::MemberStatistics& row) {
    if (static_cast<std::int64_t>(rows++) >= call.value) call.reply.add(row);
  };
  for (const auto& member : core.members) add_row(member->statistics());
  userbus::MemberStatistics row{};
  for (const Source* const source : core.sources)
    if (source->statistics(row)) add_row(row);
  bus.members = rows;
  std::memcpy(call.reply.bytes().data(), &bus, sizeof bus);
  return {};
}

/// The faults of the bus, in texts of JSON.
Result inject(const Call& call) noexcept {
  const std::string_view text{reinterpret_cast<const char*>(call.payload.data()), call.payload.size()};
  try {
    const faults::Answer answer = faults::answer(call.asking.core.faults, text, call.asking.now);
    if (!call.reply.append(std::as_bytes(std::span{answer.text}))) return {.error = EMSGSIZE};
    return {.error = answer.error};
  } catch (const std::exception&) {
    return {.error = ENOMEM};
  }
}

Result link(const Call& call) noexcept {
  const Core& core = call.asking.core;
  const int page = core.link_page.descriptor();
  if (page < 0) return {.error = EOPNOTSUPP};
  return {.value = core.medium.is_up() ? 1 : 0, .descriptor = page};
}

Result trunk(const Call& call) noexcept {
  const Carrier* const carrier = call.asking.core.medium.carrier();
  if (carrier == nullptr) return {.error = EOPNOTSUPP};
  try {
    const std::string text = carrier->report(Payload::kRoom);
    return {.error = call.reply.append(std::as_bytes(std::span{text})) ? 0 : EMSGSIZE};
  } catch (const std::exception&) {
    return {.error = ENOMEM};
  }
}

Result time(const Call& call) noexcept {
  const Turns* const turns = call.asking.core.turns;
  if (call.value == userbus::kAskState) call.reply.add(turns == nullptr ? userbus::TimeState{} : turns->state());
  return turns == nullptr ? Result{} : Result{.descriptor = turns->page()};
}

Result step(const Call& call) noexcept {
  Turns* const turns = call.asking.core.turns;
  std::int64_t step_ns = 0;
  if (turns == nullptr) return {.error = EOPNOTSUPP};
  if (!read_as(call.payload, step_ns) || step_ns < 0) return {.error = EINVAL};
  os::Descriptor socket{fcntl(call.reply_socket, F_DUPFD_CLOEXEC, 0)};
  if (!socket) return {.error = errno};
  const int error = turns->step(canopen::Duration{step_ns}, std::move(socket));
  return {.error = error, .is_later = error == 0};
}

using Handler = Result (*)(const Call&) noexcept;

/// By Operation.
constexpr std::array<Handler, 16> kHandlers{
    hello,          bind,       read_state, set_option, set_filters, read_filters, interface_index,
    interface_name, interfaces, broadcast,  statistics, inject,      link,         trunk,
    time,           step};
static_assert(kHandlers.size() == static_cast<std::size_t>(Operation::Step) + 1);

Result handle(Operation operation, const Call& call) noexcept {
  const auto number = static_cast<std::size_t>(operation);
  return number < kHandlers.size() ? kHandlers[number](call) : Result{.error = EINVAL};
}

void send_reply(int descriptor, const Result& result, std::span<std::byte> payload) noexcept {
  userbus::Reply reply{
      .error = result.error, .value = result.value, .size = static_cast<std::uint32_t>(payload.size())};
  std::array parts{iovec{&reply, sizeof reply}, iovec{payload.data(), payload.size()}};
  msghdr message{};
  message.msg_iov = parts.data();
  message.msg_iovlen = parts.size();
  userbus::Ancillary ancillary{};
  if (result.descriptor >= 0) userbus::carry(message, ancillary, result.descriptor);
  sendmsg(descriptor, &message, MSG_DONTWAIT | MSG_NOSIGNAL);
}

}  // namespace

bool answer_request(const Asking& asking, const Inbox::Message& message) noexcept {
  userbus::Request request{};
  if (!message.complete || message.bytes.size() < sizeof request) return false;
  std::memcpy(&request, message.bytes.data(), sizeof request);
  const std::span payload = message.bytes.subspan(sizeof request);
  Payload reply;
  const bool fits = payload.size() == request.size;
  asking.core.hand_over();
  const Result result =
      fits ? handle(request.operation, {asking, request.value, payload, reply, message.descriptor.get()})
           : Result{.error = EINVAL};
  asking.core.hand_over();
  if (!result.is_later) send_reply(message.descriptor.get(), result, reply.bytes());
  return fits && static_cast<std::size_t>(request.operation) < kHandlers.size();
}

}  // namespace hub
