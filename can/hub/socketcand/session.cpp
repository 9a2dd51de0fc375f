#include "can/hub/socketcand/session.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <span>
#include <utility>
#include <variant>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "can/port/wire.hpp"

namespace hub::socketcand {

namespace {

using bus::socketcand::Message;
using bus::socketcand::MessageReader;
using bus::socketcand::Room;

constexpr std::int64_t kNanosecondsOfMicrosecond = 1000;

/// Stands before every frame. Some clients skip one character behind a message, which must not be the next one's.
constexpr char kSeparator = '\n';

constexpr std::string_view kNoBus = "open a bus first";

/// Clients that leave Nagle's algorithm on send their next frame only when this one is confirmed, which the kernel
/// would put off by 40 ms. It forgets this wish with every reading.
void confirm_at_once(int socket) noexcept {
  constexpr int kOn = 1;
  ::setsockopt(socket, IPPROTO_TCP, TCP_QUICKACK, &kOn, sizeof kOn);
}

}  // namespace

Counters& Counters::operator+=(const Counters& more) noexcept {
  sent += more.sent;
  received += more.received;
  dropped += more.dropped;
  untold += more.untold;
  return *this;
}

/// What the session does with a message of each kind.
struct Session::Handler {
  Session& session;
  std::string_view text;
  canopen::TimePoint now;

  void operator()(const bus::socketcand::Open& open) const noexcept {
    if (session.interface_index_ != 0) return session.refuse("the bus is open already");
    session.interface_index_ = session.interfaces_.index_of(open.name);
    if (session.interface_index_ == 0)
      return session.refuse("a bus is called can0, vcan1 or the like, not", open.name);
    session.answer(bus::socketcand::Ok{});
  }
  void operator()(bus::socketcand::RawMode) const noexcept {
    if (session.interface_index_ == 0) return session.refuse(kNoBus);
    session.answer(bus::socketcand::Ok{});
    session.raw_ = true;
    session.silent_until_ = now + kSilence;
  }
  void operator()(bus::socketcand::Echo echo) const noexcept { session.answer(echo); }
  void operator()(const bus::socketcand::Send& send) const noexcept {
    if (session.interface_index_ == 0) return session.refuse(kNoBus);
    session.send(send.frame, now);
  }
  void operator()(bus::socketcand::Hi) const noexcept { refuse_answer(); }
  void operator()(bus::socketcand::Ok) const noexcept { refuse_answer(); }
  void operator()(const bus::socketcand::Error&) const noexcept { refuse_answer(); }
  void operator()(const bus::socketcand::FrameSeen&) const noexcept { refuse_answer(); }

