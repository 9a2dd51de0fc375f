#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <linux/can/bcm.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <poll.h>
#include <sys/socket.h>

#include "can/hub/broadcast/broadcast_manager.hpp"
#include "os/descriptor.hpp"
#include "tests/can/hub/told.hpp"

/// The hub's broadcast manager does what the kernel's does: both get the same random requests and frames.
namespace {

using Bytes = std::vector<std::byte>;
using Texts = std::vector<std::string>;

constexpr const char* kInterface = "vcan0";
constexpr std::uint32_t kMarker = 0x7FF;
constexpr int kModelIndex = 1001;

/// What happens in one step: a request, or else a frame of another program.
struct Step {
  Bytes request{};
  bool names_interface = false;
  can_frame frame{};
};

/// What a step leads to.
struct Outcome {
  int error = 0;
  Texts told;  ///< by the broadcast manager
  Texts seen;  ///< on the bus

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Every bit of a message, with the interface as 0 or 1.
std::string text_of(std::span<const std::byte> message, bool interface) {
  std::string text = interface ? "1:" : "0:";
  char digits[3];
  for (const std::byte each : message) {
    std::snprintf(digits, sizeof digits, "%02X", std::to_integer<unsigned>(each));
    text += digits;
  }
  return text;
}

/// CAN_BCM of the kernel, and a program beside it.
class Kernel {
 public:
  Kernel() : index_{static_cast<int>(if_nametoindex(kInterface))} {
    const sockaddr_can any = address(0);
    const sockaddr_can here = address(index_);
    constexpr int kOn = 1;
    EXPECT_GT(index_, 0) << kInterface;
    EXPECT_EQ(connect(manager_.get(), reinterpret_cast<const sockaddr*>(&any), sizeof any), 0);
    EXPECT_EQ(setsockopt(program_.get(), SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, &kOn, sizeof kOn), 0);
    EXPECT_EQ(bind(program_.get(), reinterpret_cast<const sockaddr*>(&here), sizeof here), 0);
  }

  Outcome play(const Step& step) {
    Outcome outcome;
    if (step.request.empty()) {
      send_frame(step.frame);
    } else {
      const sockaddr_can to = address(step.names_interface ? index_ : 0);
      const ssize_t sent = sendto(manager_.get(), step.request.data(), step.request.size(), 0,
                                  reinterpret_cast<const sockaddr*>(&to), sizeof to);
      outcome.error = sent < 0 ? errno : 0;
    }
    outcome.seen = frames_up_to_a_marker();
    outcome.told = messages();
    return outcome;
  }

 private:
  static sockaddr_can address(int index) {
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = index;
    return address;
  }
  void send_frame(const can_frame& frame) const {
    EXPECT_EQ(write(program_.get(), &frame, sizeof frame), static_cast<ssize_t>(sizeof frame));
  }
  Texts frames_up_to_a_marker() const {
    can_frame frame{};
    frame.can_id = kMarker;
    send_frame(frame);
    Texts seen;
    while (recv(program_.get(), &frame, sizeof frame, 0) == sizeof frame && frame.can_id != kMarker)
      seen.push_back(told::text_of(frame));
    return seen;
  }
  Texts messages() const {
    Texts told;
    std::array<std::byte, userbus::kLongestMessage> message{};
    sockaddr_can from{};
    for (;;) {
      socklen_t length = sizeof from;
      const ssize_t size = recvfrom(manager_.get(), message.data(), message.size(), MSG_DONTWAIT,
                                    reinterpret_cast<sockaddr*>(&from), &length);
      if (size < 0) return told;
      told.push_back(text_of(std::span{message}.first(static_cast<std::size_t>(size)), from.can_ifindex != 0));
    }
  }

  int index_;
  os::Descriptor manager_{socket(PF_CAN, SOCK_DGRAM, CAN_BCM)};
  os::Descriptor program_{socket(PF_CAN, SOCK_RAW, CAN_RAW)};
};

/// The hub's broadcast manager on a medium, and a program beside it.
class Model final : hub::BroadcastSink {
 public:
  Model() { medium_.attach(program_); }

  Outcome play(const Step& step) {
    Outcome outcome;
    now_ += std::chrono::milliseconds{1};
    if (step.request.empty()) {
      hub::Passage passage;
      passage.frame = step.frame;
      passage.sender = &program_;
      passage.interface_index = kModelIndex;
      medium_.send(passage, now_);
    } else {
      outcome.error = manager_.request(step.request, step.names_interface ? kModelIndex : 0, now_);
    }
    medium_.on_time(now_);
    manager_.on_time(now_);
    outcome.seen = std::exchange(program_.seen, {});
    outcome.told = std::exchange(told_, {});
    return outcome;
  }

