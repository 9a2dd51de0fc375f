#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "libcanopen/application/application.hpp"
#include "libcanopen/application/communication_error.hpp"
#include "libcanopen/application/policy.hpp"
#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/export.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/nmt_state.hpp"
#include "libcanopen/base/time.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "libcanopen/pdo/pdo_cycle.hpp"
#include "libcanopen/service/sdo_answer_counters.hpp"
#include "libcanopen/service/subscription.hpp"
#include "libcanopen/time/time_of_day.hpp"

namespace canopen {

class SdoView;
enum class Direction : std::uint8_t;
struct Context;
struct PdoSettings;

/// A CANopen slave (CiA 301): NMT with error control, SDO, PDO, SYNC, TIME and EMCY over one dictionary. It owns
/// its tables only: the owner feeds it frames and time and carries its frames away. No call allocates, blocks or
/// throws.
class CANOPEN_EXPORT Node final {
 public:
  /// The node of @p dictionary; all arguments must outlive it. It does nothing before start().
  Node(Dictionary& dictionary, const Policy& policy, FrameSink& sink, Application& application);
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// Lets the SDO servers show what @p view says, which must outlive the node, in place of the dictionary alone.
  /// To be called before start().
  void show(SdoView& view) noexcept;
  /// Where services besides those of CiA 301 register themselves (see Service), before start(). They must live as
  /// long as the node is called.
  Context& context() noexcept;

  /// From now on frames go to @p sink, which must outlive the node: one that drops them takes the node off the
  /// bus.
  void send_to(FrameSink& sink) noexcept;
  /// The device handles its process data in @p cycle: event-driven TPDOs leave at the beginning of a cycle only,
  /// the first ones too, and their inhibit and event times are rounded up to whole cycles. The owner calls
  /// on_values_changed() once a cycle, at its beginning or later if it is late; while nothing changes it need not.
  /// In force with the next start(), reload() or reset; at first there is no cycle.
  void set_pdo_cycle(const PdoCycle& cycle) noexcept;

  /// Boots: sends the boot-up message and enters the start state. Again later, when the bus was away: the
  /// dictionary keeps its values, the services start afresh, no error is present, and Operational is left.
  void start(TimePoint now) noexcept;
  /// Lets every boot-up from now on lead to @p state: Operational, PreOperational or Stopped. Until then it is
  /// Policy::start_state. May be called from within Application::on_reset().
  void set_start_state(NmtState state) noexcept;
  /// The node has @p node_id, 1..127, from the next reset or start() on, or none (kNoNodeId): then it is
  /// Unconfigured after that, silent until it has one and is reset. At first it is that of the dictionary. A
  /// start() that brings another one into force is a reset communication. May be called from within
  /// Application::on_nmt_state(), for the very reset that enters Initialising too.
  void set_node_id(std::uint8_t node_id) noexcept;
  /// The application has put other values into the dictionary: all services go on with them, in the NMT state and
  /// with the errors that there are. What has not changed goes on undisturbed: transfers of SDO servers that keep
  /// their identifiers, heartbeat and guarding. In Operational all PDOs begin anew. What cannot be in force is
  /// treated as after a reset. Nothing happens before start().
  void reload(TimePoint now) noexcept;
  /// A frame from the bus.
  void on_frame(const Frame& frame, TimePoint now) noexcept;
  /// Does what @p wanted says, as if the NMT master had sent it (CiA 301, 7.3.2.2: local NMT services). Nothing
  /// happens before start(), and in Unconfigured nothing but a reset.
  void command(NmtCommand wanted, TimePoint now) noexcept;
  /// Handles what is due at @p now; belongs after every other call if next_deadline() has come.
  void on_time(TimePoint now) noexcept {
    *now_ = now;
    if (*earliest_ <= now) on_timers();
  }
  /// When on_time() is wanted next; kNever if nothing is pending.
  TimePoint next_deadline() const noexcept { return *earliest_; }

  /// The application has put new values into the dictionary: event-driven TPDOs are judged.
  void on_values_changed(TimePoint now) noexcept;

  /// Sends error code @p code with the error register and the five manufacturer bytes; nothing in the NMT states
  /// that have no EMCY. The inhibit time counts with the time told last.
  void send_emcy(std::uint16_t code, std::uint8_t error_register,
                 const std::array<std::uint8_t, 5>& manufacturer) noexcept;
  /// An error of the application has come or gone ; nothing happens with ErrorKeeping::Owner. A
  /// reset forgets all errors, and so does start(): what persists is raised again, after a reset at the earliest
  /// in Application::on_nmt_state() that leaves Initialising.
  void raise_error(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept;
  void clear_error(std::uint16_t code, std::uint16_t detail) noexcept;
  /// The owner of the bus has detected an error of the communication, or its end: the node treats it as one of its
  /// own (EMCY, 1029h). It is one error until its recovery is reported, an event like BusOffRecovered too: without
  /// that the next one sends no EMCY.
  void report(CommunicationError error, TimePoint now) noexcept;
  void report_recovery(CommunicationError error, TimePoint now) noexcept;
  /// From within Application::on_store(), EntryOwner::write() or SdoView::write() that an SDO client has caused
  /// and that succeeds: the client gets its answer from answer_deferred(), not before. The same request again gets
  /// none meanwhile; any other of that client, an abort of it and a reset give the answer up. One at a time.
  void defer_answer() noexcept;
  /// Gives the answer that was put off, if a client still waits for it: @p result of the write.
  void answer_deferred(const Result<void>& result, TimePoint now) noexcept;
  /// Changes the NMT state as 1029h, sub-index @p error_class, says (CiA 301, 7.5.2.32).
  void apply_error_behaviour(std::uint8_t error_class) noexcept;

  NmtState state() const noexcept;
  /// The node-ID in force, kNoNodeId if there is none.
  std::uint8_t node_id() const noexcept;
  /// What the node must receive, in ascending order of identifiers, data frames before remote frames.
  std::span<const Subscription> subscriptions() const noexcept;
  /// Whether a service of the node sends or receives @p identifier.
  bool uses(Identifier identifier) const noexcept;
  /// All PDOs of the dictionary with what is in force of them, in the order of their numbers; while there is no
  /// node-ID what was in force last.
  std::span<const PdoSettings> receive_pdos() const noexcept;
  std::span<const PdoSettings> transmit_pdos() const noexcept;
  /// How many PDOs of @p direction have a valid COB-ID.
  std::size_t valid_pdos(Direction direction) const noexcept;
  /// RPDO frames ignored because they were shorter than their mapping.
  std::uint64_t short_rpdos() const noexcept;
  /// How many SDO servers there are, one at least.
  std::size_t sdo_servers() const noexcept;
  /// What the SDO server at @p position (below sdo_servers(); 0: that of 1200h) has answered.
  const SdoAnswerCounters& sdo_answers(std::size_t position) const noexcept;
  /// Frames of synchronous RPDOs dropped because they came after the synchronous window (1007h).
  std::uint64_t late_rpdos() const noexcept;

 private:
  struct Parts;

  void on_timers() noexcept;

  std::unique_ptr<Parts> parts_;
  TimePoint* now_;             ///< the time that the services see
  const TimePoint* earliest_;  ///< deadline of their timers
};

}  // namespace canopen