 private:
  void refuse_answer() const noexcept { session.refuse("a client does not say that", text); }
};

Session::Session(Medium& medium, Interfaces& interfaces, os::Descriptor socket, int poll)
    : medium_{medium}, interfaces_{interfaces}, socket_{std::move(socket)}, poll_{poll} {
  medium_.attach(*this);
  update_watch();
  answer(bus::socketcand::Hi{});
}

Session::~Session() {
  medium_.detach(*this);
}

void Session::on_events(std::uint32_t events, canopen::TimePoint now) noexcept {
  if ((events & EPOLLOUT) != 0) flush();
  if ((events & EPOLLIN) != 0 && !refused_)
    read(now);
  else if ((events & (EPOLLHUP | EPOLLERR)) != 0)
    end();
  update_watch();
}

void Session::on_time(canopen::TimePoint now) noexcept {
  if (now < silent_until_) return;
  end_silence();
  update_watch();
}

/// Reads once; what is left polls readable again.
void Session::read(canopen::TimePoint now) noexcept {
  const std::span<char> room = reader_.room();
  const ssize_t size = ::recv(socket_.get(), room.data(), room.size(), MSG_DONTWAIT);
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (size <= 0) return end();
  confirm_at_once(socket_.get());
  reader_.filled(static_cast<std::size_t>(size));
  handle_messages(now);
}

void Session::handle_messages(canopen::TimePoint now) noexcept {
  using Kind = MessageReader::Found::Kind;
  while (!refused_ && !over_) {
    const MessageReader::Found found = reader_.next();
    if (found.kind == Kind::Nothing) return;
    end_silence();
    if (found.kind == Kind::TooLong)
      refuse("a message has at most 256 characters");
    else
      handle(found.text, now);
  }
}

void Session::handle(std::string_view text, canopen::TimePoint now) noexcept {
  const auto message = bus::socketcand::parse(text);
  if (message)
    std::visit(Handler{*this, text, now}, *message);
  else
    refuse(message.error(), text);
}

void Session::send(const canopen::Frame& frame, canopen::TimePoint now) noexcept {
  Passage passage;
  passage.frame = bus::to_wire(frame);
  passage.sender = this;
  passage.interface_index = interface_index_;
  passage.local = false;
  ++counters_.sent;
  if (!medium_.send(passage, now)) refused_ = passage;
}

void Session::on_room() noexcept {
  if (!refused_ || !medium_.send(*refused_, medium_.now())) return;
  refused_.reset();
  handle_messages(medium_.now());
  update_watch();
}

void Session::receive(const Passage& passage) noexcept {
  if (!raw_ || over_ || passage.sender == this) return;
  if ((passage.frame.can_id & (CAN_RTR_FLAG | CAN_ERR_FLAG)) != 0) {
    ++counters_.untold;
    return;
  }
  Room room{};
  const bus::socketcand::FrameSeen seen{bus::from_wire(passage.frame),
                                        passage.time_ns / kNanosecondsOfMicrosecond};
  const std::string_view text = print(seen, room);
  std::array<char, bus::socketcand::kLongestMessage + 1> separated{};
  separated.front() = kSeparator;
  text.copy(separated.data() + 1, text.size());
  const bool kept = output_.push({separated.data(), text.size() + 1});
  ++(kept ? counters_.received : counters_.dropped);
  if (silent_until_ != canopen::kNever) return;
  flush();
  update_watch();
}

/// Each answer goes out by itself: clients take what comes at once for one answer. One who does not read his
/// answers is given up.
void Session::answer(const Message& message) noexcept {
  Room room{};
  if (output_.push(print(message, room)))
    flush();
  else
    end();
}

void Session::refuse(std::string_view reason, std::string_view what) noexcept {
  constexpr std::string_view kBetween = ": ";
  if (what.starts_with("< ") && what.ends_with(" >")) what = what.substr(2, what.size() - 4);
  std::array<char, bus::socketcand::kLongestMessage> text{};
  std::size_t size = reason.copy(text.data(), text.size());
  if (!what.empty()) {
    size += kBetween.copy(text.data() + size, text.size() - size);
    size += what.copy(text.data() + size, text.size() - size);
  }
  answer(bus::socketcand::Error{{text.data(), size}});
}

void Session::end_silence() noexcept {
  if (std::exchange(silent_until_, canopen::kNever) != canopen::kNever) flush();
}

void Session::flush() noexcept {
  if (!output_.flush(socket_.get())) end();
}

void Session::end() noexcept {
  over_ = true;
  ::shutdown(socket_.get(), SHUT_RDWR);
}

/// Watches for room in the socket only while text waits for it, and for text only while frames find room.
void Session::update_watch() noexcept {
  const bool writes = !output_.empty() && silent_until_ == canopen::kNever;
  const bool reads = !refused_ || over_;
  epoll_event wanted{};
  wanted.events = EPOLLHUP | (reads ? std::uint32_t{EPOLLIN} : 0U) | (writes ? std::uint32_t{EPOLLOUT} : 0U);
  wanted.data.ptr = this;
  if (wanted.events == watched_) return;
  const int operation = watched_ == 0 ? EPOLL_CTL_ADD : EPOLL_CTL_MOD;
  if (::epoll_ctl(poll_, operation, socket_.get(), &wanted) != 0) end();
  watched_ = wanted.events;
}

}  // namespace hub::socketcand
