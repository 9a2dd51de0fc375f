#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "eds/description/description.hpp"
#include "tools/canopen-check/core/check.hpp"
#include "tools/canopen-check/core/run/manners.hpp"
#include "tools/canopen-check/core/run/undo_log.hpp"

namespace conformance {

/// What the user decides about a run.
struct Settings {
  std::uint8_t node_id = 1;
  Mode mode = Mode::ReadOnly;
  bool allow_store = false;
  bool allow_motion = false;
  bool allow_reset = true;                                     ///< NMT commands that reset the node
  canopen::Duration patience = std::chrono::seconds{1};        ///< for an SDO answer
  canopen::Duration boot_up_limit = std::chrono::seconds{10};  ///< from a reset command to the boot-up message
  double tolerance = 0.1;                                      ///< of measured periods, as a part of them
  canopen::Duration slack = std::chrono::milliseconds{5};      ///< of measured periods, added to it
  std::uint64_t seed = 1;                                      ///< of random frames
  std::vector<std::string> skip{};  ///< checks that are left out, as is_named() takes them
};

/// What one check works with, and what it says.
class Context {
 public:
  Context(Session& session, SdoClient& sdo, const eds::Description& eds, const Settings& settings,
          Manners& manners)
      : session_{&session}, sdo_{&sdo}, eds_{&eds}, settings_{&settings}, manners_{&manners}, undo_{sdo} {}

  // What it works with.
  [[nodiscard]] Session& session() noexcept { return *session_; }
  [[nodiscard]] SdoClient& sdo() noexcept { return *sdo_; }
  [[nodiscard]] const eds::Description& eds() const noexcept { return *eds_; }
  [[nodiscard]] const Settings& settings() const noexcept { return *settings_; }
  [[nodiscard]] UndoLog& undo() noexcept { return undo_; }
  /// What earlier checks have found out, and this one finds out for later ones.
  [[nodiscard]] Manners& manners() noexcept { return *manners_; }
  [[nodiscard]] const Manners& manners() const noexcept { return *manners_; }

  // What it says.
  /// Begins a step: frames from here on belong to the next finding.
  void step() { mark_ = session_->mark(); }
  /// Begins a step that rests on @p traffic of before.
  void step(std::span<const TimedFrame> traffic) {
    step();
    session_->recall(traffic);
  }
  /// The traffic of the step so far.
  [[nodiscard]] std::span<const TimedFrame> traffic() const noexcept { return session_->since(mark_); }
  /// A finding about @p subject.
  void fail(Subject subject, std::string expected, std::string found);
  /// A finding about an entry.
  void fail(std::uint16_t index, std::uint8_t sub_index, std::string expected, std::string found) {
    fail(Subject{index, sub_index}, std::move(expected), std::move(found));
  }
  /// A finding about the node.
  void fail(std::string expected, std::string found) { fail(Subject{}, std::move(expected), std::move(found)); }
  /// The check does not apply, for @p reason; it returns then.
  void skip(std::string reason) { skipped_ = std::move(reason); }
  /// The check applies after all: another part of it does.
  void unskip() noexcept { skipped_.reset(); }
  /// Something worth to know, such as a measured time.
  void note(std::string text) { notes_.push_back(std::move(text)); }
  [[nodiscard]] bool failed() const noexcept { return !findings_.empty(); }

  // Objects. Everything written this way is restored behind the check.
  /// True if the EDS has the entry, or if there is no EDS and the node answers an upload of it. Else the check is
  /// skipped with the reason that it is not there, and has to return.
  bool need(std::uint16_t index, std::uint8_t sub_index = 0);
  /// True if the EDS says that the entry cannot be written: const or ro.
  [[nodiscard]] bool is_fixed(std::uint16_t index, std::uint8_t sub_index) const noexcept;
  SdoAnswer read(std::uint16_t index, std::uint8_t sub_index = 0) { return sdo_->upload(index, sub_index); }
  /// The value of a numeric entry; nothing, and a finding, where it cannot be read.
  std::optional<std::uint64_t> number(std::uint16_t index, std::uint8_t sub_index = 0);
  /// The number in @p answer, an upload of that entry; nothing, and a finding, where there is none.
  std::optional<std::uint64_t> number_in(const SdoAnswer& answer, std::uint16_t index, std::uint8_t sub_index = 0);
  SdoAnswer write(std::uint16_t index, std::uint8_t sub_index, std::span<const std::uint8_t> bytes) {
    return undo_.write(index, sub_index, bytes);
  }
  /// Writes a number in the length that the EDS states; without one, in that which an upload has.
  SdoAnswer write_number(std::uint16_t index, std::uint8_t sub_index, std::uint64_t value);
  /// Writes a number that has to be taken; false, and a finding, where it is not. Of an entry that the EDS does
  /// not call writable nothing is expected: the check is skipped.
  bool set(std::uint16_t index, std::uint8_t sub_index, std::uint64_t value);
  /// A finding unless @p answer is an abort with one of @p codes. The general code 08000000h is accepted with a
  /// note, and so is one for what is read only if is_fixed(). @p request tells what was asked: "writing 00 to it".
  void expect_abort(const SdoAnswer& answer, std::initializer_list<std::uint32_t> codes, std::uint16_t index,
                    std::uint8_t sub_index, const std::string& request);

