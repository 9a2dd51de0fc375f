#pragma once

#include "libcanopen/pdo/parameters.hpp"
#include "libcanopen/pdo/pdo_cycle.hpp"
#include "libcanopen/service/service.hpp"
#include "libcanopen/sync/sync_listener.hpp"

namespace canopen {

/// Sends process data (CiA 301, 7.2.2): types 1..240 with every n-th SYNC, type 0 with the SYNC after a change,
/// type 252 on request with the values of the last SYNC, type 253 on request, types 254 and 255 on a change, by
/// the event timer and on request, never closer than the inhibit time. Types 0..240 answer a request as well. With
/// a PdoCycle, changes, times and the first frame of types 254 and 255 are judged where a cycle begins.
class TransmitPdos final : public Service, public SyncListener, public PdoParameters::Listener {
 public:
  explicit TransmitPdos(Context& context);
  /// See Node::set_pdo_cycle().
  void set_cycle(const PdoCycle& cycle) noexcept { cycle_ = cycle; }

  void list_identifiers(IdentifierList& list) const noexcept override;
  /// Nothing is valid before claim_identifiers(), and nothing is sent before start(). Inhibit times that run go on
  /// unless @p how is Afresh.
  void reload(Reload how) noexcept override;
  /// As PdoParameters::claim_identifiers().
  void claim_identifiers() noexcept override;
  /// The event-driven TPDOs send their first frame, at once (with a PdoCycle: where
  /// the next one begins) unless an inhibit time still runs, and all cycles of SYNCs begin anew.
  void start() noexcept override;
  void stop() noexcept override;
  /// Takes the values of all TPDOs concerned first, then sends them,
  /// so that they belong together.
  void on_sync(std::uint8_t counter, Duration window) noexcept override;
  /// The owner has new values: event-driven TPDOs whose values differ from those last sent are due.
  void on_values_changed() noexcept;
  /// A remote frame asks for the PDO at @p position.
  void on_request(std::size_t position) noexcept override;
  void on_timer(std::size_t which) noexcept override;

  std::span<const PdoSettings> pdos() const noexcept { return parameters_.pdos(); }

  void on_pdo_changed(std::size_t position) noexcept override;
  void on_pdo_time_changed(std::size_t position, std::uint8_t sub_index, std::int64_t value) noexcept override;

 private:
  enum class Timer : std::uint8_t { Event, Inhibit };
  static constexpr std::size_t kTimersEach = 2;

  /// What makes a TPDO be sent, besides a request.
  enum class Trigger : std::uint8_t {
    None,
    Cyclic,   ///< every n-th SYNC
    Acyclic,  ///< a SYNC after a change
    Sampled,  ///< nothing, but SYNC decides on the values
    Event,    ///< a change, the event timer
  };
  struct TypeRow {
    std::uint8_t last;  ///< from the type after that of the row before
    Trigger trigger;
  };
  static constexpr std::array kTriggers{
      TypeRow{0, Trigger::Acyclic},   TypeRow{240, Trigger::Cyclic}, TypeRow{251, Trigger::None},
      TypeRow{252, Trigger::Sampled}, TypeRow{253, Trigger::None},   TypeRow{255, Trigger::Event},
  };

  struct alignas(64) Outgoing {
    Frame frame{};  ///< as last sent, or as the last SYNC has found it
    MappingPlan plan{};
    TimePoint sent = TimePoint::min();  ///< event-driven: the last frame, or the cycle that began with it
    Duration inhibit{};
    Duration event_period{};
    Trigger trigger = Trigger::None;
    std::uint8_t period = 1;      ///< SYNCs from one frame to the next
    std::uint8_t left = 1;        ///< SYNCs until then
    std::uint8_t first_sync = 0;  ///< counter of the SYNC that the first cycle begins with, 0 for any
    bool waits = false;           ///< for that SYNC
    bool fresh = true;            ///< no SYNC has taken values since start()
    bool is_due = false;          ///< to be sent after the inhibit time, even if nothing has changed

    std::uint64_t payload() const noexcept { return load<std::uint64_t>(frame.data.data()); }
    void set_payload(std::uint64_t payload) noexcept { store(frame.data.data(), payload); }
  };

  static Trigger trigger_of(const PdoSettings& pdo) noexcept;
  std::uint64_t pack(const Outgoing& pdo) const noexcept { return pdo.plan.pack(image_); }
  static bool takes(Outgoing& pdo, std::uint64_t payload) noexcept;
  void begin_cycles(std::uint8_t counter) noexcept;
  void note_last_sync(Outgoing& pdo) const noexcept;
  void begin_anew(Outgoing& pdo) noexcept;
  void request(std::size_t position, std::uint64_t payload) noexcept;
  void transmit(std::size_t position, std::uint64_t payload) noexcept;
  void load_settings(std::size_t position) noexcept;
  void begin_moment() noexcept { moment_ = cycle_.begin_of(context_.now); }
  void sort_out() noexcept;
  static constexpr std::size_t timer(std::size_t position, Timer which) noexcept {
    return position * kTimersEach + static_cast<std::size_t>(which);
  }

  const std::byte* image_;
  PdoCycle cycle_{};  ///< what event-driven TPDOs are judged in
  PdoParameters parameters_;
  std::vector<Outgoing> outgoing_;
  std::vector<std::uint16_t> synchronous_;   ///< positions that SYNC concerns
  std::vector<std::uint16_t> event_driven_;  ///< positions that changes concern
  std::vector<const Frame*> staged_;
  TimePoint moment_{};  ///< what event-driven TPDOs are judged at: now, or the beginning of this cycle
  TimePoint last_sync_ = TimePoint::min();
  bool any_waits_ = false;  ///< for the SYNC that its first cycle begins with
  bool running_ = false;
};

}  // namespace canopen
