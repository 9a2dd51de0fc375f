#include <cstdlib>
#include <iostream>
#include <map>
#include <random>

#include "tests/libcanopen/fixture/lss_fixture.hpp"

namespace {

using canopen::Frame;
using canopen::LssState;

constexpr std::uint32_t kIdentity[] = {0x2A, 0x00010002, 0x00030004, 0x12345678};
constexpr unsigned kNone = 255;

/// What CiA 305 says of a slave, told once more: by the requests that have come since the last one that mattered.
class Model {
 public:
  using Bytes = std::array<std::uint8_t, 8>;

  /// The answer to @p request, and what else the node does: 7xx#00.
  std::optional<Frame> hears(const Bytes& request) {
    const unsigned command = request[0];
    row_.push_back(request);
    if (command == 0x04) return switches(request[1]);
    if (command == 0x4C) return is_free() ? answer(0x50) : std::nullopt;
    if (command == 0x51) return scans(request);
    if (command >= 0x40 && command <= 0x43 && waits && ends({0x40, 0x41, 0x42, 0x43})) {
      waits = false;
      return answer(0x44);
    }
    if (command >= 0x46 && command <= 0x4B && ends({0x46, 0x47, 0x48, 0x49, 0x4A, 0x4B})) return answer(0x4F);
    return waits ? std::nullopt : configures(request);
  }
  /// NMT reset communication, which an unconfigured node does not hear.
  std::optional<Frame> resets() {
    if (active == kNone) return std::nullopt;
    return boots();
  }

  unsigned active = 5, pending = 5, rate = 0;
  bool waits = true;

 private:
  static std::optional<Frame> answer(std::uint8_t command, std::uint32_t value = 0) {
    Frame frame{.id = 0x7E4, .length = 8, .data = {command}};
    for (unsigned i = 0; i < 4; ++i) frame.data[1 + i] = static_cast<std::uint8_t>(value >> 8 * i);
    return frame;
  }
  static std::uint32_t number(const Bytes& request) {
    std::uint32_t value = 0;
    for (unsigned i = 4; i > 0; --i) value = value << 8 | request[i];
    return value;
  }
  bool is_free() const { return active == kNone && pending == kNone; }

  /// Do the last requests have these commands, and do their numbers fit?
  bool ends(std::initializer_list<std::uint8_t> commands) const {
    if (row_.size() < commands.size()) return false;
    auto at = row_.end() - static_cast<std::ptrdiff_t>(commands.size());
    for (const std::uint8_t command : commands) {
      const std::uint32_t wanted = number(*at);
      if ((*at++)[0] != command) return false;
      const bool fits = command <= 0x43                      ? kIdentity[command - 0x40] == wanted
                        : command <= 0x47                    ? kIdentity[command - 0x46] == wanted
                        : command == 0x48 || command == 0x4A ? kIdentity[command / 2 - 0x22] >= wanted
                                                             : kIdentity[(command - 1) / 2 - 0x22] <= wanted;
      if (!fits) return false;
    }
    return true;
  }
  std::optional<Frame> boots() {
    active = pending;
    waits = true;
    position_ = 0;
    row_.clear();
    if (active == kNone) return std::nullopt;
    return Frame{.id = 0x700 + active, .length = 1};
  }
  std::optional<Frame> switches(unsigned mode) {
    const bool was_configured = !waits;
    if (mode <= 1) waits = mode == 0;
    row_.clear();
    return mode == 0 && was_configured && active == kNone && pending != kNone ? boots() : std::nullopt;
  }
  std::optional<Frame> scans(const Bytes& request) {
    if (!waits || !is_free()) return std::nullopt;
    if (request[5] == 0x80) {
      position_ = 0;
      return answer(0x4F);
    }
    if (request[5] > 31 || request[6] != position_ || request[7] > 3) return std::nullopt;
    for (unsigned bit = request[5]; bit < 32; ++bit)
      if ((kIdentity[position_] >> bit & 1) != (number(request) >> bit & 1)) return std::nullopt;
    if (request[5] == 0) {
      waits = request[7] >= request[6];
      position_ = request[7];
    }
    return answer(0x4F);
  }
  std::optional<Frame> configures(const Bytes& request) {
    static const std::map<unsigned, unsigned> rates{{0, 1000}, {1, 800}, {2, 500}, {3, 250},
                                                    {4, 125},  {6, 50},  {7, 20},  {8, 10}};
    const unsigned command = request[0], value = request[1];
    if (command == 0x11) {
      const bool good = value != 0 && (value < 128 || value == 255);
      if (good) pending = value;
      return answer(0x11, good ? 0 : 1);
    }
    if (command == 0x13) {
      const bool good = value == 0 && rates.contains(request[2]);
      if (good) rate = rates.at(request[2]);
      return answer(0x13, good ? 0 : 1);
    }
    if (command == 0x17) return answer(0x17);
    if (command >= 0x5A && command <= 0x5D) return answer(request[0], kIdentity[command - 0x5A]);
    return command == 0x5E ? answer(0x5E, active) : std::nullopt;
  }

  std::vector<Bytes> row_;
  unsigned position_ = 0;
};

/// A master that sends anything, right requests more often than chance would have it.
class LssModel : public LssTest {
 protected:
  using Bytes = Model::Bytes;

