#pragma once

#include <array>
#include <span>

#include "libcanopen/base/export.hpp"
#include "libcanopen/emcy/emcy_producer.hpp"
#include "libcanopen/emcy/error_keeper.hpp"
#include "libcanopen/nmt/error_behaviour.hpp"
#include "libcanopen/nmt/heartbeat_consumer.hpp"
#include "libcanopen/nmt/heartbeat_producer.hpp"
#include "libcanopen/nmt/node_guarding.hpp"
#include "libcanopen/node/context.hpp"
#include "libcanopen/node/routes.hpp"
#include "libcanopen/pdo/receive_pdos.hpp"
#include "libcanopen/pdo/transmit_pdos.hpp"
#include "libcanopen/sdo/servers.hpp"
#include "libcanopen/storage/storage_objects.hpp"
#include "libcanopen/sync/sync_consumer.hpp"
#include "libcanopen/time/time_consumer.hpp"

namespace canopen {

/// A CANopen slave (CiA 301): NMT with error control, SDO, PDO, SYNC, TIME and EMCY over one dictionary. It owns
/// its tables only: the owner feeds it frames and time and carries its frames away. No call allocates, blocks or
/// throws.
class CANOPEN_EXPORT Node final : private IdentifierUse, private ErrorReports {
 public:
  /// The node of @p dictionary; all arguments must outlive it. It does nothing before start().
  Node(Dictionary& dictionary, const Policy& policy, FrameSink& sink, Application& application);
  ~Node() override = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// Lets the SDO servers show what @p view says, which must outlive the node, in place of the dictionary alone.
  /// To be called before start().
  void show(SdoView& view) noexcept { context_.view = &view; }

  /// From now on frames go to @p sink, which must outlive the node: one that drops them takes the node off the
  /// bus.
  void send_to(FrameSink& sink) noexcept { context_.sink = &sink; }
  /// The device handles its process data in @p cycle: event-driven TPDOs leave at the beginning of a cycle only,
  /// the first ones too, and their inhibit and event times are rounded up to whole cycles. The owner calls
  /// on_values_changed() once a cycle, at its beginning or later if it is late; while nothing changes it need not.
  /// In force with the next start(), reload() or reset; at first there is no cycle.
  void set_pdo_cycle(const PdoCycle& cycle) noexcept { context_.pdo_cycle = cycle; }

  /// Boots: sends the boot-up message and enters the start state. Again later, when the bus was away: the
  /// dictionary keeps its values, the services start afresh, no error is present, and Operational is left.
  void start(TimePoint now) noexcept;
  /// Lets every boot-up from now on lead to @p state: Operational, PreOperational or Stopped. Until then it is
  /// Policy::start_state. May be called from within Application::on_reset().
  void set_start_state(NmtState state) noexcept;
  /// The application has put other values into the dictionary: all services go on with them, in the NMT state and
  /// with the errors that there are. What has not changed goes on undisturbed: transfers of SDO servers that keep
  /// their identifiers, heartbeat and guarding. In Operational all PDOs begin anew. What cannot be in force is
  /// treated as after a reset. Nothing happens before start().
  void reload(TimePoint now) noexcept;
  /// A frame from the bus.
  void on_frame(const Frame& frame, TimePoint now) noexcept;
  /// Does what @p wanted says, as if the NMT master had sent it (CiA 301, 7.3.2.2: local NMT services). Nothing
  /// happens before start().
  void command(NmtCommand wanted, TimePoint now) noexcept;
  /// Handles what is due at @p now; belongs after every other call if next_deadline() has come.
  void on_time(TimePoint now) noexcept {
    context_.now = now;
    if (timers_.earliest() <= now) on_timers();
  }
  /// When on_time() is wanted next; kNever if nothing is pending.
  TimePoint next_deadline() const noexcept { return timers_.earliest(); }

