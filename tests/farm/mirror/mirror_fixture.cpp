#include "tests/farm/mirror/mirror_fixture.hpp"

#include <array>
#include <chrono>
#include <stdexcept>

#include <poll.h>
#include <sys/socket.h>

#include "control/protocol.hpp"
#include "farm/documents/door_beat.hpp"

namespace farm {
namespace {

constexpr std::chrono::seconds kPatience{30};  // only what is broken takes it
constexpr int kTurn = 20;                      // ms

}  // namespace

void wait_until(axisd::ServiceEvents& events, const std::function<bool()>& is_done) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (!is_done()) {
    if (std::chrono::steady_clock::now() > deadline) throw std::runtime_error{"waited in vain"};
    pollfd ready{events.descriptor(), POLLIN, 0};
    ::poll(&ready, 1, kTurn);
    while (events.dispatch()) {
    }
  }
}

void TestClient::send(std::string_view text) const {
  if (::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(text.size()))
    throw std::runtime_error{"the mirror takes nothing"};
}

void TestClient::ask(int id, std::string_view method, const nlohmann::json& params) const {
  send(control::request_line(id, method, params));
}

bool TestClient::read() {
  std::array<char, 4096> block{};
  const ssize_t got = ::recv(socket_.get(), block.data(), block.size(), MSG_DONTWAIT);
  if (got == 0) is_over_ = true;
  if (got > 0) input_.append(block.data(), static_cast<std::size_t>(got));
  return got > 0;
}

std::string TestClient::line() {
  wait_until(*events_, [this] { return input_.find('\n') != std::string::npos || (!read() && is_over_); });
  const std::size_t end = input_.find('\n');
  if (end == std::string::npos) return "closed";
  std::string line = input_.substr(0, end);
  input_.erase(0, end + 1);
  return line;
}

bool TestClient::is_closed() {
  wait_until(*events_, [this] {
    while (read()) {
    }
    return is_over_;
  });
  return is_over_;
}

void MirrorTest::open_farm() {
  mirror->on_up();
  tell("a", {"line1/5", "line1/6"});
  tell("b", {"line2/5"});
}

void MirrorTest::tell(const std::string& host, const std::vector<std::string>& units) {
  DoorBeat beat{.host = host, .instance = 1, .version = "1", .units = {}, .part = 1, .parts = 1};
  for (const std::string& unit : units)
    beat.units.push_back({.name = parse_unit_name(unit).value(), .profile = "s120", .node_id = 5});
  messages.come("axisd_host.lab." + host + ".door", text_of(beat));
}

TestClient MirrorTest::connect(Order order) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error{"socketpair"};
  mirror->serve(os::Descriptor{ends[0]}, order);
  return {events, os::Descriptor{ends[1]}};
}

fakes::FakeMessages::Asked MirrorTest::asked() {
  wait_until(events, [this] { return !messages.asked.empty(); });
  return messages.take_asked();
}

std::string MirrorTest::answer_to(const fakes::FakeMessages::Asked& asked, const nlohmann::json& result) {
  return nlohmann::json{{"id", nlohmann::json::parse(asked.data)["id"]}, {"result", result}}.dump();
}

}  // namespace farm
