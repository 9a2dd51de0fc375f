#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <system_error>
#include <vector>

#include <sys/epoll.h>
#include <sys/socket.h>

#include "bench/trunk/sequencer_messages.hpp"
#include "bench/trunk/tcp.hpp"

/// The floor below every server that a bus of several hosts could have: gives the messages of all connections one
/// order and sends each to all of them, and does nothing else.
namespace {

using bench::Transfer;

class Sequencer {
 public:
  explicit Sequencer(const char* place)
      : epoll_{::epoll_create1(EPOLL_CLOEXEC)}, listener_{bench::listen_at(place)} {
    watch(EPOLL_CTL_ADD, listener_.get(), EPOLLIN, nullptr);
  }

  /// Never returns.
  void serve() {
    constexpr int kEvents = 16;
    std::array<epoll_event, kEvents> events{};
    for (;;) {
      const int found = ::epoll_wait(epoll_.get(), events.data(), kEvents, -1);
      for (int i = 0; i < found; ++i) take(events[static_cast<std::size_t>(i)]);
      for (const auto& client : clients_) send_to(*client);
      std::erase_if(clients_, [](const auto& client) { return client->is_gone; });
    }
  }

 private:
  struct Client {
    os::Descriptor socket;
    bench::ByteQueue asked;
    bench::ByteQueue given;
    bool is_behind = false;  ///< its socket is watched for room
    bool is_gone = false;
  };

  void watch(int operation, int descriptor, std::uint32_t events, Client* client) {
    epoll_event event{};
    event.events = events;
    event.data.ptr = client;
    if (::epoll_ctl(epoll_.get(), operation, descriptor, &event) != 0)
      throw std::system_error{errno, std::generic_category(), "epoll_ctl"};
  }

  void take(const epoll_event& event) {
    auto* const client = static_cast<Client*>(event.data.ptr);
    if (client == nullptr)
      accept();
    else if ((event.events & (EPOLLIN | EPOLLHUP | EPOLLERR)) != 0)
      read(*client);
  }

  void accept() {
    auto client = std::make_unique<Client>();
    client->socket = os::Descriptor{::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)};
    if (!client->socket) return;
    bench::send_at_once(client->socket);
    watch(EPOLL_CTL_ADD, client->socket.get(), EPOLLIN, client.get());
    bench::put_message(client->given, bench::GivenHead{}, {});
    clients_.push_back(std::move(client));
  }

  void read(Client& client) {
    if (bench::read_some(client.socket, client.asked) == Transfer::Failed) client.is_gone = true;
    while (const auto message = bench::first_of<bench::AskedHead>(client.asked)) {
      const std::chrono::nanoseconds now = std::chrono::system_clock::now().time_since_epoch();
      const bench::GivenHead head{.sequence = ++sequence_, .time_ns = now.count()};
      for (const auto& each : clients_) bench::put_message(each->given, head, message->bytes);
      client.asked.take(message->size());
    }
  }

  void send_to(Client& client) {
    const Transfer outcome = bench::write_all(client.socket, client.given);
    if (outcome == Transfer::Failed) client.is_gone = true;
    if (std::exchange(client.is_behind, outcome == Transfer::Waiting) != client.is_behind)
      watch(EPOLL_CTL_MOD, client.socket.get(), client.is_behind ? EPOLLIN | EPOLLOUT : EPOLLIN, &client);
  }

  os::Descriptor epoll_;
  os::Descriptor listener_;
  std::vector<std::unique_ptr<Client>> clients_;
  std::uint64_t sequence_ = 0;
};

}  // namespace

int main(int count, char** words) {
  constexpr int kUsage = 2;
  if (count != 2) {
    std::fputs("usage: sequencer ADDRESS:PORT\n", stderr);
    return kUsage;
  }
  try {
    Sequencer sequencer{words[1]};
    std::fputs("ready\n", stderr);
    sequencer.serve();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sequencer: %s\n", error.what());
    return 1;
  }
}
