#include "daemon/instance/memory/unit_memory.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <optional>

#include <gtest/gtest.h>
#include <poll.h>

#include "service/clock.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/fakes/flush_hook.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/fakes/vector_bus.hpp"

namespace axisd {
namespace {

using Lines = std::vector<std::string>;

constexpr const char* kSave = "605#2310100173617665";
constexpr const char* kSaved = "585#6010100100000000";
constexpr const char* kSaveRefused = "585#8010100122000008";
constexpr const char* kLoad = "605#231110016C6F6164";
constexpr const char* kLoaded = "585#6011100100000000";

/// A unit of some axes with its memory in @p folder, from power-on on.
class Unit : private device::Listener {
 public:
  Unit(const std::string& folder, std::size_t axes)
      : device_{{.node_id = 5, .axes = std::vector<device::AxisSetup>(axes)}, bus_, *this},
        memory_{folder, device_, log_} {
    memory_.load();
    device_.start(read_clock());
    memory_.raise_faults();
    for (const canopen::Frame& frame : bus_.take()) boot.push_back(fakes::candump(frame));
  }

  /// What the unit answers to @p frame, however long that takes.
  std::string answer(std::string_view frame) {
    device_.on_frame(fakes::frame_of(frame), read_clock());
    while (bus_.sent.empty()) await_write();
    return fakes::candump(bus_.take().front());
  }
  void power_off() { memory_.power_off(); }

  Lines boot;
  fakes::VectorBus bus_;
  Log log_{LogLevel::Error};
  device::Device device_;
  UnitMemory memory_;

 private:
  void await_write() {
    pollfd ended{memory_.descriptor(), POLLIN, 0};
    EXPECT_EQ(::poll(&ended, 1, -1), 1);
    memory_.take_ended();
  }
  void on_subscriptions_changed() noexcept override {}
  void on_foreign_frame(std::uint32_t) noexcept override {}
  device::Keeping on_store(std::span<const std::byte> image) noexcept override { return memory_.store(image); }
  void on_restore() noexcept override { memory_.on_restore(); }
};

struct UnitMemoryTest : testing::Test {
  /// Switches a unit on that was off.
  Unit& start(std::size_t axes = 1) { return unit.emplace(folder.path(), axes); }
  /// A unit of one axis that has saved its parameters, switched off.
  void save_once() {
    ASSERT_EQ(start().answer(kSave), kSaved);
    unit->power_off();
    unit.reset();
    before = content();
  }
  std::string content() const {
    std::ifstream file{folder.path("parameters.bin")};
    return {std::istreambuf_iterator<char>{file}, {}};
  }
  Lines names() const {
    Lines found;
    for (const auto& entry : std::filesystem::directory_iterator{folder.path()})
      found.push_back(entry.path().filename().string());
    std::ranges::sort(found);
    return found;
  }

  fakes::TemporaryDirectory folder;
  std::optional<Unit> unit;
  std::string before;
};

TEST_F(UnitMemoryTest, IsSilentWhereAllIsWell) {
  ASSERT_NO_FATAL_FAILURE(save_once());

  EXPECT_EQ(start().boot, Lines{"705#00"});
  EXPECT_EQ(unit->memory_.parameters_text(), "in use");
  EXPECT_EQ(unit->memory_.retained_text(), "in use");
}

TEST_F(UnitMemoryTest, KeepsAFileOfAnotherUnitAndSaysSoOnTheBus) {
  ASSERT_NO_FATAL_FAILURE(save_once());

  start(2);  // by mistake

  EXPECT_EQ(unit->boot, (Lines{"705#00", "085#001081EA03010000"})) << "F01002 of the control unit";
  EXPECT_EQ(unit->answer("605#4001100000000000"), "585#4F01100081000000");
  EXPECT_EQ(unit->memory_.parameters_text(), "not in use: of a unit with other axes or motors");
  EXPECT_EQ(unit->answer(kSave), kSaveRefused);
  unit->power_off();
  start(1);
  EXPECT_EQ(unit->boot, Lines{"705#00"});
  EXPECT_EQ(content(), before);
  EXPECT_EQ(names(), (Lines{"parameters.bin", "retained.bin"}));
}

TEST_F(UnitMemoryTest, ReplacesSuchAFileAfterARestoreAndKeepsItUnderAnotherName) {
  ASSERT_NO_FATAL_FAILURE(save_once());
  start(2);

  ASSERT_EQ(unit->answer(kLoad), kLoaded);
  EXPECT_EQ(content(), before) << "a restore stores nothing";
  unit->bus_.take();
  EXPECT_EQ(unit->answer(kSave), kSaved);
  unit->power_off();

  EXPECT_EQ(names(), (Lines{"parameters.bin", "parameters.bin.old", "retained.bin", "retained.bin.old"}));
  EXPECT_EQ(start(2).boot, Lines{"705#00"});
}

TEST_F(UnitMemoryTest, KeepsAFileOfAnotherVersion) {
  ASSERT_NO_FATAL_FAILURE(save_once());
  {
    std::fstream file{folder.path("parameters.bin"), std::ios::in | std::ios::out};
    file.seekp(8).put('\x7F');
  }
  const std::string newer = content();

  EXPECT_EQ(start().memory_.parameters_text(), "not in use: another format version");
  EXPECT_EQ(unit->answer(kSave), kSaveRefused);
  EXPECT_EQ(content(), newer);
}

TEST_F(UnitMemoryTest, LeavesWhatCannotBeReadWhereItIs) {
  std::filesystem::create_symlink("parameters.bin", folder.path("parameters.bin"));

  EXPECT_EQ(start().memory_.parameters_text(), "not in use: cannot be read: Too many levels of symbolic links");
  EXPECT_EQ(unit->answer(kSave), kSaveRefused);
  EXPECT_EQ(names(), Lines{"parameters.bin"});
}

TEST_F(UnitMemoryTest, SetsAsideWhatIsDamaged) {
  ASSERT_NO_FATAL_FAILURE(save_once());
  std::filesystem::resize_file(folder.path("parameters.bin"), before.size() - 1);

  EXPECT_EQ(start().boot, (Lines{"705#00", "085#001081EA03010000"}));
  EXPECT_EQ(unit->memory_.parameters_text(), "set aside: wrong checksum");
  EXPECT_EQ(unit->answer(kSave), kSaved);
  EXPECT_EQ(names(), (Lines{"parameters.bin", "parameters.bin.bad", "retained.bin"}));
}

/// Lets no flush of the disk end before so many have begun as are to be under way together.
struct FlushTogether {
  explicit FlushTogether(int wanted) : missing{wanted} {}
  int flush() {
    std::unique_lock lock{mutex};
    if (--missing <= 0) all_there.notify_all();
    return all_there.wait_for(lock, std::chrono::seconds{20}, [this] { return missing <= 0; }) ? 0 : EIO;
  }

  int missing;
  std::mutex mutex;
  std::condition_variable all_there;
};

TEST(UnitMemories, AreFlushedTogetherWhenManyUnitsAreSwitchedOff) {
  const fakes::TemporaryDirectory one, other;
  Unit first{one.path(), 1}, second{other.path(), 1};
  FlushTogether disk{2};
  const fakes::FlushHook hook{[&disk](int) { return disk.flush(); }};

  first.memory_.begin_power_off();
  second.memory_.begin_power_off();
  first.memory_.power_off();
  second.memory_.power_off();

  EXPECT_EQ(first.memory_.retained_text(), "in use");
  EXPECT_EQ(second.memory_.retained_text(), "in use");
}

}  // namespace
}  // namespace axisd
