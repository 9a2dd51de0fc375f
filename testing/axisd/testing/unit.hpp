#pragma once

#include <algorithm>
#include <cctype>
#include <memory>

#include "axisd/testing/bus.hpp"
#include "axisd/testing/control.hpp"
#include "axisd/testing/fault.hpp"

namespace axisd::testing {

/// How a unit is started.
struct Settings {
  int axes = 1;
  int node_id = 5;
  nlohmann::json configuration = nlohmann::json::object();  ///< docs/reference/configuration.md
  nlohmann::json inject = nlohmann::json::array();          ///< faults that are loaded at the start
  std::uint32_t bit_rate = 0;    ///< bit/s, 0: frames take no time; in stepped time 1 Mbit/s
  std::string time{};            ///< whose its bus has: "scaled=K", "stepped"; empty: the machine's
  Milliseconds patience{10000};  ///< of everything that waits
  bool own_can =
      true;  ///< CAN sockets that this process opens from now on lead to its bus, if it runs under with-can
};

/// A daemon and a bus of its own, from the boot-up to the end of this.
class Unit {
 public:
  /// Starts it and waits until it is ready; Error with the last lines of its log.
  explicit Unit(Settings settings = {}) : settings_{std::move(settings)} {
    if (settings_.time == "virtual") throw Error{"time: expected scaled=K or stepped, as a test takes no turns"};
    start_hub();
    bus_ = std::make_unique<Bus>(bus_path(), is_stepped());
    start_daemon();
    control_ = std::make_unique<Control>(folder_.path("control"));
    if (settings_.own_can) ::setenv("CAN_BUS", bus_path().c_str(), 1);
  }
  Unit(const Unit&) = delete;
  Unit& operator=(const Unit&) = delete;
  ~Unit() {
    if (at_end) at_end(*this);
  }

  /// Called before the end of each unit; testing.hpp has it show the report of a test that has failed.
  // NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): set by testing.hpp, before main
  static inline std::function<void(Unit& unit)> at_end{};

  /// The path of its bus, for $CAN_BUS and `with-can --bus`.
  [[nodiscard]] std::string bus_path() const { return folder_.path("bus"); }
  [[nodiscard]] Bus& bus() noexcept { return *bus_; }
  [[nodiscard]] pid_t process() const noexcept { return daemon_.identifier(); }

  /// The result of a method of the control socket; Refused.
  nlohmann::json call(const std::string& method, const nlohmann::json& params = nlohmann::json::object()) {
    return control_->call(method, params);
  }
  /// Injects a fault, an object of JSON; Refused.
  Fault inject(const nlohmann::json& fault) {
    const int identifier = call("inject.add", fault).at("id");
    return {[this](const std::string& method, const nlohmann::json& params) { return call(method, params); },
            identifier};
  }
  /// Injects a fault of its bus (docs/reference/bus-faults.md), likewise.
  Fault inject_on_bus(const nlohmann::json& fault) {
    const int identifier = call_hub("inject.add", {{"fault", fault}}).at("id");
    return {[this](const std::string& method, const nlohmann::json& params) { return call_hub(method, params); },
            identifier};
  }
  /// Sends an NMT command: 1 start, 2 stop, 128 Pre-operational, 129 reset node, 130 reset communication.
  void nmt(std::uint8_t command) { bus_->send(0, {command, static_cast<std::uint8_t>(settings_.node_id)}); }
  /// Lets the stepped time of its bus go on; so does whatever waits, by a millisecond again and again. Error.
  void step(std::chrono::nanoseconds time) { bus_->step(time); }
  /// Sends a frame.
  void send(std::uint32_t identifier, const std::vector<std::uint8_t>& data) { bus_->send(identifier, data); }

