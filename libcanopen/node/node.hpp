#pragma once

#include <array>
#include <span>
#include <vector>

#include "libcanopen/base/export.hpp"
#include "libcanopen/base/identifier_use.hpp"
#include "libcanopen/emcy/emcy_producer.hpp"
#include "libcanopen/nmt/heartbeat_producer.hpp"
#include "libcanopen/node/context.hpp"
#include "libcanopen/node/policy.hpp"
#include "libcanopen/pdo/receive_pdos.hpp"
#include "libcanopen/pdo/transmit_pdos.hpp"
#include "libcanopen/sdo/server.hpp"
#include "libcanopen/sync/sync_consumer.hpp"

namespace canopen {

/// What the application behind a node is told. Called from within on_frame() and on_time(); must not call back
/// into either of them.
class CANOPEN_EXPORT Application {
 public:
  virtual ~Application() = default;
  /// The NMT state has changed.
  virtual void on_nmt_state(NmtState from, NmtState to) noexcept { (void)from, (void)to; }
  /// ResetNode or ResetCommunication: the dictionary has its initial values again; the application lays stored
  /// values over them before the services start.
  virtual void on_reset(NmtCommand command) noexcept { (void)command; }
  /// The values of RPDO @p number (0 for 1400h) have just been stored.
  virtual void on_rpdo(std::uint16_t number) noexcept { (void)number; }
  /// The identifiers that the node listens to have changed: see Node::subscriptions().
  virtual void on_subscriptions_changed() noexcept {}
  /// Another station has sent @p identifier, which only this node may send (duplicate node-ID).
  virtual void on_foreign_frame(std::uint32_t identifier) noexcept { (void)identifier; }
};

/// A CANopen slave (CiA 301): NMT, heartbeat, SDO, PDO, SYNC and EMCY over one dictionary. It owns its tables
/// only: the owner feeds it frames and time and carries its frames away. No call allocates, blocks or throws.
class CANOPEN_EXPORT Node final : private IdentifierUse, private ReceivePdos::Receiver {
 public:
  /// The node of @p dictionary; all arguments must outlive it. It does nothing before start().
  Node(Dictionary& dictionary, const Policy& policy, FrameSink& sink, Application& application);
  ~Node() override = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// Boots: sends the boot-up message and enters the start state. Again later, when the bus was away: the
  /// dictionary keeps its values, the services start afresh, and Operational is left.
  void start(TimePoint now) noexcept;
  /// A frame from the bus.
  void on_frame(const Frame& frame, TimePoint now) noexcept;
  /// Handles what is due at @p now.
  void on_time(TimePoint now) noexcept;
  /// When on_time() is wanted next; kNever if nothing is pending.
  TimePoint next_deadline() const noexcept { return timers_.earliest(); }

  /// The application has put new values into the dictionary: event-driven TPDOs are judged.
  void on_values_changed(TimePoint now) noexcept;
  /// Sends an emergency message (see EmcyProducer::send).
  void send_emcy(std::uint16_t code, std::uint8_t error_register,
                 const std::array<std::uint8_t, 5>& manufacturer) noexcept {
    emcy_.send(code, error_register, manufacturer);
  }

  NmtState state() const noexcept { return context_.state; }
  std::uint8_t node_id() const noexcept { return context_.dictionary.node_id(); }
  /// The identifiers that the node must receive as data frames, in ascending order.
  std::span<const std::uint32_t> subscriptions() const noexcept { return subscriptions_; }
  /// RPDO frames ignored because they were shorter than their mapping.
  std::uint64_t short_rpdos() const noexcept { return receive_pdos_.too_short(); }

 private:
  enum class Service : std::uint8_t { None, Nmt, Sync, Sdo, Rpdo, Own };
  struct Route {
    Service service = Service::None;
    std::uint16_t position = 0;
  };

  void on_nmt(const Frame& frame) noexcept;
  void command(NmtCommand command) noexcept;
  void reset(NmtCommand command) noexcept;
  void boot() noexcept;
  void enter(NmtState state) noexcept;
  void on_sync() noexcept;
  void on_timer(std::size_t timer) noexcept;
  void on_rpdo(std::uint16_t number) noexcept override;

  bool is_used(std::uint32_t identifier) const noexcept override;
  void on_identifiers_changed() noexcept override;
  void lay_routes() noexcept;

  Policy policy_;
  Application& application_;
  TimerQueue timers_;
  Context context_;
  ServiceGate gate_{};  ///< of the NMT state
  HeartbeatProducer heartbeat_;
  std::vector<SdoServer> sdo_servers_;
  ReceivePdos receive_pdos_;
  TransmitPdos transmit_pdos_;
  SyncConsumer sync_;
  EmcyProducer emcy_;
  std::array<Route, 2048> routes_{};
  std::vector<std::uint32_t> subscriptions_;
};

}  // namespace canopen
