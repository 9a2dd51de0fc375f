#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

#include <sys/socket.h>

#include "bench/operations/frames.hpp"
#include "bench/operations/operation.hpp"
#include "can/hub/member/raw_member.hpp"

namespace bench {
namespace {

using userbus::FrameMessage;

constexpr canid_t kIdentifier = 0x181;
constexpr canid_t kOther = 0x182;

can_filter only_data(canid_t identifier) {
  return {identifier, CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG};
}

/// The far end of a member: its program.
class Program {
 public:
  /// Messages that wait in a socket before they are read, all at once.
  static constexpr std::size_t kMessages = 64;

  explicit Program(int socket) : socket_{socket} {
    for (std::size_t i = 0; i < kMessages; ++i) {
      parts_[i] = {rooms_[i].data(), sizeof rooms_[i]};
      headers_[i].msg_hdr.msg_iov = &parts_[i];
      headers_[i].msg_hdr.msg_iovlen = 1;
    }
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(const std::vector<FrameMessage>& frames) const {
    ::send(socket_.get(), frames.data(), frames.size() * sizeof frames[0], MSG_DONTWAIT);
  }
  /// How many frames have come.
  std::size_t read() {
    const int count = recvmmsg(socket_.get(), headers_.data(), kMessages, MSG_DONTWAIT, nullptr);
    std::size_t frames = 0;
    for (int i = 0; i < count; ++i) frames += headers_[static_cast<std::size_t>(i)].msg_len / sizeof(FrameMessage);
    return frames;
  }

 private:
  os::Descriptor socket_;
  std::array<std::array<FrameMessage, userbus::kMostFrames>, kMessages> rooms_;
  std::array<iovec, kMessages> parts_{};
  std::array<mmsghdr, kMessages> headers_{};
};

/// How many members there are, how many of them hear, and how many frames come in a message.
struct Shape {
  std::size_t members;
  std::size_t hearers;
  std::size_t frames;
};

/// One message that a member sends, to all others who hear it.
template <Shape kShape>
class Spreading {
 public:
  Spreading() {
    const int index = core_.interfaces.index_of("vcan0");
    for (std::size_t i = 0; i < kShape.members; ++i) add_member(index, i == 0 || i > kShape.hearers);
    step();
    for (std::size_t i = 0; i < programs_.size(); ++i)
      check(programs_[i]->read() == (i > 0 && i <= kShape.hearers ? kShape.frames : 0),
            "frames that members hear");
  }
  void step() {
    programs_.front()->send(message_);
    core_.members.front()->on_events(EPOLLIN);
    core_.hand_over();
    if (++steps_ % Program::kMessages == 0)
      for (std::size_t i = 1; i <= kShape.hearers; ++i) programs_[i]->read();
  }

 private:
  void add_member(int index, bool is_deaf) {
    std::array<int, 2> ends{};
    check(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()) == 0, "a socket");
    programs_.push_back(std::make_unique<Program>(ends[1]));
    auto member = std::make_unique<hub::RawMember>(core_, os::Descriptor{ends[0]}, userbus::Kind::Port);
    check(member->begin(), "a member");
    const std::array filters{only_data(is_deaf ? kOther : kIdentifier)};
    member->set_filters(filters);
    member->agree_on_frames(kShape.frames);
    member->bind(index);
    core_.members.push_back(std::move(member));
  }
  static std::vector<FrameMessage> message_of_frames() {
    FrameMessage frame{};
    frame.frame.can_id = kIdentifier;
    frame.frame.can_dlc = CAN_MAX_DLEN;
    return std::vector<FrameMessage>(kShape.frames, frame);
  }

  std::vector<std::unique_ptr<Program>> programs_;
  hub::Core core_{0, {userbus::TimeMode::Real, 1}};
  std::vector<FrameMessage> message_ = message_of_frames();
  std::size_t steps_ = 0;
};

}  // namespace

std::vector<OperationRow> hub_operations() {
  constexpr std::size_t kBurst = userbus::kMostFrames;
  return {
      {"hub/all_2", "a frame of one of two members, which the other one hears", make<Spreading<Shape{2, 1, 1}>>},
      {"hub/all_8", "the same of 8 members, 7 of whom hear it", make<Spreading<Shape{8, 7, 1}>>},
      {"hub/all_32", "the same of 32", make<Spreading<Shape{32, 31, 1}>>},
      {"hub/all_127", "the same of 127", make<Spreading<Shape{127, 126, 1}>>},
      {"hub/burst_127", "32 frames in one message to 126 others", make<Spreading<Shape{127, 126, kBurst}>>},
      {"hub/one_127", "a frame that all but one of 127 members filter out", make<Spreading<Shape{127, 1, 1}>>},
  };
}

}  // namespace bench
