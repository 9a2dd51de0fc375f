#include "can/preload/interface.hpp"

#include <atomic>
#include <cerrno>
#include <cstring>

#include "can/preload/hub.hpp"
#include "can/userbus/interface_name.hpp"

namespace preload {

namespace {

static_assert(IF_NAMESIZE == sizeof userbus::InterfaceEntry::name);

/// A CAN socket to ask through: that of the caller, or one for the one question.
class Asker {
 public:
  explicit Asker(int member) noexcept
      : own_{member < 0 ? join_bus(userbus::Kind::Raw, SOCK_CLOEXEC) : -1},
        descriptor_{member < 0 ? own_ : member} {}
  Asker(const Asker&) = delete;
  Asker& operator=(const Asker&) = delete;
  ~Asker() {
    if (own_ >= 0) next().close(own_);
  }

  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }

 private:
  int own_;
  int descriptor_;
};

/// A name that the hub has told, in two words that are read and written whole. Programs ask for the name of the
/// interface with every frame.
struct KnownName {
  std::atomic<uint64_t> words[2];
  std::atomic<pid_t> hub;  ///< whose name it is; 0: nobody's
};

constexpr int kMostKnown = 64;
KnownName known_names[kMostKnown];

/// The process that made the hub of CAN socket @p member; 0 if that cannot be told.
pid_t hub_of(int member) noexcept {
  ucred peer{};
  socklen_t size = sizeof peer;
  return next().getsockopt(member, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 ? peer.pid : 0;
}

KnownName* known_name(int index) noexcept {
  return index >= kFirstIndex && index < kFirstIndex + kMostKnown ? &known_names[index - kFirstIndex] : nullptr;
}

bool remember(int index, pid_t hub, char (&name)[IF_NAMESIZE]) noexcept {
  const KnownName* const known = known_name(index);
  if (known == nullptr || known->hub != hub) return false;
  const uint64_t words[] = {known->words[0], known->words[1]};
  memcpy(name, words, sizeof words);
  return known->hub == hub;
}

void keep(int index, pid_t hub, const char (&name)[IF_NAMESIZE]) noexcept {
  KnownName* const known = known_name(index);
  if (known == nullptr) return;
  uint64_t words[2];
  memcpy(words, name, sizeof words);
  known->hub = 0;
  known->words[0] = words[0];
  known->words[1] = words[1];
  known->hub = hub;
}

}  // namespace

bool is_can_interface(const char* name) noexcept {
  return userbus::is_can_name(name, strnlen(name, IF_NAMESIZE));
}

int index_of_interface(const char* name, int member) noexcept {
  const Asker asker{member};
  if (asker.descriptor() < 0) return 0;
  const userbus::Answer answer =
      ask_about(asker.descriptor(), userbus::Operation::InterfaceIndex, name, strnlen(name, IF_NAMESIZE));
  if (answer.error == 0) return answer.value;
  errno = answer.error;
  return 0;
}

bool name_of_interface(int index, int member, char (&name)[IF_NAMESIZE]) noexcept {
  const Asker asker{member};
  if (asker.descriptor() < 0) return false;
  const pid_t hub = hub_of(asker.descriptor());
  if (hub != 0 && remember(index, hub, name)) return true;
  memset(name, 0, sizeof name);
  const userbus::Answer answer =
      ask(asker.descriptor(), userbus::Operation::InterfaceName, index, name, sizeof name - 1);
  if (answer.error == 0) {
    keep(index, hub, name);
    return true;
  }
  errno = answer.error;
  return false;
}

}  // namespace preload
