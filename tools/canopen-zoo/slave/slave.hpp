#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/node/node.hpp"
#include "tools/canopen-zoo/drive/drive.hpp"
#include "tools/canopen-zoo/slave/document.hpp"
#include "tools/canopen-zoo/slave/right_objects.hpp"
#include "tools/canopen-zoo/slave/station.hpp"

namespace zoo {

class Slave;

using canopen::function_code::kEmcy;
using canopen::function_code::kErrorControl;
using canopen::function_code::kSdoRequest;
using canopen::function_code::kSdoResponse;
using canopen::function_code::kSync;

/// How a slave differs from one that does everything right. Everything is right by default.
struct Defect {
  /// Changes the dictionary that is served; the EDS stays right.
  std::function<void(std::vector<canopen::EntryDescription>&)> table = [](auto&) {};
  /// Changes the EDS; the slave stays right.
  std::function<void(std::string& eds)> eds = [](auto&) {};
  std::function<void(canopen::Policy&)> policy = [](auto&) {};
  /// Judges and changes a frame for the slave; false: it never sees it.
  std::function<bool(Slave&, canopen::Frame&)> incoming = [](auto&&...) { return true; };
  /// Judges and changes a frame of the slave; false: it does not leave.
  std::function<bool(Slave&, canopen::Frame&)> outgoing = [](auto&&...) { return true; };
  /// Told of every boot-up, after stored values have come back.
  std::function<void(Slave&)> after_reset = [](auto&) {};
  /// True if "save" and "load" are confirmed, but nothing is done.
  bool forgets_to_store = false, forgets_to_restore = false;
  /// Makes it a drive, which is right but for these.
  std::optional<DriveFlaws> drive{};
};

/// The dictionary of a right slave, or of a right drive where @p defect makes it one.
[[nodiscard]] std::vector<canopen::EntryDescription> objects_of(const Defect& defect);

/// A CANopen slave over objects_of(), with storage in memory: every RPDO advances kCounter, and kMirror follows
/// kStep.
class Slave final : public Station, private canopen::FrameSink, private canopen::Application {
 public:
  /// Boots with @p node_id, 1..127, at @p now.
  explicit Slave(const Defect& defect = {}, std::uint8_t node_id = 5,
                 canopen::TimePoint now = canopen::TimePoint{std::chrono::hours{1}});

  void on_frame(const canopen::Frame& frame, canopen::TimePoint now) override;
  void on_time(canopen::TimePoint now) override;
  canopen::TimePoint next_deadline() const override { return node_.next_deadline(); }
  std::vector<canopen::Frame> take_frames() override { return std::exchange(frames_, {}); }

  canopen::Node& node() noexcept { return node_; }
  canopen::Dictionary& dictionary() noexcept { return dictionary_; }
  std::uint8_t node_id() const noexcept { return dictionary_.node_id(); }
  /// The identifier that @p function_code has with its node-ID in the predefined connection set: 380h for TPDO 3.
  std::uint32_t cob_id(std::uint32_t function_code) const noexcept { return function_code + node_id(); }
  canopen::TimePoint now() const noexcept { return now_; }
  /// Sends @p frame whatever the node thinks of it.
  void say(const canopen::Frame& frame) { frames_.push_back(frame); }
  /// A place for what a defect has to remember.
  std::map<std::string, std::int64_t> memory{};

 private:
  void send(const canopen::Frame& frame, canopen::Delivery delivery) override;
  void on_rpdo(std::uint16_t number) noexcept override;
  void on_reset(canopen::NmtCommand command) noexcept override;
  void on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept override;
  canopen::Result<void> on_store(std::uint8_t sub_index) noexcept override;
  canopen::Result<void> on_restore(std::uint8_t sub_index) noexcept override;

  Defect defect_;
  std::vector<canopen::EntryDescription> table_;
  canopen::Dictionary dictionary_;
  Document document_;
  std::optional<Drive> drive_{};
  canopen::Node node_;
  canopen::TimePoint now_;
  std::vector<canopen::Frame> frames_;
  std::map<std::pair<std::uint16_t, std::uint8_t>, std::int64_t> stored_;
};

}  // namespace zoo
