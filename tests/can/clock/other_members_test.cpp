#include <atomic>
#include <functional>
#include <mutex>
#include <vector>

#include <gtest/gtest.h>

#include "tests/can/clock/clock_bus.hpp"

namespace clock_test {
namespace {

using userbus::TimeMode;

/// A program with a thread that acts every millisecond, and one that is played by hand.
class TwoPrograms : public ::testing::Test {
 protected:
  using Act = std::function<void(bus::TimeShare& share, canopen::Duration now)>;

  TwoPrograms() { other_.turn(); }
  ~TwoPrograms() override {
    if (thread_.joinable()) thread_.join();
  }

  /// Joins, and acts until @p end as soon as the other one lets it.
  void begin(canopen::Duration end, Act act) {
    userbus::Path path{};
    userbus::copy_path(hub_.path().c_str(), path);
    os::Descriptor clock{userbus::join_clock(path, nullptr, 0, ::getpid(), false).descriptor};
    const userbus::TimePage* const page = userbus::map_time(clock.get());  // behind that it has joined
    thread_ = std::thread{[=, clock = std::move(clock), act = std::move(act)]() mutable {
      bus::TimeShare share{path, std::move(clock), *page};
      bus::Party& party = share.add();
      for (canopen::Duration next = 1ms; next <= end; next += 1ms) {
        share.wait(party, {.descriptors = {}, .until = instant(next)});
        act(share, age(share));
      }
      share.remove(party);
    }};
  }

  hub_test::RunningHub hub_{with_time(TimeMode::Virtual)};
  OtherProgram other_{hub_};
  std::thread thread_{};
};

TEST_F(TwoPrograms, ActInTheOrderOfTheirInstants) {
  std::vector<canopen::Duration> acted;
  begin(5ms, [&](bus::TimeShare&, canopen::Duration now) { acted.push_back(now); });

  other_.wait(2500us);
  EXPECT_EQ(other_.turn(), 2500us);
  EXPECT_EQ(acted, (std::vector<canopen::Duration>{1ms, 2ms}));
  other_.wait_for_ever();
  thread_.join();

  EXPECT_EQ(acted, (std::vector<canopen::Duration>{1ms, 2ms, 3ms, 4ms, 5ms}));
}

TEST_F(TwoPrograms, LookAtOnceAtWhatTheOtherHasTouched) {
  begin(5ms, [](bus::TimeShare& share, canopen::Duration now) {
    if (now == 3ms) share.note_touched();
  });

  other_.wait_for_ever();

  EXPECT_EQ(other_.turn(), 3ms);
  other_.wait_for_ever();
}

TEST(ProgramThatStartsOne, WaitsForIt) {
  const hub_test::RunningHub hub{with_time(TimeMode::Virtual)};
  const auto share = join(hub);
  bus::Party& party = share->add();
  const os::Descriptor part = share->prepare_child();
  ASSERT_TRUE(part);
  OtherProgram child{os::Descriptor{::dup(part.get())}};
  std::vector<canopen::Duration> acted;
  std::thread thread{[&] {
    for (canopen::Duration next = 1ms; next <= 2ms; next += 1ms) {
      share->wait(party, {.descriptors = {}, .until = instant(next)});
      acted.push_back(age(*share));
    }
    share->remove(party);
  }};

  EXPECT_EQ(child.turn(), 0ms);
  EXPECT_TRUE(acted.empty());
  child.wait(1500us);
  EXPECT_EQ(child.turn(), 1500us);
  EXPECT_EQ(acted, (std::vector<canopen::Duration>{1ms}));
  child.wait_for_ever();
  thread.join();
}

TEST(ProgramThatHasMuchToDo, LetsOthersIn) {
  const hub_test::RunningHub hub{with_time(TimeMode::Virtual)};
  const auto share = join(hub);
  bus::Party& party = share->add();
  std::atomic<bool> is_over{false};
  std::thread thread{[&] {
    for (canopen::Duration next = 1ms; !is_over; next += 1ms)
      share->wait(party, {.descriptors = {}, .until = instant(next)});
    share->remove(party);
  }};

  OtherProgram other{hub};
  EXPECT_GE(other.turn(), 0ms);
  is_over = true;
  other.wait_for_ever();
  thread.join();
}

TEST(DeviceAlone, HasTimeStand) {
  const hub_test::RunningHub hub{with_time(TimeMode::Virtual)};
  const auto device = join(hub, userbus::kDevice);
  bus::Party& party = device->add();
  std::vector<canopen::Duration> acted;
  std::thread thread{[&] {
    for (canopen::Duration next = 1ms; next <= 3ms; next += 1ms) {
      device->wait(party, {.descriptors = {}, .until = instant(next)});
      acted.push_back(age(*device));
    }
    device->remove(party);
  }};

  OtherProgram master{hub};
  EXPECT_EQ(master.turn(), 0ms);
  EXPECT_TRUE(acted.empty());
  master.wait(1s);
  EXPECT_EQ(master.turn(), 1s);
  thread.join();

  EXPECT_EQ(acted, (std::vector<canopen::Duration>{1ms, 2ms, 3ms}));
}

/// Lets stepped time go on; the present then.
canopen::Duration step(const hub_test::RunningHub& hub, canopen::Duration by) {
  userbus::Path path{};
  userbus::copy_path(hub.path().c_str(), path);
  const os::Descriptor member{userbus::join(path, nullptr, userbus::Kind::Port, SOCK_CLOEXEC).descriptor};
  const std::int64_t length = by.count();
  std::int64_t now = 0;
  const os::Descriptor reply{userbus::post(member.get(), userbus::Operation::Step, 0, &length, sizeof length)};
  pollfd wanted{reply.get(), POLLIN, 0};
  ::poll(&wanted, 1, -1);
  userbus::take_reply(reply.get(), &now, sizeof now);
  return canopen::Duration{now - userbus::kFirstInstant};
}

TEST(SteppedTime, GoesOnAsFarAsItIsLet) {
  const hub_test::RunningHub hub{with_time(TimeMode::Stepped)};
  const auto device = join(hub, userbus::kDevice);
  bus::Party& party = device->add();
  std::mutex mutex;  // for who does not know that one acts at a time
  std::vector<canopen::Duration> times;
  const auto acted = [&] {
    const std::scoped_lock lock{mutex};
    return times;
  };
  const Bell end;
  std::thread thread{[&] {
    pollfd wanted = end.wanted();
    canopen::Duration next = 1ms;
    while (!device->wait(party, {.descriptors = {&wanted, 1}, .until = instant(next)})) {
      const std::scoped_lock lock{mutex};
      times.push_back(age(*device));
      next += 1ms;
    }
    device->remove(party);
  }};

  EXPECT_EQ(step(hub, 2500us), 2500us);
  EXPECT_EQ(acted(), (std::vector<canopen::Duration>{1ms, 2ms}));
  EXPECT_EQ(step(hub, 500us), 3ms);
  EXPECT_EQ(acted(), (std::vector<canopen::Duration>{1ms, 2ms, 3ms}));
  end.ring();
  thread.join();
}

}  // namespace
}  // namespace clock_test