  /// The application has put new values into the dictionary: event-driven TPDOs are judged.
  void on_values_changed(TimePoint now) noexcept;

  /// Sends an emergency message (see EmcyProducer::send); the inhibit time counts with the time told last.
  void send_emcy(std::uint16_t code, std::uint8_t error_register,
                 const std::array<std::uint8_t, 5>& manufacturer) noexcept {
    emcy_.send(code, error_register, manufacturer);
  }
  /// An error of the application has come or gone (see ErrorKeeper); nothing happens with ErrorKeeping::Owner. A
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
  void defer_answer() noexcept { context_.answer_deferred = true; }
  /// Gives the answer that was put off, if a client still waits for it: @p result of the write.
  void answer_deferred(const Result<void>& result, TimePoint now) noexcept;
  /// Changes the NMT state as 1029h, sub-index @p error_class, says (CiA 301, 7.5.2.32).
  void apply_error_behaviour(std::uint8_t error_class) noexcept;

  NmtState state() const noexcept { return context_.state; }
  std::uint8_t node_id() const noexcept { return context_.dictionary.node_id(); }
  /// What the node must receive, in ascending order of identifiers, data frames before remote frames.
  std::span<const Subscription> subscriptions() const noexcept { return routes_.subscriptions(); }
  /// Whether a service of the node sends or receives @p identifier.
  bool uses(Identifier identifier) const noexcept { return is_used(identifier); }
  /// All PDOs of the dictionary with what is in force of them, in the order of their numbers.
  std::span<const PdoSettings> receive_pdos() const noexcept { return receive_pdos_.pdos(); }
  std::span<const PdoSettings> transmit_pdos() const noexcept { return transmit_pdos_.pdos(); }
  /// How many PDOs of @p direction have a valid COB-ID.
  std::size_t valid_pdos(Direction direction) const noexcept;
  /// RPDO frames ignored because they were shorter than their mapping.
  std::uint64_t short_rpdos() const noexcept { return receive_pdos_.too_short(); }
  /// Frames of synchronous RPDOs dropped because they came after the synchronous window (1007h).
  std::uint64_t late_rpdos() const noexcept { return receive_pdos_.too_late(); }

 private:
  /// First numbers of the timers of each service.
  struct TimerPlan {
    explicit TimerPlan(const Dictionary& dictionary) noexcept;
    std::size_t heartbeat = 0, guarding = 1, emcy = 2, sdo = 3, consumer, rpdo, tpdo, count;
  };

  void on_remote(const Frame& frame) noexcept;
  void on_nmt(const Frame& frame) noexcept;
  void command(NmtCommand command) noexcept;
  void reset(NmtCommand command) noexcept;
  void boot() noexcept;
  void claim_identifiers() noexcept;
  void enter(NmtState state) noexcept;
  void on_sync(const Frame& frame) noexcept;
  void on_timers() noexcept;
  void on_timer(std::size_t timer) noexcept;

  // identifiers.cpp
  bool is_used(Identifier identifier) const noexcept override;
  void on_identifiers_changed() noexcept override;
  void lay_routes() noexcept;

  void on_error(CommunicationError error, std::uint16_t detail) noexcept override;
  void on_recovery(CommunicationError error, std::uint16_t detail) noexcept override;

  Policy policy_;
  TimerPlan plan_;
  TimerQueue timers_;
  Context context_;
  ServiceGate gate_{};  ///< of the NMT state
  NodeGuarding guarding_;
  HeartbeatProducer heartbeat_;
  HeartbeatConsumer heartbeat_consumer_;
  ErrorBehaviour error_behaviour_;
  SdoServers sdo_servers_;
  ReceivePdos receive_pdos_;
  TransmitPdos transmit_pdos_;
  SyncConsumer sync_;
  TimeConsumer time_;
  EmcyProducer emcy_;
  ErrorKeeper errors_;
  StorageObjects storage_;
  Routes routes_;
};

}  // namespace canopen
