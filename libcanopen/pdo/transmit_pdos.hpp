#pragma once

#include "libcanopen/base/export.hpp"
#include "libcanopen/pdo/parameters.hpp"

namespace canopen {

/// Sends process data (CiA 301, 7.2.2): types 1..240 with every n-th SYNC, type 0 with the SYNC after a change,
/// types 254 and 255 on a change and by the event timer, never closer than the inhibit time.
class CANOPEN_EXPORT TransmitPdos final : public PdoParameters::Listener {
 public:
  /// Uses the timers @p first_timer .. first_timer + timers_for(dictionary) - 1.
  TransmitPdos(Context& context, std::size_t first_timer);
  /// Timers that the TPDOs of @p dictionary need.
  static std::size_t timers_for(const Dictionary& dictionary) noexcept;

  /// Starts over with the values in the dictionary; nothing is sent before start().
  void reload() noexcept;
  /// NMT Operational is entered: the event-driven TPDOs send their first frame.
  void start() noexcept;
  /// NMT Operational is left.
  void stop() noexcept;
  /// A SYNC with @p counter, 0 if it carries none: takes the values of all TPDOs concerned first, then sends them,
  /// so that they belong together.
  void on_sync(std::uint8_t counter) noexcept;
  /// The owner has new values: event-driven TPDOs whose values differ from those last sent are due.
  void on_values_changed() noexcept;
  /// A remote frame asks for the PDO at @p position.
  void on_request(std::size_t position) noexcept;
  /// Timer @p which of this service fired, counted from its first.
  void on_timer(std::size_t which) noexcept;

  std::span<const PdoSettings> pdos() const noexcept { return parameters_.pdos(); }

  void on_pdo_changed(std::size_t position) noexcept override;
  void on_pdo_time_changed(std::size_t position, std::uint8_t sub_index, std::int64_t value) noexcept override;

 private:
  enum class Timer : std::uint8_t { Event, Inhibit };
  static constexpr std::size_t kTimersEach = 2;
  struct State {
    std::uint64_t payload = 0;  ///< as last sent
    TimePoint sent{};
    Duration inhibit{};
    Duration event_period{};
    std::uint8_t syncs = 0;      ///< since the last frame
    bool first = true;           ///< nothing sent since start()
    bool event_elapsed = false;  ///< waits for the inhibit time although nothing has changed
  };
  struct Staged {
    std::uint16_t position;
    std::uint64_t payload;
  };

  std::uint64_t pack(std::size_t position) const noexcept;
  static bool is_due(const PdoSettings& pdo, State& state, std::uint64_t payload) noexcept;
  void request(std::size_t position, std::uint64_t payload) noexcept;
  void transmit(std::size_t position, std::uint64_t payload) noexcept;
  void load_times(std::size_t position) noexcept;
  void sort_out() noexcept;
  std::size_t timer(std::size_t position, Timer which) const noexcept;

  Context& context_;
  PdoParameters parameters_;
  std::size_t first_timer_;
  std::vector<State> states_;
  std::vector<std::uint16_t> synchronous_;
  std::vector<std::uint16_t> event_driven_;
  std::vector<Staged> staged_;
  bool running_ = false;
};

}  // namespace canopen
