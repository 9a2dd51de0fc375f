#include "tests/e2e/can_client.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include <poll.h>

#include "tests/e2e/program.hpp"
#include "tests/fakes/candump.hpp"

namespace e2e {
namespace {

using canopen::Frame;
using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

constexpr int kReceiveBuffer = 32 << 20;
constexpr std::size_t kShown = 40;  // frames in the message of a failure

/// Opens a port, or says how to get the interface.
bus::SocketCan open_port(const std::string& interface) {
  try {
    return bus::SocketCan{interface, kReceiveBuffer};
  } catch (const bus::OpenError& error) {
    throw std::runtime_error{
        std::string{error.what()} +
        "; these tests need the CAN interface vcan0: make it with scripts/vcan-setup.sh, or run "
        "them under with-can or in scripts/vcan-vm"};
  }
}

}  // namespace

CanClient::CanClient(const std::string& interface) : port_{open_port(interface)} {}

Frame CanClient::frame(std::string_view text) {
  return fakes::frame_of(text);
}

void CanClient::send(const Frame& frame) {
  bus::SendStatus status = port_.send(frame);
  for (pollfd room{port_.descriptor(), POLLOUT, 0}; status == bus::SendStatus::Full; status = port_.send(frame)) {
    if (poll(&room, 1, static_cast<int>(std::chrono::milliseconds{kPatience}.count())) != 1) break;
  }
  if (status != bus::SendStatus::Sent) throw std::runtime_error{"not sent: " + fakes::candump(frame)};
}

std::optional<Frame> CanClient::note(const Frame& frame) {
  seen_.push_back(fakes::candump(frame));
  return frame;
}

std::optional<Frame> CanClient::next_waiting() {
  Frame frame;
  const bus::Received received = port_.receive(frame);
  return received.kind == bus::Received::Frame ? note(frame) : std::nullopt;
}

std::optional<Frame> CanClient::next() {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  for (;;) {
    if (auto frame = next_waiting()) return frame;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    pollfd wanted{port_.descriptor(), POLLIN, 0};
    if (left.count() <= 0 || poll(&wanted, 1, static_cast<int>(left.count())) != 1) return std::nullopt;
  }
}

void CanClient::forget() {
  while (next_waiting()) {
  }
  seen_.clear();
}

void CanClient::listen_to(const std::vector<std::uint32_t>& identifiers) {
  std::vector<bus::Filter> filters;
  for (const std::uint32_t identifier : identifiers) filters.push_back({.identifier = identifier});
  port_.accept_only(filters);
}

AssertionResult CanClient::failure(const std::string& what) const {
  AssertionResult result = AssertionFailure() << "expected " << what << ", received";
  const std::size_t hidden = seen_.size() - std::min(seen_.size(), kShown);
  if (hidden > 0) result << " (behind " << hidden << " others)";
  if (seen_.empty()) result << " nothing";
  for (std::size_t i = hidden; i < seen_.size(); ++i) result << "\n  " << seen_[i];
  return result;
}

AssertionResult CanClient::expect(std::string_view text) {
  const Frame wanted = frame(text);
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < end) {
    const auto got = next();
    if (!got) break;
    if (got->id != wanted.id || got->extended != wanted.extended) continue;
    if (*got != wanted) return failure(std::string{text});
    seen_.clear();
    return AssertionSuccess();
  }
  return failure(std::string{text});
}

AssertionResult CanClient::wait_until(const std::string& what, const std::function<bool(const Frame&)>& wanted) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < end) {
    const auto got = next();
    if (!got) break;
    if (!wanted(*got)) continue;
    seen_.clear();
    return AssertionSuccess();
  }
  return failure(what);
}

AssertionResult CanClient::wait_for(std::string_view text) {
  const Frame wanted = frame(text);
  return wait_until(std::string{text}, [&](const Frame& got) { return got == wanted; });
}

AssertionResult CanClient::ask(std::string_view request, std::string_view answer) {
  send(request);
  return expect(answer);
}

AssertionResult wait_for_drive(CanClient& can, const std::string& what,
                               const std::function<bool(const StatusAndSpeed&)>& wanted) {
  constexpr std::uint32_t kTpdo2 = 0x285;
  constexpr std::uint8_t kLength = 6;
  return can.wait_until("285# with " + what, [&](const Frame& frame) {
    if (frame.id != kTpdo2 || frame.length != kLength) return false;
    const auto word = static_cast<std::uint16_t>(frame.data[0] | frame.data[1] << 8);
    std::uint32_t speed = 0;
    for (std::size_t i = 0; i < sizeof speed; ++i) speed |= std::uint32_t{frame.data[2 + i]} << (8 * i);
    return wanted({word, static_cast<std::int32_t>(speed)});
  });
}

AssertionResult wait_for_state(CanClient& can, const DriveState& state) {
  return wait_for_drive(can, state.name, [&](const StatusAndSpeed& drive) { return drive.is(state); });
}

void enable_operation(CanClient& can) {
  ASSERT_TRUE(can.ask("000#0105", "185#4016"));
  ASSERT_TRUE(can.ask("205#0600", "185#3116"));
  ASSERT_TRUE(can.ask("205#0700", "185#3316"));
  ASSERT_TRUE(can.ask("205#0F00", "185#3716"));
}

void make_motor_turn(CanClient& can) {
  ASSERT_NO_FATAL_FAILURE(enable_operation(can));
  can.send("305#0F000000800C");
  ASSERT_TRUE(wait_for_drive(can, "a turning motor", [](const StatusAndSpeed& drive) {
    return drive.speed > 0 && !drive.has(kStandstill);
  }));
}

}  // namespace e2e
