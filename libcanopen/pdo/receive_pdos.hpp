#pragma once

#include "libcanopen/pdo/parameters.hpp"
#include "libcanopen/service/service.hpp"
#include "libcanopen/sync/sync_listener.hpp"

namespace canopen {

/// Takes received process data to the dictionary (CiA 301, 7.2.2): event-driven RPDOs at once, synchronous ones
/// with the next SYNC. Reports frames of a wrong length and missed deadlines (sub-index 5, the event timer).
class ReceivePdos final : public Service, public SyncListener, public PdoParameters::Listener {
 public:
  explicit ReceivePdos(Context& context);

  void list_identifiers(IdentifierList& list) const noexcept override;
  /// Nothing is valid before claim_identifiers().
  void reload(Reload how) noexcept override;
  /// As PdoParameters::claim_identifiers().
  void claim_identifiers() noexcept override;
  /// Forgets received values that wait for a SYNC, watches no deadline and no window.
  void stop() noexcept override;

  /// A data frame of the PDO at @p position. One that is shorter than the mapping is ignored and counted, of a
  /// longer one the first bytes count; either is reported once, until a frame has the right length.
  void on_frame(const Frame& frame, std::size_t position) noexcept override;
  /// In Operational received values of synchronous RPDOs take effect. Those that come later than @p window after
  /// the SYNC, if that is not 0, are dropped and counted until the next one (CiA 301, 7.5.2.7).
  void on_sync(std::uint8_t counter, Duration window) noexcept override;
  /// The deadline of the PDO at @p position may be over.
  void on_timer(std::size_t position) noexcept override;

  std::span<const PdoSettings> pdos() const noexcept { return parameters_.pdos(); }
  /// Frames that were too short for their mapping.
  std::uint64_t too_short() const noexcept { return too_short_; }
  /// Frames of synchronous RPDOs that came after the synchronous window.
  std::uint64_t too_late() const noexcept { return too_late_; }

  void on_pdo_changed(std::size_t position) noexcept override;
  void on_pdo_time_changed(std::size_t position, std::uint8_t sub_index, std::int64_t value) noexcept override;

 private:
  /// What was wrong with the length of the last frame.
  enum class Misfit : std::uint8_t { None, TooShort, TooLong };
  static constexpr std::uint8_t kNoPlainLength = 0xFF;

  struct alignas(64) Incoming {
    MappingPlan plan;
    std::uint64_t latched = 0;  ///< waits for SYNC
    TimePoint deadline{};       ///< the armed timer may fire earlier: it is not moved by every frame
    Duration period{};          ///< between two frames, 0 if nobody watches
    std::uint16_t number = 0;   ///< 0 for 1400h
    std::uint8_t plain_length = kNoPlainLength;  ///< of frames that need nothing but to be stored
    bool synchronous = false;
    bool waits = false;      ///< for a SYNC, with `latched`
    bool timed_out = false;  ///< reported
    Misfit misfit = Misfit::None;
  };

  void apply(const Incoming& pdo, std::uint64_t payload) noexcept {
    context_.application.before_rpdo(pdo.number);
    pdo.plan.unpack(payload, image_);
    context_.application.on_rpdo(pdo.number);
  }
  void on_special(std::size_t position, const Frame& frame) noexcept;
  void judge_length(Incoming& pdo, const Frame& frame) noexcept;
  void report(Incoming& pdo, Misfit misfit) noexcept;
  void watch(std::size_t position) noexcept;
  void latch(std::size_t position, std::uint64_t payload) noexcept;
  void apply_waiting() noexcept;
  void apply_together() noexcept;
  void end_timeout(Incoming& pdo) noexcept;
  void load_settings(std::size_t position) noexcept;
  static void choose_path(Incoming& pdo) noexcept;

  std::byte* image_;
  PdoParameters parameters_;
  std::vector<Incoming> incoming_;
  std::vector<std::uint16_t> waiting_;  ///< positions with a latched payload, in the order of their coming
  TimePoint window_end_ = kNever;
  std::uint64_t too_short_ = 0;
  std::uint64_t too_late_ = 0;
};

}  // namespace canopen
