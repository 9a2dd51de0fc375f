#include "can/nats/nats_stream.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

#include <pthread.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>

namespace nats {

namespace {

using std::chrono::milliseconds;

/// Time for each step of the first attempt, and at least for those after a cut: the server is near then, or it is
/// as far away as it was.
constexpr milliseconds kFirstPatience{2000};
constexpr milliseconds kLeastPatience{250};
/// Between two attempts.
constexpr milliseconds kPause{50};

enum Ready : std::uint64_t { kBell, kSocket };

/// Where the stream has put a message: its reply subject says it, "$JS.ACK.STREAM.CONSUMER.DELIVERED.SEQUENCE.
/// CONSUMER_SEQUENCE.TIME.PENDING", of some servers with more tokens in front and one behind.
bool read_place(std::string_view subject, hub::trunk::Stream::Message& message) noexcept {
  constexpr std::size_t kTokens = 9;
  constexpr std::size_t kInFront = 2;  // of the longer form: domain and account
  std::array<std::string_view, kTokens + kInFront + 1> tokens;
  std::size_t count = 0;
  while (count < tokens.size()) {
    const std::size_t dot = subject.find('.');
    tokens[count++] = subject.substr(0, dot);
    if (dot == std::string_view::npos) break;
    subject.remove_prefix(dot + 1);
  }
  if (count < kTokens || tokens[0] != "$JS" || tokens[1] != "ACK") return false;
  const std::size_t shift = count == kTokens ? 0 : kInFront;
  constexpr std::size_t kSequence = 5;
  constexpr std::size_t kTime = 7;
  const auto number = [&](std::size_t place, auto& value) {
    const std::string_view text = tokens[place + shift];
    return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc{};
  };
  return number(kSequence, message.sequence) && number(kTime, message.time_ns);
}

}  // namespace

NatsStream::NatsStream(Bus bus) : bus_{std::move(bus)}, bell_{eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {
  if (!bell_ || !ready_.add(bell_.get(), EPOLLIN, kBell))
    throw std::system_error{errno, std::generic_category(), bus_.server.url};
  thread_ = std::jthread{[this](const std::stop_token& stop) { connect(stop); }};
}

NatsStream::~NatsStream() {
  message_.reset();
  thread_.request_stop();
  wanted_.notify_all();
  thread_.join();
}

void NatsStream::connect(const std::stop_token& stop) {
  pthread_setname_np(pthread_self(), "nats-connect");
  milliseconds patience = kFirstPatience;
  while (is_wanted(stop)) {
    const auto begin = std::chrono::steady_clock::now();
    auto member = join(bus_, patience);
    if (member) {
      constexpr int kMargin = 4;
      const auto needed = std::chrono::steady_clock::now() - begin;
      patience =
          std::clamp(std::chrono::duration_cast<milliseconds>(needed * kMargin), kLeastPatience, kFirstPatience);
      hand_over(*std::move(member));
    } else {
      report(member.error());
      wait(stop, kPause);
    }
  }
  nats_ReleaseThreadMemory();
}

/// Waits until a connection is wanted and closes the one before; false at the end.
bool NatsStream::is_wanted(const std::stop_token& stop) {
  std::unique_ptr<Membership> old;
  std::unique_lock lock{mutex_};
  wanted_.wait(lock, stop, [this] { return is_wanted_; });
  old = std::move(given_up_);
  lock.unlock();
  return !stop.stop_requested();
}

void NatsStream::wait(const std::stop_token& stop, milliseconds time) {
  std::unique_lock lock{mutex_};
  wanted_.wait_for(lock, stop, time, [] { return false; });
}

void NatsStream::hand_over(std::unique_ptr<Membership> member) {
  const std::scoped_lock lock{mutex_};
  made_ = std::move(member);
  is_wanted_ = false;
  told_.clear();
  ring();
}

void NatsStream::report(const std::string& problem) {
  const std::scoped_lock lock{mutex_};
  if (problem == told_) return;
  problem_ = problem;
  told_ = problem;
  ring();
}

void NatsStream::ring() noexcept {
  eventfd_write(bell_.get(), 1);
}

NatsStream::State NatsStream::advance() noexcept {
  while (const auto ready = ready_.take()) {
    if (ready->name == kBell) {
      accept();
    } else {
      serve_socket();
      break;  // messages first
    }
  }
  if (!member_) return State::Opening;
  return natsConnection_IsClosed(member_->connection.get()) ? State::Lost : State::Open;
}

void NatsStream::accept() noexcept {
  eventfd_t rings = 0;
  eventfd_read(bell_.get(), &rings);
  const std::scoped_lock lock{mutex_};
  if (!made_) return;
  member_ = std::move(made_);
  is_written_later_ = false;
  if (!ready_.add(member_->socket, EPOLLIN, kSocket)) natsConnection_Close(member_->connection.get());
}

void NatsStream::serve_socket() noexcept {
  if (!member_) return;
  natsConnection_ProcessReadEvent(member_->connection.get());
  if (member_->wants_to_write) write();
}

bool NatsStream::receive(Message& message) noexcept {
  for (;;) {
    message_.reset();
    natsMsg* next = nullptr;
    if (!member_ || natsSubscription_NextMsg(&next, member_->subscription.get(), 0) != NATS_OK) return false;
    message_.reset(next);
    const char* const place = natsMsg_GetReply(next);
    if (place == nullptr || !read_place(place, message))
      continue;  // of the server to its client, not of the stream
    message.bytes =
        std::as_bytes(std::span{natsMsg_GetData(next), static_cast<std::size_t>(natsMsg_GetDataLength(next))});
    return true;
  }
}

void NatsStream::publish(std::span<const std::byte> bytes) noexcept {
  if (!member_) return;
  natsConnection_Publish(member_->connection.get(), bus_.subject().c_str(), bytes.data(),
                         static_cast<int>(bytes.size()));
  write();
}

void NatsStream::write() noexcept {
  natsConnection_ProcessWriteEvent(member_->connection.get());
  if (std::exchange(is_written_later_, member_->wants_to_write) == member_->wants_to_write) return;
  const unsigned wanted = is_written_later_ ? EPOLLIN | EPOLLOUT : EPOLLIN;
  if (!ready_.change(member_->socket, wanted, kSocket)) natsConnection_Close(member_->connection.get());
}

void NatsStream::reopen() noexcept {
  message_.reset();
  if (member_) ready_.remove(member_->socket);
  const std::scoped_lock lock{mutex_};
  given_up_ = std::move(member_);
  made_.reset();
  is_wanted_ = true;
  wanted_.notify_all();
}

std::string NatsStream::take_problem() {
  const std::scoped_lock lock{mutex_};
  return std::exchange(problem_, {});
}

}  // namespace nats
