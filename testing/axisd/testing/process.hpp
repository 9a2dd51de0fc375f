#pragma once

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

namespace axisd::testing {

/// What goes wrong here; what() is one message for people.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Something has not come in time.
struct Timeout : Error {
  using Error::Error;
};

using Milliseconds = std::chrono::milliseconds;

/// A descriptor that is closed in the end.
class Descriptor {
 public:
  Descriptor() = default;
  /// Takes @p number over; Error with @p what and errno if that is none.
  Descriptor(int number, const std::string& what) : number_{number} {
    if (number < 0) throw Error{what + ": " + std::strerror(errno)};
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : number_{std::exchange(other.number_, -1)} {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const noexcept { return number_; }

 private:
  int number_ = -1;
};

/// The address of a socket at @p path; Error if that is too long.
inline sockaddr_un address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path)
    throw Error{path + ": expected a path of at most " + std::to_string(sizeof address.sun_path - 1) + " bytes"};
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  return address;
}

/// Whether @p descriptor can be read within @p patience.
inline bool readable(int descriptor, Milliseconds patience) {
  pollfd one{descriptor, POLLIN, 0};
  return ::poll(&one, 1, static_cast<int>(patience.count())) > 0;
}

/// How long something is waited for: by the machine's clock, or so many milliseconds of stepped time.
class Deadline {
 public:
  /// @p step lets a millisecond of stepped time pass; nothing: the machine's counts.
  explicit Deadline(Milliseconds patience, std::function<void()> step = {})
      : step_{std::move(step)}, left_{patience}, end_{std::chrono::steady_clock::now() + patience} {}

  /// Whether @p descriptor can be read before the time is over.
  bool await(int descriptor) {
    if (!step_) {
      left_ = std::chrono::duration_cast<Milliseconds>(end_ - std::chrono::steady_clock::now());
      return left_.count() >= 0 && readable(descriptor, left_);
    }
    while (!readable(descriptor, Milliseconds{0}))
      if (!step()) return false;
    return true;
  }
  /// Lets a millisecond of stepped time pass; false if the time is over.
  bool step() {
    if (left_.count() <= 0) return false;
    --left_;
    step_();
    return true;
  }

 private:
  std::function<void()> step_;
  Milliseconds left_;
  std::chrono::steady_clock::time_point end_;
};

/// The path of a program: in $AXISD_BIN_DIR, else as PATH finds it.
inline std::string program_path(const std::string& name) {
  const char* const folder = std::getenv("AXISD_BIN_DIR");
  if (folder == nullptr || *folder == '\0') return name;
  std::string path = std::string{folder} + '/' + name;
  if (::access(path.c_str(), X_OK) != 0) throw Error{name + ": not in $AXISD_BIN_DIR (" + folder + ")"};
  return path;
}

/// A program that ends with this, and with the thread that has started it (PR_SET_PDEATHSIG).
class Process {
 public:
  Process() = default;
  /// Starts @p words with @p variables (NAME=VALUE) beside the environment; standard error goes to @p log. Error.
  Process(std::vector<std::string> words, const std::vector<std::string>& variables, int log)
      : name_{std::filesystem::path{words.front()}.filename()} {
    std::vector<std::string> environment;
    for (char** entry = environ; *entry != nullptr; ++entry)
      if (!is_own(*entry)) environment.emplace_back(*entry);
    environment.insert(environment.end(), variables.begin(), variables.end());
    const std::vector<char*> arguments = pointers(words);
    const std::vector<char*> setting = pointers(environment);
    const pid_t parent = ::getpid();
    identifier_ = ::fork();
    if (identifier_ < 0) throw Error{name_ + ": " + std::strerror(errno)};
    if (identifier_ == 0) become(arguments, setting, parent, log);
    exit_ = Descriptor{static_cast<int>(::syscall(SYS_pidfd_open, identifier_, 0)), name_};
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  Process(Process&& other) noexcept { *this = std::move(other); }
  Process& operator=(Process&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(identifier_, other.identifier_);
    std::swap(exit_, other.exit_);
    return *this;
  }
  ~Process() { end(); }

  [[nodiscard]] pid_t identifier() const noexcept { return identifier_; }
  /// Becomes readable when it has ended.
  [[nodiscard]] int exit_descriptor() const noexcept { return exit_.number(); }

  /// Ends it by SIGTERM, after five seconds by SIGKILL.
  void end() noexcept {
    if (identifier_ <= 0) return;
    ::kill(identifier_, SIGTERM);
    constexpr Milliseconds kPatience{5000};
    if (!readable(exit_.number(), kPatience)) ::kill(identifier_, SIGKILL);
    ::waitpid(identifier_, nullptr, 0);
    identifier_ = 0;
  }

 private:
  static bool is_own(const char* entry) {
    constexpr const char* kNotInherited[] = {"NOTIFY_SOCKET=", "WATCHDOG_",
                                             "STATE_DIRECTORY=", "RUNTIME_DIRECTORY=", "CAN_TIME="};
    return std::any_of(std::begin(kNotInherited), std::end(kNotInherited),
                       [entry](const char* name) { return std::strncmp(entry, name, std::strlen(name)) == 0; });
  }

  static std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> result;
    result.reserve(words.size() + 1);
    for (std::string& word : words) result.push_back(word.data());
    result.push_back(nullptr);
    return result;
  }

  /// In the child: calls that are safe there.
  [[noreturn]] static void become(const std::vector<char*>& words, const std::vector<char*>& environment,
                                  pid_t parent, int log) {
    constexpr int kCannotExecute = 127;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
    ::setsid();
    const int null = ::open("/dev/null", O_RDWR);
    ::dup2(null, STDIN_FILENO);
    ::dup2(null, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    ::execvpe(words.front(), words.data(), environment.data());
    ::_exit(kCannotExecute);
  }

  std::string name_;
  pid_t identifier_ = 0;
  Descriptor exit_;
};

/// A new folder, which goes in the end, and also when this process is killed: a shell waits for the end of a pipe.
class Folder {
 public:
  Folder() {
    std::string pattern = std::filesystem::temp_directory_path() / "axisd-XXXXXX";
    if (::mkdtemp(pattern.data()) == nullptr) throw Error{pattern + ": " + std::strerror(errno)};
    path_ = pattern;
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw Error{std::string{"pipe: "} + std::strerror(errno)};
    lifeline_ = Descriptor{ends[1], "pipe"};
    const Descriptor other{ends[0], "pipe"};
    guard_ = ::fork();
    if (guard_ == 0) {
      ::setsid();
      ::dup2(other.number(), STDIN_FILENO);
      ::execl("/bin/sh", "sh", "-c", "exec >/dev/null 2>&1; read -r end; rm -rf -- \"$1\"", "axisd-guard",
              path_.c_str(), nullptr);
      ::_exit(1);
    }
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    lifeline_ = Descriptor{};  // the guard removes the folder
    if (guard_ > 0) ::waitpid(guard_, nullptr, 0);
  }
  /// The path of a file in it.
  [[nodiscard]] std::string path(const std::string& name) const { return path_ + '/' + name; }

 private:
  std::string path_;
  Descriptor lifeline_;
  pid_t guard_ = -1;
};

/// The last @p count lines of a file.
inline std::string last_lines(const std::string& path, std::size_t count) {
  std::ifstream file{path};
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  std::string text;
  for (std::size_t i = lines.size() > count ? lines.size() - count : 0; i < lines.size(); ++i)
    text += lines[i] + '\n';
  return text;
}

}  // namespace axisd::testing