  /// The next frame under @p identifier whose bytes begin with @p data; those before it are passed over. Timeout.
  Frame wait_frame(std::uint32_t identifier, const std::vector<std::uint8_t>& data = {}) {
    std::ostringstream what;
    what << "a frame " << std::uppercase << std::hex << identifier << 'h';
    return bus_->wait_for(
        [&](const Frame& frame) {
          return frame.identifier() == identifier && frame.can.can_dlc >= data.size() &&
                 std::equal(data.begin(), data.end(), frame.can.data);
        },
        what.str(), settings_.patience);
  }
  /// Returns in an NMT state ("operational"), also one that is over again; Timeout.
  void wait_nmt(const std::string& state) {
    wait(
        "NMT state " + state, "nmt",
        [&](const nlohmann::json& event) { return same(event.value("state", ""), state); },
        [&] { return same(call("status").at("nmt_state"), state); });
  }
  /// Returns in a state of a drive ("operation-enabled"), likewise.
  void wait_state(const std::string& state, int axis = 1) {
    wait(
        "state " + state, "drive-state",
        [&](const nlohmann::json& event) {
          return event.at("axis") == axis && same(event.value("state", ""), state);
        },
        [&] { return same(call("status").at("axes").at(static_cast<std::size_t>(axis - 1)).at("state"), state); });
  }
  /// Returns when a fault or alarm ("F07860") is there, or was.
  void wait_message(const std::string& code) {
    wait(
        code, code.front() == 'A' ? "alarm" : "fault",
        [&](const nlohmann::json& event) {
          return event.value("name", "") == code && event.value("active", false);
        },
        [&] {
          const nlohmann::json messages = call("fault.list").at("messages");
          return std::any_of(messages.begin(), messages.end(),
                             [&](const auto& row) { return row.at("code") == code; });
        });
  }
  /// Returns when a signal ("1/speed", docs/reference/trace.md) is at least @p limit; its value.
  double wait_at_least(const std::string& signal, double limit) {
    constexpr int kPeriod = 5;  // ms
    Control samples{folder_.path("control")};
    samples.call("samples.subscribe", {{"signals", {signal}}, {"period_ms", kPeriod}});
    Deadline deadline = patience();
    while (true) {
      const nlohmann::json line = samples.read_line(deadline, signal + " of at least " + std::to_string(limit));
      if (!line.contains("sample") || !line["sample"]["values"][0].is_number()) continue;
      const double value = line["sample"]["values"][0];
      if (value >= limit) return value;
    }
  }

  /// The last @p count frames, a line each, what the unit does, and the faults that are injected.
  std::string report(std::size_t count = 20) {
    const std::vector<Frame> frames = bus_->frames();
    std::ostringstream text;
    text << "the last frames of " << frames.size() << " on " << bus_path() << ":\n";
    for (std::size_t i = frames.size() > count ? frames.size() - count : 0; i < frames.size(); ++i) {
      std::array<char, 64> time{};
      std::snprintf(time.data(), time.size(), "%10.6f %c ", frames[i].time - frames.front().time,
                    frames[i].own ? '>' : ' ');
      text << time.data() << frames[i].text() << '\n';
    }
    try {
      const nlohmann::json status = call("status");
      text << "NMT state " << status.at("nmt_state").get<std::string>() << '\n';
      for (const nlohmann::json& axis : status.at("axes"))
        text << "axis " << axis.at("axis") << ": " << axis.at("state").get<std::string>() << ", statusword "
             << axis.at("statusword").get<std::string>() << ", faults " << axis.at("faults").dump() << '\n';
      const nlohmann::json faults = call("inject.list");
      for (const nlohmann::json& fault : faults.at("faults")) text << "injected: " << fault.dump() << '\n';
    } catch (const Error& error) {
      text << error.what() << '\n';
    }
    return text.str() + "log:\n" + last_lines(folder_.path("log"), 5);
  }

 private:
  /// Letters and digits alone, so that "operation-enabled" is "Operation enabled".
  static bool same(const std::string& one, const std::string& other) {
    const auto essence = [](const std::string& text) {
      std::string result;
      for (const char c : text)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
          result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return result;
    };
    return essence(one) == essence(other);
  }

  nlohmann::json call_hub(const std::string& method, const nlohmann::json& params) {
    const Bus::Reply reply = bus_->ask_about_faults(nlohmann::json{{"method", method}, {"params", params}}.dump());
    const nlohmann::json told = nlohmann::json::parse(reply.payload, nullptr, false);
    if (reply.error != 0)
      throw Refused{method + ": " + (told.is_object() ? told.value("message", "") : "the hub has no faults"),
                    "bad-parameter"};
    return told;
  }

  template <class IsIt, class Holds>
  void wait(const std::string& what, const std::string& kind, const IsIt& is_it, const Holds& holds) {
    Control events{folder_.path("control")};
    events.call("events.subscribe", {{"kinds", {kind}}});
    Deadline deadline = patience();
    if (holds()) return;
    try {
      while (true) {
        const nlohmann::json line = events.read_line(deadline, what);
        if (line.contains("event") && is_it(line["event"])) return;
      }
    } catch (const Timeout& late) {
      std::string reasons;
      const nlohmann::json explanation = call("explain");
      for (const nlohmann::json& axis : explanation.at("axes"))
        reasons += "; " + axis.at("reasons").at(0).get<std::string>();
      throw Timeout{late.what() + reasons};
    }
  }

