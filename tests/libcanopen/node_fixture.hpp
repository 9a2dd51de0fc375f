#pragma once

#include <algorithm>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "libcanopen/node/node.hpp"
#include "libcanopen/pdo/settings.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/fakes/vector_bus.hpp"
#include "tests/libcanopen/test_table.hpp"

using namespace std::chrono_literals;

/// Notes what a node tells its application, one word list a call, and reacts from within the call if it is to.
class RecordingApplication final : public canopen::Application {
 public:
  void on_heartbeat(std::uint8_t node_id, canopen::NmtState state) noexcept override {
    tell(told, "node " + std::to_string(node_id) + ": " + std::string{name_of(state)});
  }
  void on_time_of_day(const canopen::TimeOfDay& time) noexcept override {
    tell(told, "day " + std::to_string(time.days) + ", " + std::to_string(time.milliseconds) + " ms");
  }
  canopen::Result<void> on_store(std::uint8_t sub_index) noexcept override {
    tell(told, "store " + std::to_string(sub_index));
    if (deferring != nullptr) deferring->defer_answer();
    return storage_answer;
  }
  canopen::Result<void> on_restore(std::uint8_t sub_index) noexcept override {
    tell(told, "restore " + std::to_string(sub_index));
    return storage_answer;
  }
  canopen::Result<void> storage_answer{};
  canopen::Node* deferring = nullptr;  ///< whose answer to a store is put off

  void on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept override {
    tell(told, std::string{name_of(from)} + " -> " + std::string{name_of(to)});
  }
  void on_reset(canopen::NmtCommand command) noexcept override {
    tell(told, "reset " + std::to_string(static_cast<int>(command)));
  }
  void on_life_guarding_withheld() noexcept override { tell(told, "life guarding withheld"); }
  void on_rpdo(std::uint16_t number) noexcept override { tell(told, "RPDO " + std::to_string(number)); }
  void on_subscriptions_changed() noexcept override { ++subscription_changes; }
  void on_write_refused(const canopen::Entry& entry, std::int64_t value,
                        canopen::AbortCode code) noexcept override {
    char text[64];
    std::snprintf(text, sizeof text, "%04X:%02X = %llX: %08X", entry.index, entry.sub_index,
                  static_cast<unsigned long long>(value), static_cast<unsigned>(code));
    tell(refused, text);
  }
  void on_foreign_frame(std::uint32_t identifier) noexcept override { foreign.push_back(identifier); }
  void on_communication_error(canopen::CommunicationError error, std::uint16_t detail) noexcept override {
    tell(errors, text_of(error, detail));
  }
  void on_communication_recovery(canopen::CommunicationError error, std::uint16_t detail) noexcept override {
    tell(errors, text_of(error, detail) + " over");
  }

  std::vector<std::string> told;
  std::vector<std::uint32_t> foreign;
  std::vector<std::string> refused;  ///< writes: "1400:01 = 211: 08000022"
  std::vector<std::string> errors;   ///< EMCY code and detail: "8210 1", "8210 1 over"
  int subscription_changes = 0;
  std::function<void(const std::string&)> reaction;  ///< called with what has just been told

 private:
  void tell(std::vector<std::string>& where, const std::string& what) const {
    where.push_back(what);
    if (reaction) reaction(what);
  }
  static std::string text_of(canopen::CommunicationError error, std::uint16_t detail) {
    char text[16];
    std::snprintf(text, sizeof text, "%04X %u", canopen::row_of(error).emcy_code, detail);
    return text;
  }
};

/// A line of a dialogue: what a master sends and what the node answers at once, "" for silence.
struct Exchange {
  std::string_view request, answer;
};

/// Node 5 over the test table on a bus of its own, with a clock that the test moves.
class NodeTest : public testing::Test {
 protected:
  using Lines = std::vector<std::string>;

  /// Identifiers have 11 bits unless the test says otherwise.
  explicit NodeTest(const canopen::Policy& policy = {.extended_identifiers = false},
                    std::span<const canopen::EntryDescription> table = test_table())
      : dictionary{table, 5} {
    node.emplace(dictionary, policy, bus, application);
  }

  /// Boots the node and returns what it sent.
  Lines start();
  /// Boots the node and takes it to Operational; what it sent is forgotten.
  void start_operational();
  /// What the node has sent since the last of these calls.
  Lines sent();
  /// A frame comes from the bus; returns what the node sent, what fell due at this very moment included.
  Lines says(std::string_view frame);
  /// Time passes; returns what the node sent, each line with its time since construction: "100ms 705#7F".
  Lines passes(canopen::Duration time);
  /// The application has put @p value into @p index and tells the node so.
  Lines sets(std::uint16_t index, std::int64_t value);
  /// Puts @p value into the dictionary, without a word to the node.
  void store_value(std::uint16_t index, std::uint8_t sub_index, std::int64_t value);
  /// The number in the dictionary.
  std::int64_t value_of(std::uint16_t index, std::uint8_t sub_index = 0) const;

  /// SDO download of @p size bytes; 0 or the abort code of the answer.
  std::uint32_t writes(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value, unsigned size);
  std::uint32_t writes_u8(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value) {
    return writes(index, sub_index, value, 1);
  }
  std::uint32_t writes_u16(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value) {
    return writes(index, sub_index, value, 2);
  }
  std::uint32_t writes_u32(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value) {
    return writes(index, sub_index, value, 4);
  }
  /// Plays @p exchanges in order and compares every answer.
  void expect_dialogue(std::initializer_list<Exchange> exchanges);

  /// The identifiers whose data frames the node wants.
  std::vector<std::uint32_t> subscriptions() const {
    std::vector<std::uint32_t> identifiers;
    for (const canopen::Subscription& wanted : node->subscriptions())
      if (!wanted.remote) identifiers.push_back(wanted.identifier);
    return identifiers;
  }

  static constexpr canopen::TimePoint kStart{1h};
  canopen::TimePoint now = kStart;
  fakes::VectorBus bus;
  RecordingApplication application;
  canopen::Dictionary dictionary;
  std::optional<canopen::Node> node;
};
