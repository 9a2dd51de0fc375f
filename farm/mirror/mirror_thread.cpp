#include "farm/mirror/mirror_thread.hpp"

#include <cerrno>
#include <optional>
#include <system_error>
#include <thread>

#include <fmt/format.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "farm/mirror/agent_roll.hpp"
#include "farm/mirror/mirror.hpp"
#include "os/no_signals.hpp"
#include "service/mailbox.hpp"

namespace farm {

/// What runs in the thread. Only post() is for others.
class MirrorThread::Work final : private Link::Listener {
 public:
  Work(const FarmUrl& farm, const std::string& place, const std::string& program)
      : mail_{events_.watch(mailbox_.descriptor(), EPOLLIN, &Work::on_mail, this)},
        link_{events_, farm.server, program, *this},
        mirror_{events_, link_, farm.name, place},
        farm_{farm.name} {
    const os::NoSignals none;
    thread_ = std::thread{[this] { run(); }};
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  ~Work() override {
    post([this] { is_ending_ = true; });
    thread_.join();
  }

  void post(axisd::Mailbox::Job job) { mailbox_.post(std::move(job)); }
  Mirror& mirror() noexcept { return mirror_; }
  Link& link() noexcept { return link_; }
  void call_roll(AgentRoll::OnAll on_all) {
    if (!roll_) roll_.emplace(events_, link_, farm_, MirrorTimes{});
    roll_->call(std::move(on_all));
  }

 private:
  void on_up() override { mirror_.on_up(); }
  void on_down(const std::string& why) override { mirror_.on_down(why); }

  static int on_mail(sd_event_source*, int, std::uint32_t, void* self) noexcept {
    static_cast<Work*>(self)->mailbox_.do_one();
    return 0;
  }

  void run() {
    bool more = false;
    while (!is_ending_) {
      pollfd waiting{events_.descriptor(), POLLIN, 0};
      if (!more) ::poll(&waiting, 1, -1);
      more = events_.dispatch();
    }
  }

  axisd::ServiceEvents events_;
  axisd::Mailbox mailbox_;
  axisd::EventSource mail_;
  Link link_;
  Mirror mirror_;
  std::optional<AgentRoll> roll_;
  std::string farm_;
  bool is_ending_ = false;
  std::thread thread_;
};

MirrorThread::MirrorThread(const FarmUrl& farm, const std::string& program)
    : farm_{farm.name}, place_{fmt::format("{}/{}", farm.server.url, farm.name)} {
  const os::NoSignals none;  // for the threads of the link
  work_ = std::make_unique<Work>(farm, place_, program);
}

MirrorThread::~MirrorThread() = default;

tl::expected<os::Descriptor, std::string> MirrorThread::connect(Order order) {
  int ends[2]{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return tl::unexpected{fmt::format("{}: {}", place_, std::generic_category().message(errno))};
  os::Descriptor own{ends[0]};
  work_->post([this, order, end = ends[1]] {
    try {
      work_->mirror().serve(os::Descriptor{end}, order);
    } catch (const std::system_error&) {  // no memory in the kernel: the other end sees that it was closed
    }
  });
  return own;
}

void MirrorThread::in_contact(std::function<void(tl::expected<Link*, std::string>)> then) {
  work_->post([this, then = std::move(then)] {
    work_->mirror().when_in_contact([this, then](const tl::expected<void, std::string>& contact) {
      then(contact ? tl::expected<Link*, std::string>{&work_->link()} : tl::unexpected{contact.error()});
    });
  });
}

tl::expected<std::vector<AgentBeat>, std::string> MirrorThread::agents() {
  std::promise<tl::expected<std::vector<AgentBeat>, std::string>> promise;
  in_contact([this, &promise](const tl::expected<Link*, std::string>& link) {
    if (!link) return promise.set_value(tl::unexpected{link.error()});
    work_->call_roll([&promise](std::vector<AgentBeat> all) { promise.set_value(std::move(all)); });
  });
  return promise.get_future().get();
}

}  // namespace farm