  // NMT.
  /// False, and the check is skipped, where the user forbids resets.
  bool may_reset();
  /// Sends a reset and waits for the boot-up message: the time that it took; nothing, and a finding, if it does
  /// not come within the limit. The node is left in the state which it enters by itself. Not without may_reset().
  std::optional<canopen::Duration> reset(canopen::NmtCommand command);
  /// Sends a reset and waits until the node is back: for its boot-up message, or for an answer to SDO requests
  /// from one that sends none, which is the finding of another check. False, and the check is skipped, if neither
  /// comes.
  bool restart(canopen::NmtCommand command);
  /// Commands a state that is not Initialising. A check that enters Operational rests on that the node does so:
  /// where it is known to refuse, the check is skipped for that reason, whatever it finds.
  void enter(canopen::NmtState state);
  /// As enter() does, for checks that command Operational otherwise.
  void rest_on_operational() noexcept { was_operational_ = true; }
  /// Prepares the node to tell its state: by guarding if it answers, else by a heartbeat of 100 ms. False, and the
  /// check is skipped, where it does neither. In Pre-operational or Operational only.
  bool observe_state();
  /// The state that the node tells now; nothing if it tells none. After observe_state().
  std::optional<canopen::NmtState> state();
  /// A finding unless the node is in @p expected; @p after tells what went before.
  bool expect_state(canopen::NmtState expected, const std::string& after);
  /// True if @p measured is @p wanted within the tolerance and slack of the settings.
  [[nodiscard]] bool about(canopen::Duration measured, canopen::Duration wanted) const noexcept;
  /// How long an answer of the SDO server is waited for that must not come, and how long a reaction is given at
  /// first that is looked at once more where it has not come: ten times as long as 95 of the last hundred answers
  /// to SDO requests took at the most, but 10 ms at least; @p most where that is less, and while few answers are
  /// known. It tells nothing of other services of the node.
  [[nodiscard]] canopen::Duration quiet(canopen::Duration most) const;

  // For the runner.
  [[nodiscard]] const std::optional<std::string>& skipped() const noexcept { return skipped_; }
  /// True if the check has entered Operational.
  [[nodiscard]] bool was_operational() const noexcept { return was_operational_; }
  [[nodiscard]] std::vector<Finding>& findings() noexcept { return findings_; }
  [[nodiscard]] std::vector<std::string>& notes() noexcept { return notes_; }

 private:
  [[nodiscard]] std::optional<canopen::NmtState> guard();
  [[nodiscard]] std::optional<TimedFrame> boot_up(canopen::Duration patience);

  Session* session_;
  SdoClient* sdo_;
  const eds::Description* eds_;
  const Settings* settings_;
  Manners* manners_;
  UndoLog undo_;
  std::size_t mark_ = 0;
  bool by_guarding_ = false;
  bool was_operational_ = false;
  std::optional<std::string> skipped_;
  std::vector<Finding> findings_;
  std::vector<std::string> notes_;
};

/// @p time in milliseconds: "12.3 ms".
[[nodiscard]] std::string milliseconds(canopen::Duration time);

/// The bits that make @p number an identifier in a COB-ID.
inline constexpr std::uint32_t kIdentifierBits = 0x1FFF'FFFF;
/// Bit 31 of a COB-ID: the service does not exist.
inline constexpr std::uint32_t kInvalid = 0x8000'0000;
/// Bit 30: of a TPDO no remote frame is answered; of 1005h the node produces SYNC.
inline constexpr std::uint32_t kBit30 = 0x4000'0000;

}  // namespace conformance
