#include "bench/bus/fan_out.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include <poll.h>
#include <sched.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "can/userbus/join.hpp"
#include "can/userbus/request.hpp"

namespace bench {

namespace {

using userbus::FrameMessage;
using userbus::Operation;

constexpr canid_t kIdentifier = 0x181;
constexpr canid_t kOther = 0x182;

void require(bool holds, const char* what) {
  if (!holds) throw std::system_error{errno, std::generic_category(), what};
}

can_frame some_frame() {
  can_frame frame{};
  frame.can_id = kIdentifier;
  frame.can_dlc = CAN_MAX_DLEN;
  return frame;
}

/// Whoever hands frames on runs on a processor of its own, if there are several: where the kernel puts it would
/// decide on the figures otherwise.
void run_on(pid_t process, std::size_t processor) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(processor, &set);
  sched_setaffinity(process, sizeof set, &set);
}

/// Asks the hub of @p member, which must do it; @p number is what its reply has for a payload.
int request(int member, Operation operation, int value, std::span<const std::byte> payload = {},
            std::uint32_t* number = nullptr) {
  std::uint32_t reply = 0;
  const userbus::Answer answer =
      userbus::ask(member, operation, value, payload.data(), payload.size(), &reply, sizeof reply);
  errno = answer.error;
  require(answer.error == 0, "the hub refuses a request");
  if (number != nullptr && answer.size == sizeof reply) *number = reply;
  return answer.value;
}

/// @p most_frames: that a message to the hub may have.
os::Descriptor join(const std::string& path, const Wishes& wishes, bool hears, std::uint32_t& most_frames) {
  userbus::Path at{};
  if (!userbus::copy_path(path.c_str(), at)) throw std::runtime_error{path};
  const userbus::Joined joined = userbus::join(at, nullptr, userbus::Kind::Port, SOCK_CLOEXEC);
  if (joined.descriptor < 0) throw std::runtime_error{userbus::text_of(joined.error)};
  os::Descriptor socket{joined.descriptor};
  const std::array most{wishes.most_frames};
  if (wishes.most_frames > 1)
    request(socket.get(), Operation::Hello, 0, std::as_bytes(std::span{most}), &most_frames);
  const canid_t identifier = hears ? kIdentifier : kOther;
  const std::array filters{can_filter{identifier, CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG}};
  if (wishes.one_hears) request(socket.get(), Operation::SetFilters, 0, std::as_bytes(std::span{filters}));
  const std::string_view name{"vcan0"};
  const int index = request(socket.get(), Operation::InterfaceIndex, 0, std::as_bytes(std::span{name}));
  request(socket.get(), Operation::Bind, index);
  return socket;
}

/// What the process of FanOut::plain() does: as little as there is to do.
[[noreturn]] void hand_on(std::span<const os::Descriptor> sockets, bool waits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::array<FrameMessage, userbus::kMostFrames> room{};
  const int from = sockets.front().get();
  for (;;) {
    pollfd wanted{from, POLLIN, 0};
    if (waits) poll(&wanted, 1, -1);
    const ssize_t size = recv(from, room.data(), sizeof room, 0);
    if (size <= 0) std::_Exit(0);
    // a frame alone goes on with a trailer
    const std::size_t written = size == sizeof(can_frame) ? sizeof(FrameMessage) : static_cast<std::size_t>(size);
    for (const os::Descriptor& to : sockets.subspan(1)) send(to.get(), room.data(), written, MSG_DONTWAIT);
  }
}

}  // namespace

FanOut FanOut::of_hub(const std::string& path, pid_t hub, const Wishes& wishes) {
  FanOut made{hub, false};
  for (std::size_t i = 0; i < wishes.members; ++i)
    made.sockets_.push_back(join(path, wishes, i == 1, made.most_frames_));
  made.hearers_ = wishes.one_hears ? 1 : wishes.members - 1;
  return made;
}

FanOut FanOut::plain(std::size_t members, bool waits) {
  std::vector<os::Descriptor> far;
  FanOut made{0, true};
  made.most_frames_ = userbus::kMostFrames;
  for (std::size_t i = 0; i < members; ++i) {
    std::array<int, 2> ends{};
    require(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == 0, "socketpair");
    made.sockets_.emplace_back(ends[0]);
    far.emplace_back(ends[1]);
  }
  made.hearers_ = members - 1;
  made.process_ = fork();
  require(made.process_ >= 0, "fork");
  if (made.process_ == 0) {
    made.sockets_.clear();
    hand_on(far, waits);
  }
  run_on(made.process_, 1);
  return made;
}

FanOut::FanOut(FanOut&& other) noexcept
    : process_{other.process_},
      is_own_{std::exchange(other.is_own_, false)},
      most_frames_{other.most_frames_},
      sockets_{std::move(other.sockets_)},
      hearers_{other.hearers_} {}

FanOut::~FanOut() {
  sockets_.clear();
  if (is_own_) waitpid(process_, nullptr, 0);
}

void FanOut::pass(std::size_t frames, bool in_one) const {
  std::array<FrameMessage, userbus::kMostFrames> room{};
  room.fill({.frame = some_frame(), .trailer = {}});
  const int from = sockets_.front().get();
  const bool is_one = in_one && frames <= most_frames_;
  const std::size_t size = is_one ? frames * sizeof room[0] : sizeof(can_frame);
  for (std::size_t i = 0; i < (is_one ? 1 : frames); ++i)
    require(send(from, room.data(), size, MSG_NOSIGNAL) == static_cast<ssize_t>(size), "sending");
  for (const os::Descriptor& hearer : std::span{sockets_}.subspan(1, hearers_))
    for (std::size_t left = frames; left > 0;) {
      const ssize_t got = recv(hearer.get(), room.data(), sizeof room, 0);
      require(got > 0, "hearing");
      left -= static_cast<std::size_t>(got) / sizeof room[0];
    }
}

std::int64_t FanOut::processor_time() const {
  clockid_t clock{};
  timespec time{};
  require(clock_getcpuclockid(process_, &clock) == 0 && clock_gettime(clock, &time) == 0, "processor time");
  return time.tv_sec * 1'000'000'000 + time.tv_nsec;
}

Hub::Hub(const std::string& program) {
  std::string folder = std::filesystem::temp_directory_path() / "hub-cost-XXXXXX";
  require(mkdtemp(folder.data()) != nullptr, "mkdtemp");
  folder_ = folder;
  std::string path = this->path();
  std::string name = program;
  std::string option = "--path";
  std::array<char*, 4> words{name.data(), option.data(), path.data(), nullptr};
  run_on(0, 0);
  errno = posix_spawn(&process_, program.c_str(), nullptr, nullptr, words.data(), environ);
  require(errno == 0, program.c_str());
  run_on(process_, 1);
  constexpr int kTries = 2000;
  for (int i = 0; !std::filesystem::exists(path); ++i) {
    if (i == kTries) throw std::runtime_error{program + " does not serve " + path};
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  }
}

Hub::~Hub() {
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

}  // namespace bench
