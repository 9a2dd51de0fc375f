#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "can/nats/session.hpp"
#include "tools/canrec/frames/failure.hpp"
#include "tools/canrec/server/recording.hpp"

namespace canrec {

/// How much a recording keeps; what is older makes room. Zero: no limit.
struct Limits {
  std::chrono::nanoseconds age{};
  std::int64_t bytes = 0;
};

/// The recordings of a server. No answer is waited for longer than kPatience.
class Store {
 public:
  static constexpr std::chrono::seconds kPatience{5};

  /// Connects to @p server.
  [[nodiscard]] static Expected<Store> open(const nats::Server& server);

  /// Makes the recording @p name, which follows the bus @p bus from the next message on, on the server alone.
  [[nodiscard]] Expected<void> begin(const std::string& bus, const std::string& name, const Limits& limits);
  /// Waits until the recording @p name follows its bus, up to a limit; whether it does.
  [[nodiscard]] Expected<bool> await(const std::string& name);
  /// Takes nothing more into the recording @p name behind what its bus has had before the call.
  [[nodiscard]] Expected<Recording> stop(const std::string& name);
  [[nodiscard]] Expected<void> remove(const std::string& name);
  [[nodiscard]] Expected<Recording> find(const std::string& name);
  /// All of them, by name.
  [[nodiscard]] Expected<std::vector<Recording>> all();

  /// Makes the recording @p name of a log, of which the frames of @p interface are to be published to
  /// log_subject().
  [[nodiscard]] Expected<void> begin_log(const std::string& name, const std::string& interface);
  /// Takes nothing more into it.
  [[nodiscard]] Expected<void> seal(const std::string& name);
  [[nodiscard]] static std::string log_subject(const std::string& name) { return "canrec." + name; }

  [[nodiscard]] nats::Session& session() noexcept { return session_; }
  /// @p status of the library, of something that was to be done with @p what; empty: of the connection.
  [[nodiscard]] Failure failure_of(natsStatus status, jsErrCode code, std::string_view what) const;

 private:
  Store(nats::Session session, std::string url) noexcept : session_{std::move(session)}, url_{std::move(url)} {}

  [[nodiscard]] Expected<nats::StreamInfo> info_of(const std::string& name);
  [[nodiscard]] Expected<void> make(jsStreamConfig& config, const std::string& name);
  [[nodiscard]] Expected<std::uint64_t> end_of_bus(const std::string& bus);
  [[nodiscard]] Expected<void> catch_up(const std::string& name, const std::string& bus);

  nats::Session session_;
  std::string url_;
};

}  // namespace canrec
