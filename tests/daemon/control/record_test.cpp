// Recordings of a unit as an operator starts, stops and reads them.
#include <filesystem>
#include <fstream>
#include <thread>

#include "record/show.hpp"
#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class RecordedUnit : public ControlledUnit {
 protected:
  json status() { return result_of("record.status"); }
  /// Ends the recording; its last state.
  json stop() {
    result_of("record.stop");
    while (status().at("state") == "stopping") std::this_thread::yield();
    return status();
  }
  /// The records of the file that was written last, without times, and its head in front.
  static std::vector<json> records(const json& status) {
    std::vector<json> lines;
    const auto remark = record::show(status.at("file"), record::Form::Json,
                                     [&lines](std::string_view line) { lines.push_back(json::parse(line)); });
    EXPECT_EQ(remark.value_or(remark.error()), "");
    return lines;
  }
  /// Of @p records those whose member @p key is @p value.
  static std::vector<json> having(const std::vector<json>& records, const char* key, const json& value) {
    std::vector<json> found;
    for (const json& record : records)
      if (record.contains(key) && record.at(key) == value) found.push_back(record);
    return found;
  }
};

TEST_F(RecordedUnit, IsOffAtFirst) {
  EXPECT_EQ(status(), (json{{"state", "off"}}));
  EXPECT_EQ(result_of("record.stop"), (json{{"state", "off"}}));
}

TEST_F(RecordedUnit, HasFramesWritesStatesAndValuesOnOneClock) {
  EXPECT_EQ(result_of("record.start", {{"name", "run"}, {"signals", {"1/r0063"}}, {"every_s", 0.01}}).at("state"),
            "recording");
  answer("000#0105");
  answer("605#2B171000E8030000");
  result_of("fault.inject", {{"axis", 1}, {"number", 7900}});
  run(100ms);
  const json last = stop();

  EXPECT_EQ(last.at("state"), "stopped");
  EXPECT_EQ(last.at("lost"), 0);
  EXPECT_EQ(fs::path{last.at("file").get<std::string>()}.filename(), "run.axrec");
  const std::vector<json> all = records(last);
  const json& head = all.front().at("head");
  EXPECT_EQ(head.at("node_id"), 5);
  EXPECT_EQ(head.at("signals").at(0).at("name"), "1/r0063[0]");
  EXPECT_EQ(having(all, "kind", "nmt").size(), 1U);
  EXPECT_EQ(having(all, "kind", "object").at(0).at("by"), "sdo");
  EXPECT_EQ(having(all, "kind", "fault").at(0).at("name"), "F07900");
  EXPECT_EQ(having(all, "id", "605").at(0).at("direction"), "received");
  EXPECT_EQ(having(all, "id", "585").at(0).at("direction"), "sent");
  EXPECT_NEAR(static_cast<double>(having(all, "type", "samples").size()), 10.0, 2.0);
  EXPECT_EQ(all.back().at("reason"), "stopped");
  double before = 0.0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GE(all[i].at("t").get<double>(), before) << all[i];
    before = all[i].at("t");
  }
}

TEST_F(RecordedUnit, HasALogForOthersBesideIt) {
  result_of("record.start", {{"name", "run"}});
  answer("000#0105");
  fs::path log{stop().at("file").get<std::string>()};
  std::vector<std::string> lines;
  const auto shown =
      record::show(log, record::Form::Candump, [&lines](std::string_view line) { lines.emplace_back(line); });
  ASSERT_TRUE(shown) << shown.error();
  EXPECT_GT(fs::file_size(log.replace_extension(".log")), 0U);
  ASSERT_FALSE(lines.empty());
  EXPECT_NE(lines.front().find(" 000#0105"), std::string::npos) << lines.front();
}

TEST_F(RecordedUnit, SamplesEveryCycleIfNothingElseIsSaid) {
  result_of("record.start", {{"name", "run"}, {"signals", {"1/r0063"}}});
  for (const char* const controlword : {"06", "07", "0F"}) {
    answer(std::string{"605#2B406000"} + controlword + "000000");
    run(20ms);
  }
  const auto samples = having(records(stop()), "type", "samples");
  ASSERT_GT(samples.size(), 5U);
  for (std::size_t i = samples.size() - 3; i < samples.size(); ++i)
    EXPECT_NEAR(samples[i].at("t").get<double>() - samples[i - 1].at("t").get<double>(), 0.004, 1e-9);
}

