#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include <sys/types.h>

#include "can/hub/member/core.hpp"
#include "can/hub/member/outbox.hpp"
#include "can/userbus/name.hpp"
#include "os/descriptor.hpp"

namespace hub {

/// A program's socket on the bus: reads its messages, keeps its state, and leaves when the program closes it.
/// What becomes of its frames is up to the kind of the member.
class Member : public Watch {
 public:
  /// Takes over @p socket, which accept(2) gave; std::bad_alloc.
  Member(Core& core, os::Descriptor socket, userbus::Kind kind);
  Member(const Member&) = delete;
  Member& operator=(const Member&) = delete;
  ~Member() override;

  /// Begins to read; false if the kernel has no memory for that.
  [[nodiscard]] bool begin() noexcept;
  void on_events(std::uint32_t events) noexcept final;
  /// True if it has closed its socket and everything that it had sent is on the bus: it may be destroyed.
  [[nodiscard]] bool departed() const noexcept { return phase_ == Phase::Departed; }

  /// Its own interface: 0 = all, -1 = not bound yet.
  [[nodiscard]] int interface_index() const noexcept { return interface_index_; }
  /// Binds it to @p interface_index, which exists or is 0.
  void bind(int interface_index) noexcept;
  /// Agrees with the program upon several frames in a message: it takes @p most of them (1..); how many the hub
  /// takes from now on.
  virtual std::size_t agree_on_frames(std::size_t) noexcept { return 1; }
  /// Whether it is a bridge of another hub, whose frames carry marks.
  [[nodiscard]] bool is_bridge() const noexcept { return is_bridge_; }
  void set_bridge(bool is_bridge) noexcept { is_bridge_ = is_bridge; }
  [[nodiscard]] std::uint32_t option(userbus::OptionName name) const noexcept {
    return options_[static_cast<std::size_t>(name)];
  }
  /// Sets @p option, whose name must be one of OptionName; errno, 0 = done.
  int set_option(const userbus::Option& option) noexcept;
  [[nodiscard]] userbus::MemberState state() const noexcept;
  [[nodiscard]] userbus::MemberStatistics statistics() const noexcept;
  /// Who has connected it; 0: unknown.
  [[nodiscard]] pid_t process() const noexcept { return process_; }
  /// Who it is on the medium.
  [[nodiscard]] Identity who() const noexcept;

  /// Tells the program that the bus is cut, or whole again; if it has not read and there is no room, as soon as
  /// there is.
  void tell_link(bool up) noexcept;
  /// Reads what the program has sent until now, and no more than a socket holds: the number of messages. What the
  /// bus has no room for stays where it is, unless @p is_asked: a request may be behind it.
  std::size_t drain(bool is_asked = false) noexcept;
  /// Sends what waits because the program had not read; true if some of it went out.
  bool catch_up() noexcept;
  /// True, once, if it was not read for a while, as the medium had no room for its frames, and has room now.
  [[nodiscard]] bool takes_up_reading() noexcept { return std::exchange(reads_again_, false); }
  /// Messages that were left in its socket, as far as they have been looked at.
  [[nodiscard]] std::size_t unread() const noexcept { return unread_; }
  /// Sends the frames that were gathered for the program.
  void hand_over() noexcept {
    is_gathering_ = false;
    write_gathered();
  }
  /// The program gets something, or has room: it is owed a turn where the bus's time goes by turns.
  void note_given() const noexcept {
    if (core_.turns != nullptr) core_.turns->on_given(process_);
  }

  /// Filters of a raw socket; errno, 0 = done.
  virtual int set_filters(std::span<const can_filter> filters) noexcept;
  [[nodiscard]] virtual std::span<const can_filter> filters() const noexcept { return {}; }
  /// A message for the broadcast manager, which names @p interface_index, 0 = none; errno, 0 = done.
  virtual int broadcast(std::span<const std::byte> message, int interface_index, canopen::TimePoint now) noexcept;
  /// When on_time() is wanted.
  [[nodiscard]] virtual canopen::TimePoint next_deadline() const noexcept { return canopen::kNever; }
  virtual void on_time(canopen::TimePoint) noexcept {}

