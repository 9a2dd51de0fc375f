#pragma once

#include "libcanopen/application/communication_error.hpp"
#include "libcanopen/base/export.hpp"
#include "libcanopen/base/nmt_state.hpp"
#include "libcanopen/od/entry.hpp"

namespace canopen {

struct TimeOfDay;

/// What the application behind a node is told and asked. Called from within the calls of the node that cause it;
/// must not call Node::start(), reload(), on_frame(), on_time(), on_values_changed() or command(). All other
/// functions of the node may be called, those that end Operational too.
class CANOPEN_EXPORT Application {
 public:
  virtual ~Application() = default;
  /// The NMT state has changed.
  virtual void on_nmt_state(NmtState from, NmtState to) noexcept { (void)from, (void)to; }
  /// ResetNode or ResetCommunication: the dictionary has its initial values again; the application lays stored
  /// values over them with Dictionary::set() before the services start. Dictionary::write() still meets the
  /// services as they were before the reset.
  virtual void on_reset(NmtCommand command) noexcept { (void)command; }
  /// The values of RPDO @p number (0 for 1400h) are about to be stored in place of those before.
  virtual void before_rpdo(std::uint16_t number) noexcept { (void)number; }
  /// The values of RPDO @p number (0 for 1400h) have just been stored.
  virtual void on_rpdo(std::uint16_t number) noexcept { (void)number; }
  /// An SDO client has written @p entry of the dictionary: a value is stored, a command is carried out, the data
  /// of a DOMAIN are complete. The answer has not been sent yet.
  virtual void on_sdo_written(const Entry& entry) noexcept { (void)entry; }
  /// The owner of @p entry, the application or a service, has refused @p value with @p code: an SDO client has
  /// written it to this number, and access, length and limits were right. The abort has not been sent yet.
  virtual void on_write_refused(const Entry& entry, std::int64_t value, AbortCode code) noexcept {
    (void)entry, (void)value, (void)code;
  }
  /// A SYNC has come in Operational, with SyncOrder::ReceiveFirst: the synchronous RPDOs that waited for it, if
  /// any, are all stored and told. What is in the dictionary when this returns is what synchronous TPDOs show.
  virtual void on_synchronous_rpdos() noexcept {}
  /// A SYNC has come and the TPDOs that belong to it are out; @p counter is 0 if it carries none.
  virtual void on_sync(std::uint8_t counter) noexcept { (void)counter; }
  /// The identifiers that the node listens to have changed: see Node::subscriptions().
  virtual void on_subscriptions_changed() noexcept {}
  /// Another station has sent @p identifier, which only this node may send (duplicate node-ID).
  virtual void on_foreign_frame(std::uint32_t identifier) noexcept { (void)identifier; }

  /// An error of the communication has begun; @p detail as CommunicationError says.
  virtual void on_communication_error(CommunicationError error, std::uint16_t detail) noexcept {
    (void)error, (void)detail;
  }
  /// An error of the communication is over, or forgotten with a reset or start().
  virtual void on_communication_recovery(CommunicationError error, std::uint16_t detail) noexcept {
    (void)error, (void)detail;
  }
  /// 100Ch and 100Dh would switch on life guarding, but Policy::remote_frames says that no request can come: a
  /// write was refused, or the values after a reset stay without effect.
  virtual void on_life_guarding_withheld() noexcept {}
  /// The node @p node_id, monitored by 1016h, has told its NMT state for the first time, again after its silence,
  /// or another one than before; Initialising is its boot-up.
  virtual void on_heartbeat(std::uint8_t node_id, NmtState state) noexcept { (void)node_id, (void)state; }
  /// A time stamp has come (1012h).
  virtual void on_time_of_day(const TimeOfDay& time) noexcept { (void)time; }

  /// "save" was written to 1010h, @p sub_index: store the parameters of that group. The answer of the transfer is
  /// the result; HardwareError if they cannot be stored (CiA 301, 7.5.2.13). Node::defer_answer() puts it off.
  virtual Result<void> on_store(std::uint8_t sub_index) noexcept {
    (void)sub_index;
    return refuse(AbortCode::HardwareError);
  }
  /// "load" was written to 1011h, @p sub_index: default values of that group are to come with the next reset
  /// (CiA 301, 7.5.2.14).
  virtual Result<void> on_restore(std::uint8_t sub_index) noexcept {
    (void)sub_index;
    return refuse(AbortCode::HardwareError);
  }
};

}  // namespace canopen