TEST_F(RecordedUnit, KeepsWhatWentBeforeAFault) {
  EXPECT_EQ(result_of("record.start", {{"name", "run"}, {"on_fault", true}, {"before_s", 1}, {"after_s", 0.1}})
                .at("state"),
            "armed");
  answer("000#0105");
  run(500ms);
  result_of("fault.inject", {{"axis", 1}, {"number", 7900}});
  run(10ms);
  EXPECT_EQ(status().at("state"), "recording");
  answer("605#4000100000000000");
  run(200ms);
  EXPECT_EQ(status().at("state"), "armed");
  const json last = stop();

  EXPECT_EQ(last.at("faults"), 1);
  EXPECT_EQ(fs::path{last.at("file").get<std::string>()}.filename(), "run-1.axrec");
  const std::vector<json> all = records(last);
  EXPECT_EQ(having(all, "id", "000").size(), 1U) << "before the fault";
  EXPECT_EQ(having(all, "id", "605").size(), 1U) << "after it";
  EXPECT_EQ(all.back().at("reason"), "over");
}

TEST_F(RecordedUnit, RefusesWhatCannotBeRecorded) {
  const auto refused = [this](const json& params) { return error_of("record.start", params).code; };
  using enum control::ErrorCode;
  EXPECT_EQ(refused({{"name", "../run"}}), BadParameter);
  EXPECT_EQ(refused({{"name", 3}}), BadParameter);
  EXPECT_EQ(refused({{"signals", 3}}), BadParameter);
  EXPECT_EQ(refused({{"signals", {1, 2}}}), BadParameter);
  EXPECT_EQ(refused({{"signals", json::array_t(17, "1/r0063")}}), BadParameter);
  EXPECT_EQ(refused({{"signals", {"1/nothing"}}}), NotFound);
  EXPECT_NE(error_of("record.start", {{"max_MB", 0}}).message.find("1 to 1024"), std::string::npos);
  EXPECT_NE(error_of("record.start", {{"every_s", 0}}).message.find("0.001 to 3600"), std::string::npos);
  EXPECT_EQ(status().at("state"), "off");
}

TEST_F(RecordedUnit, IsRecordedOnceAtATime) {
  result_of("record.start", {{"name", "a"}});
  const control::Error error = error_of("record.start", {{"name", "b"}});
  EXPECT_EQ(error.code, control::ErrorCode::Busy);
  EXPECT_EQ(error.message, "a recording is recording: record.stop ends it");
  stop();
  EXPECT_EQ(result_of("record.start", {{"name", "b"}}).at("name"), "b");
}

TEST_F(RecordedUnit, HasANameOfDateAndTimeIfItIsGivenNone) {
  const std::string name = result_of("record.start").at("name");
  EXPECT_EQ(name.size(), std::string{"20261123-010203"}.size());
  EXPECT_EQ(name[8], '-');
}

TEST_F(RecordedUnit, GoesOnWhenItCannotBeRecorded) {
  result_of("record.start", {{"name", "run"}});
  while (status().at("files") == 0) std::this_thread::yield();
  const fs::path file{status().at("file").get<std::string>()};
  stop();
  fs::remove_all(file.parent_path());
  std::ofstream{file.parent_path()} << "in the way";
  result_of("record.start", {{"name", "run"}});
  while (status().at("state") != "failed") std::this_thread::yield();
  run(10ms);

  EXPECT_NE(status().at("error").get<std::string>().find("Not a directory"), std::string::npos) << status();
  EXPECT_FALSE(unit().events().is_watched()) << "nobody listens any more";
  EXPECT_EQ(answer("605#4000100000000000").size(), 1U);
}

TEST_F(RecordedUnit, BeginsWithTheUnitIfTheConfigurationSaysSo) {
  Configuration configuration = unit_of(1);
  configuration.record = RecordSettings{.name = "always", .signals = {"1/r0063"}};
  switch_on(configuration);
  const std::vector<json> all = records(stop());
  EXPECT_EQ(having(all, "kind", "power").size(), 1U);
  EXPECT_EQ(having(all, "kind", "boot-up").size(), 1U);
}

TEST_F(RecordedUnit, IsNotSwitchedOnWithASignalThatItDoesNotHave) {
  Configuration configuration = unit_of(1);
  configuration.record = RecordSettings{.signals = {"9/r0063"}};
  EXPECT_THROW(switch_on(configuration), ConfigurationError);
}

TEST_F(RecordedUnit, HasAllOnTheDiskAtPowerOff) {
  result_of("record.start", {{"name", "run"}});
  while (status().at("files") == 0) std::this_thread::yield();
  const json last = status();
  answer("000#0105");
  switch_on(unit_of(1));
  const std::vector<json> all = records(last);
  EXPECT_EQ(all.at(all.size() - 2),
            (json{{"t", all.at(all.size() - 2).at("t")}, {"type", "event"}, {"kind", "power"}, {"on", false}}));
}

}  // namespace
}  // namespace axisd