 private:
  void deliver(std::span<const std::byte> message, int interface_index) noexcept override {
    told_.push_back(text_of(message, interface_index != 0));
  }

  canopen::TimePoint now_ = told::kStart;
  Texts told_;
  told::Listener program_;
  hub::Medium medium_;
  hub::BroadcastManager manager_{medium_, *this};
};

/// Steps that meet each other: few identifiers, few values, every operation and flag.
class Chance {
 public:
  explicit Chance(unsigned seed) : random_{seed} {}

  Step step() {
    if (below(2) == 0) return {.frame = frame()};
    return {.request = request(), .names_interface = below(5) != 0};
  }

 private:
  static constexpr std::array<canid_t, 3> kIdentifiers{0x123, 0x124, 0x123 | CAN_RTR_FLAG};
  static constexpr std::array<std::uint32_t, 10> kOperations{TX_SETUP,  TX_SETUP,  RX_SETUP, RX_SETUP, RX_SETUP,
                                                             TX_DELETE, RX_DELETE, TX_READ,  RX_READ,  TX_SEND};

  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }
  canid_t identifier() { return kIdentifiers[below(kIdentifiers.size())]; }

  can_frame frame() {
    can_frame frame{};
    frame.can_id = identifier();
    frame.can_dlc = static_cast<std::uint8_t>(below(3) == 0 ? below(CAN_MAX_DLEN + 1) : 2);
    for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(below(2) == 0 ? 0xFF : below(4));
    return frame;
  }

  /// Each flag in one of four requests. Where kernels differ, they are not asked: CAN FD, and timers together with
  /// the answering of remote frames.
  std::uint32_t flags() {
    std::uint32_t flags = 0;
    for (std::uint32_t flag = SETTIMER; flag <= RX_RTR_FRAME; flag <<= 1U) flags |= below(4) == 0 ? flag : 0;
    if (below(3) != 0) flags &= ~std::uint32_t{RX_FILTER_ID};
    if (below(2) == 0) flags &= ~std::uint32_t{RX_RTR_FRAME};
    return (flags & RX_RTR_FRAME) != 0 ? flags & ~std::uint32_t{SETTIMER} : flags;
  }

  /// Intervals are so long that no timer ends, but throttling and its flush can be seen.
  Bytes request() {
    bcm_msg_head head{};
    head.opcode = below(40) == 0 ? below(16) : kOperations[below(kOperations.size())];
    head.flags = flags();
    head.count = below(3);
    head.ival1.tv_sec = below(2) * 1000;
    head.ival2.tv_sec = below(3) == 0 ? 1000 : 0;
    head.ival2.tv_usec = below(60) == 0 ? 1'000'000 : 0;
    head.can_id = identifier();
    const std::uint32_t frames = below(50) == 0 ? 255 + below(5) : below(5);
    head.nframes = below(30) == 0 ? below(260) : frames;
    Bytes bytes(sizeof head + frames * sizeof(can_frame));
    std::memcpy(bytes.data(), &head, sizeof head);
    for (std::uint32_t i = 0; i < frames; ++i) {
      can_frame each = frame();
      const bool too_long = (head.flags & RX_RTR_FRAME) == 0 && below(30) == 0;
      if (too_long) each.can_dlc = CAN_MAX_DLEN + 1;
      std::memcpy(bytes.data() + sizeof head + i * sizeof each, &each, sizeof each);
    }
    if (below(40) == 0) bytes.resize(1 + below(static_cast<std::uint32_t>(bytes.size())));
    return bytes;
  }

  std::mt19937 random_;
};

TEST(BroadcastManagerAndKernel, DoTheSame) {
  const unsigned seed = told::seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  RecordProperty("seed", std::to_string(seed));
  Chance chance{seed};
  Kernel kernel;
  Model model;
  for (int i = 0; i < 5000; ++i) {
    const Step step = chance.step();

    const Outcome expected = kernel.play(step);
    const Outcome outcome = model.play(step);

    ASSERT_EQ(outcome.error, expected.error) << "step " << i << ' ' << text_of(step.request, step.names_interface);
    ASSERT_EQ(outcome.told, expected.told) << "step " << i;
    ASSERT_EQ(outcome.seen, expected.seen) << "step " << i;
  }
}

}  // namespace