  unsigned below(unsigned end) { return static_cast<unsigned>(random() % end); }
  static void put(Bytes& bytes, std::uint32_t number) {
    for (unsigned i = 0; i < 4; ++i) bytes[1 + i] = static_cast<std::uint8_t>(number >> 8 * i);
  }
  Bytes any() {
    Bytes bytes{};
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    return bytes;
  }
  /// A request of a sequence, most often the one that belongs there.
  Bytes next_part() {
    static constexpr std::uint8_t kCommands[] = {0x40, 0x41, 0x42, 0x43, 0x46, 0x47, 0x48, 0x49, 0x4A, 0x4B};
    static constexpr unsigned kNumbers[] = {0, 1, 2, 3, 0, 1, 2, 2, 3, 3};
    part_ = below(16) != 0 ? (part_ + 1) % 10 : below(10);
    Bytes bytes = below(8) != 0 ? Bytes{} : any();
    bytes[0] = kCommands[part_];
    if (below(16) != 0) put(bytes, kIdentity[kNumbers[part_]]);
    return bytes;
  }
  Bytes scan() {
    if (below(8) == 0) scanned_ = 0;
    Bytes bytes{0x51};
    put(bytes, below(8) != 0 ? kIdentity[scanned_] : static_cast<std::uint32_t>(random()));
    const unsigned present = scanned_;
    const bool all = below(3) == 0;
    if (all) scanned_ = (scanned_ + 1) % 4;
    bytes[5] = static_cast<std::uint8_t>(present == 0 && below(6) == 0 ? 0x80 : all ? 0 : below(36));
    bytes[6] = static_cast<std::uint8_t>(below(16) != 0 ? present : below(6));
    bytes[7] = static_cast<std::uint8_t>(below(16) != 0 ? scanned_ : below(6));
    return bytes;
  }
  Bytes request() {
    static constexpr std::uint8_t kIds[] = {0, 1, 5, 127, 128, 254, 255, 255};
    static constexpr std::uint8_t kOthers[] = {0x13, 0x15, 0x17, 0x4C, 0x5A, 0x5B, 0x5C, 0x5D, 0x5E};
    if (below(2) == 0) return next_part();  // or hardly a sequence would come to its end
    switch (below(6)) {
      case 0:
        return any();
      case 1:
        return {0x04, static_cast<std::uint8_t>(below(3))};
      case 2:
        return {0x11, kIds[below(8)]};
      case 3:
      case 4:
        return scan();
      default:
        return {kOthers[below(9)], static_cast<std::uint8_t>(below(4) / 3), static_cast<std::uint8_t>(below(11))};
    }
  }
  void step() {
    const bool resets = below(64) == 0;
    const Bytes bytes = request();
    const auto length = static_cast<std::uint8_t>(below(32) != 0 ? 8 : below(8));
    const std::optional<Frame> expected = resets        ? model.resets()
                                          : length == 8 ? model.hears(bytes)
                                                        : std::nullopt;
    node->on_frame(resets ? Frame{.id = 0, .length = 2, .data = {130, 0}}
                          : Frame{.id = 0x7E5, .length = length, .data = bytes},
                   now);
    const std::vector<Frame> answers = bus.take();
    const std::string asked = fakes::candump({.id = 0x7E5, .length = length, .data = bytes});
    ASSERT_EQ(answers.size(), expected ? 1U : 0U) << asked;
    if (expected) {
      ASSERT_EQ(fakes::candump(answers.front()), fakes::candump(*expected)) << asked;
      ++seen[expected->id == 0x7E4 ? expected->data[0] : 0];
    }
    ASSERT_EQ(lss.state(), model.waits ? LssState::Waiting : LssState::Configuration) << asked;
    ASSERT_EQ(node->node_id(), model.active) << asked;
    ASSERT_EQ(lss.settings().node_id, model.pending) << asked;
    ASSERT_EQ(lss.settings().bit_rate, model.rate) << asked;
    ASSERT_EQ(node->next_deadline(), canopen::kNever);
  }

  std::mt19937_64 random;
  Model model;
  std::map<unsigned, int> seen;  ///< answers, 0: boot-up messages

 private:
  unsigned part_ = 0;
  unsigned scanned_ = 0;
};

TEST_F(LssModel, AnswersAsTheNodeDoesWhateverTheMasterSends) {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  const std::uint64_t seed = given != nullptr ? std::strtoull(given, nullptr, 0) : std::random_device{}();
  SCOPED_TRACE("AXISD_TEST_SEED=" + std::to_string(seed));
  std::cout << "AXISD_TEST_SEED=" << seed << '\n';
  random.seed(seed);
  start();

  for (int i = 0; i < 200'000; ++i) ASSERT_NO_FATAL_FAILURE(step()) << "request " << i;

  for (const unsigned command :
       {0x00U, 0x11U, 0x13U, 0x17U, 0x44U, 0x4FU, 0x50U, 0x5AU, 0x5BU, 0x5CU, 0x5DU, 0x5EU})
    EXPECT_GT(seen[command], 100) << std::hex << command;
}

}  // namespace
