#include "tests/e2e/program.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace e2e {
namespace {

using std::chrono::milliseconds;

constexpr int kCannotStart = 127;

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> result;
  for (const std::string& word : words) result.push_back(const_cast<char*>(word.c_str()));
  result.push_back(nullptr);
  return result;
}

bool readable(int descriptor, milliseconds patience) {
  pollfd wanted{descriptor, POLLIN, 0};
  return poll(&wanted, 1, static_cast<int>(patience.count())) == 1;
}

/// The child's part after fork().
[[noreturn]] void become(const std::vector<std::string>& arguments, std::vector<std::string> environment,
                         int out) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const auto asks_for_watchdog = [](const std::string& entry) { return entry.starts_with("WATCHDOG_USEC="); };
  if (std::any_of(environment.begin(), environment.end(), asks_for_watchdog)) {
    environment.push_back("WATCHDOG_PID=" + std::to_string(getpid()));
  }
  const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(null, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  execve(arguments.at(0).c_str(), pointers(arguments).data(), pointers(environment).data());
  _exit(kCannotStart);
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error{errno, std::generic_category(), "pipe2"};
  pipe_ = os::Descriptor{ends[0]};
  const os::Descriptor write_end{ends[1]};
  id_ = fork();
  if (id_ < 0) throw std::system_error{errno, std::generic_category(), "fork"};
  if (id_ == 0) become(arguments, environment, write_end.get());
}

Program::~Program() {
  if (ended_) return;
  signal(SIGKILL);
  waitpid(id_, nullptr, 0);
}

void Program::signal(int signal) const noexcept {
  if (!ended_) kill(id_, signal);
}

bool Program::ends_within(milliseconds patience) const {
  const os::Descriptor process{static_cast<int>(syscall(SYS_pidfd_open, id_, 0))};
  return readable(process.get(), patience);
}

int Program::wait() {
  if (!ends_within(kPatience)) throw std::runtime_error{"the program goes on; it wrote:\n" + output()};
  int status = 0;
  waitpid(id_, &status, 0);
  ended_ = true;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// False if nothing came in time.
bool Program::read_some(milliseconds patience) {
  if (!readable(pipe_.get(), patience)) return false;
  std::array<char, 4096> part;
  const ssize_t size = read(pipe_.get(), part.data(), part.size());
  if (size > 0) output_.append(part.data(), static_cast<std::size_t>(size));
  return size > 0;
}

const std::string& Program::output() {
  while (read_some(milliseconds{0})) {
  }
  return output_;
}

bool Program::wait_for_output(std::string_view text, std::size_t from, milliseconds patience) {
  while (output().find(text, from) == std::string::npos) {
    if (!read_some(patience)) return false;
  }
  return true;
}

std::uint64_t Program::processor_ticks() const {
  std::ifstream file{"/proc/" + std::to_string(id_) + "/stat"};
  const std::string text{std::istreambuf_iterator<char>{file}, {}};
  std::istringstream rest{text.substr(text.rfind(')') + 1)};  // the name may contain blanks
  constexpr int kFieldsBefore = 11;                           // state to cmajflt
  std::string skipped;
  for (int i = 0; i < kFieldsBefore; ++i) rest >> skipped;
  std::uint64_t user = 0;
  std::uint64_t system = 0;
  rest >> user >> system;
  return user + system;
}

bool Program::wakes(std::uint64_t times) const {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  const std::uint64_t wanted = sleeps() + times;
  while (sleeps() < wanted) {
    if (std::chrono::steady_clock::now() > end) return false;
    sched_yield();
  }
  return true;
}

std::uint64_t Program::sleeps() const {
  std::uint64_t sum = 0;
  std::error_code gone;
  for (const auto& task : std::filesystem::directory_iterator{"/proc/" + std::to_string(id_) + "/task", gone}) {
    std::ifstream file{task.path() / "status"};
    for (std::string name; file >> name;) {
      std::uint64_t count = 0;
      if (name == "voluntary_ctxt_switches:" && file >> count) sum += count;
    }
  }
  return sum;
}

}  // namespace e2e
