#include "daemon/daemon.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#include <poll.h>
#include <sys/epoll.h>
#include <systemd/sd-daemon.h>

#include "daemon/clock.hpp"
#include "daemon/control_methods.hpp"

namespace axisd {
namespace {

constexpr canopen::Duration kRepeatedLogPeriod = std::chrono::seconds{10};
constexpr std::size_t kMostSubscriptions = 600;
/// Frames taken in one turn while they come faster than turns, so that the timer still gets its turn.
constexpr int kBurst = 32;
/// Every so many single frames the socket is asked for a second one, which shows whether a burst is on.
constexpr unsigned kBurstProbe = 64;

device::Configuration device_configuration(const Configuration& configuration) {
  const AxisConfiguration& axis = configuration.axes.front();
  device::Configuration result{.node_id = static_cast<std::uint8_t>(configuration.node_id),
                               .axis = {.machine = axis.machine, .load = axis.load},
                               .sdo_block = configuration.sdo_block,
                               .fault_on_leaving_operational = configuration.fault_on_leaving_operational};
  for (const ParameterValue& parameter : axis.parameters)
    result.presets.push_back({parameter.number, parameter.value});
  return result;
}

}  // namespace

Daemon::Daemon(const Configuration& configuration, const std::filesystem::path& state_root,
               const std::string& control, const Log& log)
    : configuration_{configuration},
      log_{log},
      started_{read_clock()},
      lock_{state_root, configuration.interface, configuration.node_id},
      link_{configuration.interface},
      port_{configuration.interface},
      queue_{port_},
      device_{device_configuration(configuration), queue_, *this},
      events_{[this] { stop(); }},
      load_torque_{configuration.axes.front().load.constant_torque} {
  filters_.reserve(kMostSubscriptions);
  link_source_ = events_.watch(link_.descriptor(), EPOLLIN, &Daemon::on_link, this);
  if (!control.empty()) {
    control_.emplace(events_, control, [this](std::string_view line) { return answer_request(*this, line); });
  }
  log_receive_buffer();
}

void Daemon::log_receive_buffer() const {
  const std::size_t got = port_.receive_buffer() / 2;  // the kernel counts its overhead as much again
  if (got < bus::SocketCan::kReceiveBuffer) {
    log_.warning("{}: receive buffer of {} bytes instead of {}: raise net.core.rmem_max", configuration_.interface,
                 got, bus::SocketCan::kReceiveBuffer);
  } else {
    log_.info("{}: receive buffer of {} bytes", configuration_.interface, got);
  }
}

void Daemon::run() {
  if (link_.state() == bus::LinkState::Up) {
    link_up();
  } else {
    log_.notice("{} is down: waiting until it is up", configuration_.interface);
    sd_notifyf(0, "STATUS=%s is down", configuration_.interface.c_str());
  }
  events_.dispatch();
  while (!stopping_) turn();
  sd_notify(0, "STOPPING=1\nSTATUS=");
  log_.info("power-off");
}

void Daemon::turn() noexcept {
  // Also without a link: the shaft turns on, and what it would send is dropped.
  timer_.wake_by(std::min(device_.next_deadline(), queue_.next_retry()));
  const bool listens = link_is_up_ && queue_.accepts_input();
  std::array<pollfd, 3> wait{pollfd{listens ? port_.descriptor() : -1, POLLIN, 0},
                             pollfd{timer_.descriptor(), POLLIN, 0}, pollfd{events_.descriptor(), POLLIN, 0}};
  if (ppoll(wait.data(), wait.size(), nullptr, nullptr) <= 0) return;
  const canopen::TimePoint now = read_clock();
  queue_.retry(now);
  if (wait[0].revents != 0) receive(now);
  if (wait[1].revents != 0) timer_.acknowledge();
  if (device_.next_deadline() <= now) device_.on_time(now);
  if (!ready_told_) tell_ready();
  if (!full_logged_ && queue_.waiting() != 0) log_full_queue();
  if (device_.skipped_cycles() != skipped_seen_) log_skipped_cycles(now);
  if (wait[2].revents != 0) events_.dispatch();
}

/// Requests come one by one, and one read a turn is the cheapest way to serve them; a burst is read in one go.
void Daemon::receive(canopen::TimePoint now) noexcept {
  const bool probes = ++turns_with_frames_ % kBurstProbe == 0;
  const int most = in_burst_ || probes ? kBurst : 1;
  int frames = 0;
  while (frames < most && queue_.accepts_input() && receive_frame(now)) ++frames;
  in_burst_ = frames > 1;
}

/// False if there was none.
bool Daemon::receive_frame(canopen::TimePoint now) noexcept {
  canopen::Frame frame;
  switch (const bus::Received received = port_.receive(frame); received.kind) {
    case bus::Received::Frame:
      ++received_;
      device_.on_frame(frame, now);
      return true;
    case bus::Received::Error:
      log_.warning("{}: {}", configuration_.interface, bus::name_of(received.state));
      return true;
    case bus::Received::Down:
      link_down();
      return false;
    case bus::Received::Nothing:
      break;
  }
  return false;
}

void Daemon::tell_ready() noexcept {
  // The boot-up frame has to be out.
  if (!link_is_up_ || queue_.waiting() != 0 || queue_.counters().sent == sent_before_boot_up_) return;
  ready_told_ = true;
  log_.info("ready: node {} on {}", configuration_.node_id, configuration_.interface);
  sd_notifyf(0, "READY=1\nSTATUS=node %d on %s", configuration_.node_id, configuration_.interface.c_str());
}

int Daemon::on_link(sd_event_source*, int, std::uint32_t, void* self) noexcept {
  auto& daemon = *static_cast<Daemon*>(self);
  if (const auto state = daemon.link_.read()) {
    daemon.link_down();
    if (*state == bus::LinkState::Up) daemon.link_up();
  }
  return 0;
}

void Daemon::log_skipped_cycles(canopen::TimePoint now) noexcept {
  if (skipped_seen_ != 0 && now - skipped_logged_ < kRepeatedLogPeriod) return;
  log_.warning("{} cycles of 4 ms were skipped: the daemon was kept from running",
               device_.skipped_cycles() - skipped_seen_);
  skipped_seen_ = device_.skipped_cycles();
  skipped_logged_ = now;
}

void Daemon::log_full_queue() noexcept {
  full_logged_ = true;
  log_.notice("{}: the transmit queue of the interface is full, frames wait; told once (see the status)",
              configuration_.interface);
}

void Daemon::link_up() noexcept {
  if (!port_.reopen()) {
    log_.warning("{} is up but cannot be used: it is no CAN interface", configuration_.interface);
    return;
  }
  link_is_up_ = true;
  queue_.discard();
  const canopen::TimePoint now = read_clock();
  queue_.retry(now);
  sent_before_boot_up_ = queue_.counters().sent;
  device_.start(now);
  if (ready_told_) {
    log_.notice("{} is up again", configuration_.interface);
    sd_notifyf(0, "STATUS=node %d on %s", configuration_.node_id, configuration_.interface.c_str());
  } else {
    tell_ready();
  }
}

void Daemon::link_down() noexcept {
  if (!link_is_up_) return;
  link_is_up_ = false;
  queue_.discard();
  log_.warning("{} is down: waiting until it is up", configuration_.interface);
  sd_notifyf(0, "STATUS=%s is down", configuration_.interface.c_str());
}

void Daemon::on_subscriptions_changed() noexcept {
  filters_.clear();
  for (const canopen::Subscription& wanted : device_.subscriptions()) {
    filters_.push_back({.identifier = wanted.identifier & canopen::cob_id::kLong,
                        .remote = wanted.remote,
                        .extended = (wanted.identifier & canopen::cob_id::kExtended) != 0});
  }
  port_.accept_only(filters_);
}

void Daemon::on_foreign_frame(std::uint32_t identifier) noexcept {
  ++foreign_frames_;
  const canopen::TimePoint now = read_clock();
  if (foreign_frames_ != 1 && now - foreign_logged_ < kRepeatedLogPeriod) return;
  foreign_logged_ = now;
  log_.warning("{}: identifier {:03X}h came from another station: duplicate node-ID {}?", configuration_.interface,
               identifier, configuration_.node_id);
}

tl::expected<void, drive::FaultError> Daemon::raise(std::uint16_t number) noexcept {
  return device_.raise(number, read_clock());
}

bool Daemon::acknowledge() noexcept {
  return device_.acknowledge(read_clock());
}

void Daemon::set_load_torque(double torque) noexcept {
  load_torque_ = torque;
  device_.set_load_torque(torque, read_clock());
}

double Daemon::uptime_s() const noexcept {
  return std::chrono::duration<double>(read_clock() - started_).count();
}

}  // namespace axisd