 protected:
  /// A frame of the program: what it is, the interface that it was sent on, where it came up.
  struct Sent {
    can_frame frame{};
    int interface_index = 0;
    bus::Mark mark;
  };

  [[nodiscard]] Core& core() const noexcept { return core_; }
  void count_sent() noexcept { ++sent_; }
  /// Sends @p message to the program.
  void deliver(std::span<const std::byte> message) noexcept;
  /// A frame more for the program, to be filled in; it goes with Core::hand_over().
  [[nodiscard]] userbus::FrameMessage& gather() noexcept {
    if (outbox_.has_none() || outbox_.is_full()) begin_gathering();
    return outbox_.add();
  }
  /// Up to @p most frames go to the program in one message from now on, and up to @p most_taken come in one.
  void set_most_frames(std::size_t most, std::size_t most_taken) noexcept;
  /// Counter of what was lost because the program did not read.
  [[nodiscard]] std::uint32_t dropped() const noexcept { return outbox_.dropped(); }
  /// To be called when something that may_read() or is_done() depends on has changed outside of take_frame().
  void go_on() noexcept;

 private:
  /// Reading; closed by the program, and not read to the end; read to the end; nothing of it left on the bus.
  enum class Phase : std::uint8_t { Open, Closed, ReadOut, Departed };

  /// Takes what is no request; false if it is nothing that a member of this kind says.
  [[nodiscard]] virtual bool take_message(std::span<const std::byte> bytes, canopen::TimePoint now) noexcept {
    return take_frames(bytes, now);
  }
  /// Puts @p sent on the bus; false if it is refused for good.
  virtual bool take_frame(const Sent& sent, canopen::TimePoint now) noexcept = 0;
  virtual void option_changed(userbus::OptionName, std::uint32_t) noexcept {}
  /// It is bound to another interface.
  virtual void bound() noexcept {}
  /// Messages whose frames take_frame() can be sure to find room for; 0: none is read at present.
  [[nodiscard]] virtual std::size_t may_read() const noexcept { return Inbox::kBatch; }
  /// True if no frame of this member waits for the bus.
  [[nodiscard]] virtual bool is_done() const noexcept { return true; }

  void on_events_of_turns(std::uint32_t events) noexcept;
  void look() noexcept;
  bool has_request() noexcept;
  void flush() noexcept;
  std::size_t read(std::size_t most) noexcept;
  void take(Inbox::Message message, canopen::TimePoint read_at) noexcept;
  [[nodiscard]] bool take_frames(std::span<const std::byte> bytes, canopen::TimePoint now) noexcept;
  [[nodiscard]] bool take_frame(const userbus::FrameMessage& message, canopen::TimePoint now) noexcept;
  void begin_gathering() noexcept;
  void write_gathered() noexcept {
    const bool was_empty = outbox_.empty();
    outbox_.hand_over();
    if (was_empty && !outbox_.empty()) update_watch();
  }
  [[nodiscard]] std::uint32_t watch_of_turns(std::uint32_t wanted) noexcept;
  void update_watch() noexcept;

  Core& core_;
  os::Descriptor socket_;
  int interface_index_ = -1;
  bool is_bridge_ = false;
  bool can_look_ = false;      // into the socket, for requests; only where programs take turns
  bool is_gathering_ = false;  // it is in Core::gathering
  Outbox outbox_;
  std::size_t unread_ = 0;      // messages that has_request() has seen and that were left in the socket
  std::size_t most_taken_ = 1;  // frames in a message of the program
  userbus::Kind kind_;
  Phase phase_ = Phase::Open;
  bool can_be_read_ = true;     // the medium has room
  bool reads_again_ = false;    // since takes_up_reading()
  bool is_cut_untold_ = false;  // there was no room to tell that the bus is cut, or whole again
  std::array<std::uint32_t, userbus::kOptionCount> options_{};
  std::uint32_t watched_ = 0;  // events; 0 = the socket is not watched
  pid_t process_ = 0;
  std::uint64_t sent_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace hub
