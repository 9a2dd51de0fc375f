#include "tests/can/hub/bus_client.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/can/hub/told.hpp"

namespace hub_test {

using userbus::Operation;

namespace {

constexpr int kPatience = 20'000;  // ms; a machine under load is slow

/// True if @p descriptor polls @p events before long.
bool becomes(int descriptor, short events) {
  pollfd wanted{descriptor, events, 0};
  return poll(&wanted, 1, kPatience) == 1;
}

void expect_done(const userbus::Answer& answer, const char* what) {
  if (answer.error != 0) throw std::system_error{answer.error, std::generic_category(), what};
}

}  // namespace

userbus::Path path_of(const std::string& text) {
  userbus::Path path{};
  if (!userbus::copy_path(text.c_str(), path)) throw std::invalid_argument{text};
  return path;
}

BusClient::BusClient(const std::string& path, std::string_view interface, userbus::Kind kind) {
  const userbus::Joined joined = userbus::join(path_of(path), nullptr, kind, SOCK_CLOEXEC);
  if (joined.descriptor < 0) throw std::runtime_error{path + ' ' + userbus::text_of(joined.error)};
  socket_ = os::Descriptor{joined.descriptor};
  if (!interface.empty()) bind(interface);
}

int BusClient::index_of(std::string_view interface) const {
  const userbus::Answer answer = ask(Operation::InterfaceIndex, 0, std::as_bytes(std::span{interface}));
  expect_done(answer, "InterfaceIndex");
  return answer.value;
}

void BusClient::bind(std::string_view interface) {
  expect_done(ask(Operation::Bind, interface == "any" ? 0 : index_of(interface)), "Bind");
}

void BusClient::set(userbus::OptionName option, std::uint32_t value) {
  const userbus::Option payload{.name = option, .value = value};
  expect_done(ask(Operation::SetOption, 0, std::as_bytes(std::span{&payload, 1})), "SetOption");
}

void BusClient::set_filters(std::span<const can_filter> filters) {
  expect_done(ask(Operation::SetFilters, 0, std::as_bytes(filters)), "SetFilters");
}

void BusClient::send(std::string_view text) const {
  send(told::wire(text));
}

void BusClient::send(const can_frame& frame) const {
  if (::send(socket_.get(), &frame, sizeof frame, MSG_NOSIGNAL) != sizeof frame)
    throw std::system_error{errno, std::generic_category(), "send"};
}

bool BusClient::send_bytes(std::span<const std::byte> bytes) const {
  return ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT) >= 0;
}

void BusClient::send_with_descriptors(std::span<const std::byte> bytes, std::size_t count) const {
  constexpr std::size_t kMost = 8;
  alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(kMost * sizeof(int))> control{};
  const std::vector<int> descriptors(std::min(count, kMost), STDERR_FILENO);
  const std::size_t size = descriptors.size() * sizeof(int);
  iovec part{const_cast<std::byte*>(bytes.data()), bytes.size()};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (size > 0) {
    message.msg_control = control.data();
    message.msg_controllen = CMSG_SPACE(size);
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(size);
    std::memcpy(CMSG_DATA(header), descriptors.data(), size);
  }
  sendmsg(socket_.get(), &message, MSG_NOSIGNAL | MSG_DONTWAIT);
}

void BusClient::settle() const {
  expect_done(ask(Operation::Hello), "Hello");
}

std::optional<userbus::FrameMessage> BusClient::receive(bool wait) const {
  userbus::FrameMessage message{};
  if (wait && !becomes(socket_.get(), POLLIN)) return std::nullopt;
  if (recv(socket_.get(), &message, sizeof message, MSG_DONTWAIT) != sizeof message) return std::nullopt;
  return message;
}

std::vector<userbus::FrameMessage> BusClient::take() {
  std::vector<userbus::FrameMessage> messages;
  while (const auto message = receive(false)) messages.push_back(*message);
  return messages;
}

std::vector<std::string> BusClient::take_frames() {
  std::vector<std::string> frames;
  for (const userbus::FrameMessage& message : take()) frames.push_back(told::text_of(message.frame));
  return frames;
}

std::string BusClient::wait_frame() {
  const auto message = receive(true);
  return message ? told::text_of(message->frame) : std::string{};
}

bool BusClient::is_closed_by_hub() const {
  return becomes(socket_.get(), POLLRDHUP);
}

userbus::Answer BusClient::ask(Operation operation, int value, std::span<const std::byte> payload) const {
  reply_.resize(userbus::kLongestMessage);
  const userbus::Answer answer =
      userbus::ask(socket_.get(), operation, value, payload.data(), payload.size(), reply_.data(), reply_.size());
  reply_.resize(answer.size);
  return answer;
}

}  // namespace hub_test
