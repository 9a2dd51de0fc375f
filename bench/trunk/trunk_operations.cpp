#include <array>
#include <cstring>
#include <memory>
#include <vector>

#include "bench/operations/frames.hpp"
#include "bench/operations/operation.hpp"
#include "can/hub/medium/medium.hpp"
#include "can/hub/trunk/trunk.hpp"

namespace bench {
namespace {

constexpr canopen::TimePoint kNow{std::chrono::hours{1}};  // time stands still: no beat is due

/// What gives messages their order: each comes to every hub at once.
class Wire {
 public:
  static constexpr std::size_t kMost = 8;  ///< messages that may wait for a hub

  class Line final : public hub::trunk::Stream {
   public:
    explicit Line(Wire& wire) : wire_{wire} {}

    [[nodiscard]] int descriptor() const noexcept override { return -1; }
    [[nodiscard]] State advance() noexcept override { return State::Open; }
    [[nodiscard]] bool receive(Message& message) noexcept override {
      if (taken_ == wire_.sequence_) return false;
      const Kept& next = wire_.kept_[taken_++ % kMost];
      message = {.bytes = std::span{next.bytes}.first(next.size),
                 .sequence = taken_,
                 .time_ns = kNow.time_since_epoch().count()};
      return true;
    }
    void publish(std::span<const std::byte> bytes) noexcept override {
      Kept& next = wire_.kept_[wire_.sequence_++ % kMost];
      std::memcpy(next.bytes.data(), bytes.data(), bytes.size());
      next.size = bytes.size();
    }
    void flush() noexcept override {}
    void reopen() noexcept override {}
    [[nodiscard]] std::string take_problem() override { return {}; }

   private:
    Wire& wire_;
    std::uint64_t taken_ = 0;
  };

 private:
  struct Kept {
    std::array<std::byte, hub::trunk::kLongestMessage> bytes{};
    std::size_t size = 0;
  };
  std::array<Kept, kMost> kept_{};
  std::uint64_t sequence_ = 0;
};

/// A member without a socket.
struct Listener final : hub::Participant {
  void receive(const hub::Passage&) noexcept override { ++heard; }
  std::uint64_t heard = 0;
};

/// A hub whose only members are who sends and who hears.
struct Host {
  explicit Host(Wire& wire)
      : trunk{medium,
              std::make_unique<Wire::Line>(wire),
              {.url = "bench", .name = "bench"},
              [this](bool up, canopen::TimePoint) { medium.set_up(up); },
              [](std::string_view) {}} {
    medium.attach(sender);
    medium.attach(listener);
  }
  ~Host() {
    medium.detach(sender);
    medium.detach(listener);
  }
  void turn() {
    trunk.on_readable(kNow);
    if (trunk.next_deadline() <= kNow) trunk.on_time(kNow);
  }
  void send() {
    hub::Passage passage;
    passage.frame.can_id = 0x181;
    passage.frame.can_dlc = CAN_MAX_DLEN;
    passage.sender = &sender;
    medium.send(passage, kNow);
  }

  hub::Medium medium;
  Listener sender;
  Listener listener;
  hub::trunk::Trunk trunk;
};

/// So many frames that are sent in one turn of the first hub pass over all.
template <unsigned kFrames, unsigned kHubs>
class Passing {
 public:
  Passing() {
    for (unsigned i = 0; i < kHubs; ++i) hosts_.push_back(std::make_unique<Host>(wire_));
    for (int i = 0; i < 4; ++i) turn_all();
    step();
    for (const auto& host : hosts_) check(host->listener.heard == kFrames, "frames that pass over the trunk");
  }
  void step() {
    for (unsigned i = 0; i < kFrames; ++i) hosts_.front()->send();
    hosts_.front()->turn();
    turn_all();
  }

 private:
  void turn_all() {
    for (const auto& host : hosts_) host->turn();
  }

  Wire wire_;
  std::vector<std::unique_ptr<Host>> hosts_;
};

}  // namespace

std::vector<OperationRow> trunk_operations() {
  constexpr unsigned kBatch = hub::trunk::kMostFrames;
  return {
      {"trunk/own", "a frame over a hub's trunk and back, to the sender and a listener", make<Passing<1, 1>>},
      {"trunk/all", "the same with two more hubs and their listeners", make<Passing<1, 3>>},
      {"trunk/batch", "64 frames in one message over a hub's trunk and back", make<Passing<kBatch, 1>>},
      {"trunk/batch_all", "the same with two more hubs", make<Passing<kBatch, 3>>},
  };
}

}  // namespace bench
