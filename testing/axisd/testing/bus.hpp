#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <mutex>
#include <random>
#include <thread>

#include <linux/can.h>

#include "axisd/testing/process.hpp"

namespace axisd::testing {

/// A classical CAN frame as it has passed.
struct Frame {
  can_frame can{};
  double time = 0.0;  ///< end of the frame on the bus, s since 1970
  bool own = false;   ///< sent by this member

  [[nodiscard]] std::uint32_t identifier() const noexcept { return can.can_id & CAN_EFF_MASK; }
  /// As cansend takes it: 185#3716.
  [[nodiscard]] std::string text() const {
    std::array<char, 32> line{};
    const bool extended = (can.can_id & CAN_EFF_FLAG) != 0;
    int length = std::snprintf(line.data(), line.size(), extended ? "%08X#" : "%03X#", identifier());
    if ((can.can_id & CAN_RTR_FLAG) != 0) return std::string{line.data()} + 'R';
    for (int i = 0; i < can.can_dlc && i < CAN_MAX_DLEN; ++i)
      length +=
          std::snprintf(line.data() + length, line.size() - static_cast<std::size_t>(length), "%02X", can.data[i]);
    return line.data();
  }
};

/// A member of a user-space bus (docs/reference/user-space-bus-protocol.md), which reads all frames as they come.
class Bus {
 public:
  /// Joins the bus at @p path, which is served and whose time @p is_stepped or goes on by itself. Error.
  explicit Bus(const std::string& path, bool is_stepped = false)
      : socket_{::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0), "socket"}, is_stepped_{is_stepped} {
    take_name();
    const sockaddr_un address = address_of(path);
    if (::connect(socket_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
      throw Error{path + ": " + std::strerror(errno)};
    ask(kHello, 0, {});
    ask(kSetOption, 0, {1, 0, 0, 0, 1, 0, 0, 0});  // own frames, too
    ask(kBind, ask(kInterfaceIndex, 0, {'v', 'c', 'a', 'n', '0'}), {});
    reader_ = std::thread{[this] { read(); }};
  }
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;
  ~Bus() {
    ::shutdown(socket_.number(), SHUT_RDWR);
    reader_.join();
  }

  /// Sends a frame under @p identifier; Error.
  void send(std::uint32_t identifier, const std::vector<std::uint8_t>& data) {
    if (data.size() > CAN_MAX_DLEN)
      throw Error{"data: expected at most 8 bytes, got " + std::to_string(data.size())};
    can_frame frame{};
    frame.can_id = identifier > CAN_SFF_MASK ? identifier | CAN_EFF_FLAG : identifier;
    frame.can_dlc = static_cast<std::uint8_t>(data.size());
    std::copy(data.begin(), data.end(), frame.data);
    if (::send(socket_.number(), &frame, sizeof frame, MSG_NOSIGNAL) < 0)
      throw Error{std::string{"the hub has gone: "} + std::strerror(errno)};
  }

  /// What the hub answers, and its errno.
  struct Reply {
    std::int32_t error = 0;
    std::int32_t value = 0;
    std::string payload{};
  };
  /// Asks the hub about the faults of the bus: @p text and the payload of the reply are JSON. Error without a hub.
  Reply ask_about_faults(const std::string& text) { return request(kInject, 0, {text.begin(), text.end()}); }

  /// Lets stepped time go on, and reads what has come; Error if it is not stepped.
  void step(std::chrono::nanoseconds time) {
    const std::int64_t count = time.count();
    std::vector<std::uint8_t> payload(sizeof count);
    std::memcpy(payload.data(), &count, sizeof count);
    ask(kStep, 0, payload);
    const std::lock_guard lock{mutex_};
    read_all();
  }

  /// All frames so far, own ones among them.
  [[nodiscard]] std::vector<Frame> frames() const {
    const std::lock_guard lock{mutex_};
    return frames_;
  }

  /// The next frame of another member for which @p accepts holds; those before it are passed over. Timeout. Where
  /// time is stepped it goes on meanwhile, and @p patience is of that.
  Frame wait_for(const std::function<bool(const Frame&)>& accepts, const std::string& what,
                 Milliseconds patience) {
    if (is_stepped_) step(Milliseconds{0});  // what is to be done at the present has been done then
    std::unique_lock lock{mutex_};
    const auto end = std::chrono::steady_clock::now() + patience;
    Deadline steps{patience, [&] {
                     lock.unlock();
                     step(Milliseconds{1});
                     lock.lock();
                   }};
    while (true) {
      for (; next_ < frames_.size(); ++next_)
        if (!frames_[next_].own && accepts(frames_[next_])) return frames_[next_++];
      if (has_ended_) throw Error{"the hub has gone"};
      const bool is_late =
          is_stepped_ ? !steps.step()
                      : changed_.wait_until(lock, end) == std::cv_status::timeout && next_ == frames_.size();
      if (is_late)
        throw Timeout{what + " has not come within " + std::to_string(patience.count()) +
                      " ms; seen last:" + seen()};
    }
  }

 private:
  enum Operation : std::uint32_t {
    kHello = 0,
    kBind = 1,
    kSetOption = 3,
    kInterfaceIndex = 6,
    kInject = 11,
    kStep = 15
  };
  static constexpr std::size_t kLongestMessage = 8192;
  struct Message {
    can_frame frame;
    std::int32_t interface_index;
    std::uint32_t flags;
    std::int64_t time_ns;
    std::uint32_t dropped, origin;
  };

  /// The abstract name by which the hub knows what it is.
  void take_name() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::array<char, 48> name{};
    std::random_device random;
    const int length = std::snprintf(name.data(), name.size(), "can-bus.1/port/%08x%08x", random(), random());
    std::memcpy(address.sun_path + 1, name.data(), static_cast<std::size_t>(length));
    const auto size =
        static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + static_cast<std::size_t>(length));
    if (::bind(socket_.number(), reinterpret_cast<const sockaddr*>(&address), size) != 0)
      throw Error{std::string{"bind: "} + std::strerror(errno)};
  }

