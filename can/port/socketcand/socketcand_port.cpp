#include "can/port/socketcand/socketcand_port.hpp"

#include <cerrno>
#include <cstring>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/epoll.h>

namespace bus {

namespace {

using socketcand::Client;

/// What one attempt to connect may take.
constexpr std::chrono::milliseconds kPatience{5000};
// Messages that are of no account are skipped; this many a call, so that a burst of them cannot hold the caller.
constexpr int kSkippedMessages = 16;

std::string name_of_server(const SocketcandServer& place) {
  const bool is_six = place.host.find(':') != std::string::npos;
  return fmt::format("{}{}{}:{}", is_six ? "[" : "", place.host, is_six ? "]" : "", place.port);
}

}  // namespace

SocketcandPort::SocketcandPort(SocketcandServer place) : place_{std::move(place)} {
  resolve();
  if (!attempt_.add(timer_.descriptor(), EPOLLIN))
    throw std::system_error{errno, std::generic_category(), "epoll_ctl"};
  while (attempts_ < addresses_.size() && !is_open()) {
    begin();
    while (client_.stage() != Client::Stage::Closed && !is_open()) {
      pollfd wanted{attempt_.descriptor(), POLLIN, 0};
      ::poll(&wanted, 1, -1);  // the timer of the attempt ends it
      if (timer_.take()) throw OpenError{fmt::format("{}: no answer in five seconds", name_of_server(place_))};
      go_on();
    }
  }
  if (!is_open()) throw OpenError{fmt::format("{}: {}", name_of_server(place_), client_.problem())};
}

void SocketcandPort::resolve() {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* list = nullptr;
  const int error = ::getaddrinfo(place_.host.c_str(), std::to_string(place_.port).c_str(), &wanted, &list);
  if (error != 0) throw OpenError{fmt::format("{}: {}", name_of_server(place_), ::gai_strerror(error))};
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner{list, ::freeaddrinfo};
  for (const addrinfo* entry = list; entry != nullptr; entry = entry->ai_next) {
    SocketAddress& address = addresses_.emplace_back();
    std::memcpy(&address.storage, entry->ai_addr, entry->ai_addrlen);
    address.length = entry->ai_addrlen;
  }
}

void SocketcandPort::begin() {
  timer_.limit(kPatience);
  if (client_.begin(addresses_[attempts_++ % addresses_.size()], place_.bus))
    watch_attempt();
  else
    give_up();
}

/// Connecting shows itself by a writable socket, the rest by a readable one.
void SocketcandPort::watch_attempt() noexcept {
  const bool connecting = client_.stage() == Client::Stage::Connecting;
  attempt_.remove(client_.descriptor());
  static_cast<void>(attempt_.add(client_.descriptor(), connecting ? EPOLLOUT : EPOLLIN));  // or the timer ends it
}

void SocketcandPort::go_on() {
  const Client::Stage before = client_.stage();
  client_.advance();
  const Client::Stage after = client_.stage();
  if (after == Client::Stage::Closed) return give_up();
  if (after == Client::Stage::Raw) {
    attempt_.remove(client_.descriptor());
    timer_.stop();
    if (!pollable_.add(client_.descriptor(), EPOLLIN)) give_up();
  } else if (after != before) {
    watch_attempt();
  }
}

void SocketcandPort::give_up() {
  client_.close();
  timer_.start_later();
}

bool SocketcandPort::advance() {
  if (is_open()) return false;
  const bool connecting = client_.stage() != Client::Stage::Closed;
  if (!timer_.take()) {
    if (connecting) go_on();
  } else if (connecting) {
    give_up();
  } else {
    begin();
  }
  return is_open();
}

bool SocketcandPort::reopen() noexcept {
  constexpr int kMost = 1 << 20;  // a bus that never stops must not hold the caller
  std::string_view text;
  for (int i = 0; i < kMost && is_open(); ++i) {
    const Client::Found found = client_.read(text);
    if (found == Client::Found::Nothing || found == Client::Found::End) break;  // receive() tells the end
  }
  return is_open();
}

SendStatus SocketcandPort::send(const canopen::Frame& frame) noexcept {
  return is_open() ? client_.send(frame) : SendStatus::Down;
}

Received SocketcandPort::receive(canopen::Frame& frame) noexcept {
  std::string_view text;
  for (int i = 0; i < kSkippedMessages && is_open(); ++i) {
    const Client::Found found = client_.read(text);
    if (found == Client::Found::Nothing) break;
    if (found == Client::Found::End) return server_lost();
    const auto message =
        found == Client::Found::Text ? socketcand::parse(text) : tl::unexpected{std::string_view{"too long"}};
    if (!message) {
      ++rejected_;
    } else if (const auto* const seen = std::get_if<socketcand::FrameSeen>(&*message);
               seen != nullptr && filters_.pass(seen->frame)) {
      frame = seen->frame;
      return {Received::Frame, ErrorState::Active};
    }
  }
  return {Received::Nothing, ErrorState::Active};
}

Received SocketcandPort::server_lost() noexcept {
  client_.close();
  timer_.start();
  return {Received::Down, ErrorState::Active};
}

std::optional<LinkState> SocketcandLink::read() noexcept {
  return port_.advance() ? std::optional{LinkState::Up} : std::nullopt;
}

}  // namespace bus