  [[nodiscard]] bool is_stepped() const { return settings_.time == "stepped"; }

  Deadline patience() {
    if (!is_stepped()) return Deadline{settings_.patience};
    return Deadline{settings_.patience, [this] { bus_->step(Milliseconds{1}); }};
  }

  void start_hub() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw Error{std::strerror(errno)};
    hub_log_ = Descriptor{ends[0], "pipe"};
    const Descriptor writing{ends[1], "pipe"};
    std::vector<std::string> words{program_path("canhub"), "--path", bus_path()};
    if (settings_.bit_rate != 0 || !is_stepped())
      words.insert(words.end(), {"--bitrate", std::to_string(settings_.bit_rate)});
    if (!settings_.time.empty()) words.insert(words.end(), {"--time", settings_.time});
    hub_ = Process{std::move(words), {}, writing.number()};
    std::string said;
    while (said.find("canhub: ready") == std::string::npos) {
      pollfd both[2] = {{hub_log_.number(), POLLIN, 0}, {hub_.exit_descriptor(), POLLIN, 0}};
      std::array<char, 512> part{};
      const bool is_said =
          ::poll(both, 2, static_cast<int>(settings_.patience.count())) > 0 && both[0].revents == POLLIN;
      const ssize_t size = is_said ? ::read(hub_log_.number(), part.data(), part.size()) : 0;
      if (size <= 0) throw Error{"canhub has not started; is it in PATH? " + said};
      said.append(part.data(), static_cast<std::size_t>(size));
    }
  }

  void start_daemon() {
    nlohmann::json configuration = settings_.configuration;
    if (!configuration.contains("axes"))
      configuration["axes"] = nlohmann::json(static_cast<std::size_t>(settings_.axes), nlohmann::json::object());
    if (!settings_.inject.empty()) configuration["inject"] = settings_.inject;
    std::ofstream{folder_.path("axisd.json")} << configuration;
    const Descriptor log{::open(folder_.path("log").c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0600),
                         "log"};
    const Descriptor notices{::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0), "socket"};
    const sockaddr_un address = address_of(folder_.path("notify"));
    if (::bind(notices.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
      throw Error{std::strerror(errno)};
    daemon_ = Process{{program_path("axisd"), "--config", folder_.path("axisd.json"), "--interface",
                       "unix:" + bus_path(), "--node-id", std::to_string(settings_.node_id), "--control",
                       folder_.path("control"), "--state-directory", folder_.path("state")},
                      {"NOTIFY_SOCKET=" + folder_.path("notify")},
                      log.number()};
    // Faults may keep the boot-up back, which the notice tells; the node has left Initialising then.
    const bool may_be_silent = configuration.contains("inject");
    constexpr Milliseconds kLookAgain{5};
    Milliseconds next_step{0};
    const auto end = std::chrono::steady_clock::now() + settings_.patience;
    while (std::chrono::steady_clock::now() < end) {
      pollfd both[2] = {{notices.number(), POLLIN, 0}, {daemon_.exit_descriptor(), POLLIN, 0}};
      const bool looks_again = may_be_silent || is_stepped();
      ::poll(both, 2, static_cast<int>((looks_again ? kLookAgain : settings_.patience).count()));
      std::array<char, 512> part{};
      const ssize_t size = ::recv(notices.number(), part.data(), part.size(), MSG_DONTWAIT);
      if (size > 0 &&
          std::string{part.data(), static_cast<std::size_t>(size)}.find("READY=1") != std::string::npos)
        return;
      if (both[1].revents != 0) break;
      if (may_be_silent && has_left_initialising()) return;
      // who has a control socket has joined the time of the bus
      if (is_stepped() && ::access(folder_.path("control").c_str(), F_OK) == 0)
        bus_->step(std::exchange(next_step, Milliseconds{1}));
    }
    throw Error{"axisd has not started: " + last_lines(folder_.path("log"), 5)};
  }

  bool has_left_initialising() const {
    try {
      return Control{folder_.path("control")}.call("status", nlohmann::json::object()).at("nmt_state") !=
             "Initialising";
    } catch (const Error&) {
      return false;
    }
  }

  Settings settings_;
  Folder folder_;
  Descriptor hub_log_;
  Process hub_;
  std::unique_ptr<Bus> bus_;
  Process daemon_;
  std::unique_ptr<Control> control_;
};

}  // namespace axisd::testing
