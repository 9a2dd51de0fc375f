#include "tests/gateway/gateway_fixture.hpp"

#include <array>
#include <chrono>
#include <stdexcept>

#include <arpa/inet.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "control/protocol.hpp"
#include "control/socket_name.hpp"

namespace gateway {
namespace {

using nlohmann::json;

constexpr std::chrono::seconds kPatience{30};  // only what is broken takes it
constexpr int kTurn = 50;                      // ms

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

FakeDaemon::FakeDaemon(axisd::ServiceEvents& events, const std::string& path,
                       std::function<std::string(std::string)> answer)
    : events_{events},
      path_{path},
      answer_{std::move(answer)},
      listener_{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)} {
  const sockaddr_un address = control::socket_address(path).value();
  if (::bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      ::listen(listener_.get(), SOMAXCONN) != 0)
    throw std::runtime_error{"cannot listen at " + path};
  source_ = events.watch(
      listener_.get(), EPOLLIN,
      [](sd_event_source*, int, std::uint32_t, void* self) {
        static_cast<FakeDaemon*>(self)->accept();
        return 0;
      },
      this);
}

FakeDaemon::~FakeDaemon() {
  ::unlink(path_.c_str());
}

void FakeDaemon::accept() {
  Client& client = clients_.emplace_back(
      Client{this, os::Descriptor{::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK)}});
  client.source = events_.watch(
      client.socket.get(), EPOLLIN,
      [](sd_event_source*, int, std::uint32_t, void* self) {
        auto& one = *static_cast<Client*>(self);
        if (!serve(one)) one.daemon->clients_.remove_if([&one](const Client& each) { return &each == &one; });
        return 0;
      },
      &client);
}

bool FakeDaemon::serve(Client& client) {
  std::array<char, 65536> part{};
  const ssize_t size = ::recv(client.socket.get(), part.data(), part.size(), 0);
  if (size <= 0) return false;
  client.input.append(part.data(), static_cast<std::size_t>(size));
  std::string answers;
  for (std::size_t end = 0; (end = client.input.find('\n')) != std::string::npos; client.input.erase(0, end + 1)) {
    client.daemon->lines.push_back(client.input.substr(0, end));
    const std::string answer = client.daemon->answer_(client.daemon->lines.back());
    if (answer == "close") return false;
    answers += answer;
  }
  ::send(client.socket.get(), answers.data(), answers.size(), MSG_NOSIGNAL);
  return true;
}

void FakeDaemon::tell(std::string_view text) {
  for (const Client& client : clients_) ::send(client.socket.get(), text.data(), text.size(), MSG_NOSIGNAL);
}

std::string answer_of_unit(const std::string& line) {
  const control::Request request = control::parse_request(line).value();
  if (request.method == "units")
    return control::result_line(request.id, {{"units", {{{"unit", "vcan0/5"}, {"node_id", 5}}}}, {"clients", 1}});
  if (request.method == "explain")
    return control::error_line(request.id, {control::ErrorCode::Refused, "it will not"});
  return control::result_line(request.id, {{"method", request.method}, {"params", request.params}});
}

HttpClient::HttpClient(axisd::ServiceEvents& events, std::uint16_t port)
    : events_{events}, socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    throw std::runtime_error{"nobody listens"};
}

void HttpClient::send(std::string_view text) {
  while (!text.empty()) {
    const ssize_t sent = ::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0)
      text.remove_prefix(static_cast<std::size_t>(sent));
    else if (errno != EAGAIN)
      return;  // the server has had enough
    else
      while (events_.dispatch()) {
      }
  }
}

std::string HttpClient::read_until(std::string_view pattern) {
  std::array<char, 65536> part{};
  wait_until(events_, [&] {
    const ssize_t size = ::recv(socket_.get(), part.data(), part.size(), MSG_DONTWAIT);
    if (size > 0) input_.append(part.data(), static_cast<std::size_t>(size));
    is_closed_ = size == 0 || (size < 0 && errno != EAGAIN);
    return is_closed_ || input_.find(pattern) != std::string::npos;
  });
  return std::exchange(input_, {});
}

}  // namespace gateway