  /// The value of the reply; Error with what the hub says.
  std::int32_t ask(Operation operation, std::int32_t value, const std::vector<std::uint8_t>& payload) {
    const Reply reply = request(operation, value, payload);
    if (reply.error != 0) throw Error{std::strerror(reply.error)};
    return reply.value;
  }

  Reply request(Operation operation, std::int32_t value, const std::vector<std::uint8_t>& payload) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) throw Error{std::strerror(errno)};
    const Descriptor mine{ends[0], "socketpair"};
    Descriptor its{ends[1], "socketpair"};
    std::vector<std::uint8_t> asked(sizeof(std::uint32_t) * 3);
    const auto size = static_cast<std::uint32_t>(payload.size());
    std::memcpy(asked.data(), &operation, sizeof operation);
    std::memcpy(asked.data() + sizeof operation, &value, sizeof value);
    std::memcpy(asked.data() + sizeof operation + sizeof value, &size, sizeof size);
    asked.insert(asked.end(), payload.begin(), payload.end());
    iovec part{asked.data(), asked.size()};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> ancillary{};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = ancillary.data();
    message.msg_controllen = ancillary.size();
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(header), &ends[1], sizeof(int));
    if (::sendmsg(socket_.number(), &message, MSG_NOSIGNAL) < 0) throw Error{std::strerror(errno)};
    its = Descriptor{};
    std::vector<char> told(kLongestMessage);
    const ssize_t length = ::recv(mine.number(), told.data(), told.size(), 0);
    constexpr std::size_t kHead = 12;
    if (length < static_cast<ssize_t>(kHead)) throw Error{"the hub has gone"};
    Reply reply;
    std::memcpy(&reply.error, told.data(), sizeof reply.error);
    std::memcpy(&reply.value, told.data() + sizeof reply.error, sizeof reply.value);
    reply.payload.assign(told.data() + kHead, static_cast<std::size_t>(length) - kHead);
    return reply;
  }

  void read() {
    constexpr Milliseconds kForEver{-1};
    while (true) {
      readable(socket_.number(), kForEver);
      const std::lock_guard lock{mutex_};
      read_all();
      if (has_ended_) return;
    }
  }

  /// All that is there, with the mutex.
  void read_all() {
    constexpr double kSecondsOfNanosecond = 1e-9;
    while (!has_ended_) {
      Message message{};
      const ssize_t size = ::recv(socket_.number(), &message, sizeof message, MSG_DONTWAIT);
      if (size < 0 && errno == EINTR) continue;
      if (size < 0 && errno == EAGAIN) break;
      if (size <= 0) has_ended_ = true;
      if (size == sizeof message)
        frames_.push_back({message.frame, static_cast<double>(message.time_ns) * kSecondsOfNanosecond,
                           (message.flags & MSG_CONFIRM) != 0});
    }
    changed_.notify_all();
  }

  [[nodiscard]] std::string seen() const {
    constexpr std::size_t kTold = 20;
    std::string text;
    for (std::size_t i = frames_.size() > kTold ? frames_.size() - kTold : 0; i < frames_.size(); ++i)
      text += ' ' + frames_[i].text();
    return text.empty() ? " nothing" : text;
  }

  Descriptor socket_;
  bool is_stepped_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Frame> frames_;
  std::size_t next_ = 0;
  bool has_ended_ = false;
  std::thread reader_;
};

}  // namespace axisd::testing
