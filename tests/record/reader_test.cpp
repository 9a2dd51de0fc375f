// What was recorded is read again, from whole files and from what is left of others.
#include "record/reader.hpp"

#include <random>

#include <gtest/gtest.h>

#include "checksum/crc32.hpp"
#include "record/segments.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/record/recorded.hpp"

namespace record {
namespace {

using namespace std::chrono_literals;

constexpr Event kWrite{.kind = EventKind::Parameter,
                       .origin = Origin::Sdo,
                       .server = 2,
                       .object = 2,
                       .axis = 1,
                       .number = 1120,
                       .index = 0,
                       .value = 0.5,
                       .before = 10.0};
constexpr Event kFault{
    .kind = EventKind::Fault, .object = 2, .axis = 1, .number = 7900, .code = 3, .text = "Motor blocked"};

/// A file with a record of every type.
class ARecording : public testing::Test {
 protected:
  ARecording() {
    Segments files{plan_in(folder.path("recordings"))};
    EXPECT_EQ(files.open(), 0);
    const std::array values{1500.25};
    for (const RecordBytes& record :
         {frame_record(kRequest, false, 1ms), frame_record(kSync, true, 2ms), event_record(kWrite, 3ms),
          event_record(kFault, 4ms), samples_record(values, 5ms), lost_record(7, 6ms)})
      EXPECT_EQ(files.write(record.bytes()), 0);
    EXPECT_EQ(files.close(EndReason::Stopped, 7ms), 0);
    content = content_of_file(files.where());
  }
  /// Where each record ends, behind the head.
  std::vector<std::size_t> ends() const {
    auto reader = Reader::open(std::as_bytes(std::span{content})).value();
    std::vector<std::size_t> ends{reader.position()};
    while (reader.next()) ends.push_back(reader.position());
    return ends;
  }

  fakes::TemporaryDirectory folder;
  std::string content;
};

TEST(AnEvent, OfAClientKeepsItsMethodAndItsParametersInShort) {
  const Event act{
      .kind = EventKind::Control, .origin = Origin::Control, .text = "load.set", .note = Note{"axis 1"}};
  const fakes::TemporaryDirectory folder;
  Segments files{plan_in(folder.path("recordings"))};
  ASSERT_EQ(files.open(), 0);
  ASSERT_EQ(files.write(event_record(act, 1ms).bytes()), 0);
  ASSERT_EQ(files.close(EndReason::Stopped, 2ms), 0);
  const std::string content = content_of_file(files.where());
  const Recorded read = read_all(content);
  ASSERT_EQ(read.records.size(), 2U);
  const auto& event = std::get<Event>(read.records[0].content);
  EXPECT_EQ(json_of(event, {}),
            (nlohmann::json{
                {"t", 0.0}, {"kind", "control"}, {"method", "load.set"}, {"text", "axis 1"}, {"by", "control"}}));
}

TEST(ANote, IsCutBetweenLetters) {
  EXPECT_EQ(Note{std::string(200, 'x')}.text(), std::string(Note::kLongest, 'x'));
  EXPECT_EQ(Note{std::string(Note::kLongest - 1, 'x') + "µ"}.text(), std::string(Note::kLongest - 1, 'x'));
  EXPECT_EQ(Note{"µ"}.text(), "µ");
  EXPECT_EQ(Note{}.text(), "");
}

TEST_F(ARecording, HoldsWhatWasWritten) {
  const Recorded read = read_all(content);

  ASSERT_EQ(read.records.size(), 7U);
  EXPECT_EQ(read.ending, Reader::Ending::Whole);
  const auto& request = std::get<FrameRecord>(read.records[0].content);
  EXPECT_EQ(request.frame, kRequest);
  EXPECT_FALSE(request.sent);
  EXPECT_EQ(read.records[0].at, 1ms);
  EXPECT_TRUE(std::get<FrameRecord>(read.records[1].content).sent);
  const auto& write = std::get<Event>(read.records[2].content);
  EXPECT_EQ(json_of(write, {}), json_of(kWrite, {}));
  EXPECT_EQ(write.before, 10.0);
  EXPECT_EQ(json_of(std::get<Event>(read.records[3].content), {}), json_of(kFault, {}));
  EXPECT_EQ(std::get<SamplesRecord>(read.records[4].content).values, std::vector{1500.25});
  EXPECT_EQ(std::get<LostRecord>(read.records[5].content).records, 7U);
  EXPECT_EQ(std::get<EndRecord>(read.records[6].content).reason, EndReason::Stopped);
}

TEST_F(ARecording, CutAtAnyByteIsReadToItsLastWholeRecord) {
  const std::vector<std::size_t> ends = this->ends();
  for (std::size_t length = ends.front(); length < content.size(); ++length) {
    const Recorded read = read_all(content.substr(0, length));
    const auto whole = static_cast<std::size_t>(std::ranges::upper_bound(ends, length) - ends.begin()) - 1;

    ASSERT_EQ(read.records.size(), whole) << length;
    ASSERT_EQ(read.position, ends[whole]) << length;
    ASSERT_EQ(read.ending, length == ends[whole] ? Reader::Ending::Open : Reader::Ending::Cut) << length;
  }
}

TEST_F(ARecording, CutWithinItsHeadIsNone) {
  for (std::size_t length = 0; length < ends().front(); ++length)
    EXPECT_FALSE(Reader::open(std::as_bytes(std::span{content}).first(length))) << length;
}

TEST_F(ARecording, IsReadToTheRecordInWhichABitIsWrong) {
  const std::vector<std::size_t> ends = this->ends();
  for (std::size_t at = 0; at < content.size(); ++at) {
    std::string damaged = content;
    damaged[at] = static_cast<char>(damaged[at] ^ 1 << at % 8);
    const auto whole = static_cast<std::size_t>(std::ranges::upper_bound(ends, at) - ends.begin());

    const bool in_padding = at == 10 || at == 11;  // of the head
    const Recorded read = read_all(damaged);
    if (whole == 0 && !in_padding) {
      EXPECT_TRUE(read.records.empty()) << at;
    } else if (!in_padding) {
      EXPECT_EQ(read.records.size(), whole - 1) << at;
      EXPECT_NE(read.ending, Reader::Ending::Whole) << at;
    }
  }
}

TEST_F(ARecording, OfAnotherVersionIsRefusedWithBothNumbers) {
  content[8] = 9;
  const auto reader = Reader::open(std::as_bytes(std::span{content}));
  ASSERT_FALSE(reader);
  EXPECT_EQ(reader.error(), "version 9 of the format, this program reads 1");
}

TEST_F(ARecording, WithRecordsOfUnknownTypesIsReadWithoutThem) {
  RecordBytes unknown{static_cast<RecordType>(77), 2ms};
  unknown.add_text("of a later program");
  std::string record{reinterpret_cast<const char*>(unknown.bytes().data()), unknown.bytes().size()};
  const std::uint32_t crc = checksum::crc32(unknown.bytes());
  for (unsigned i = 0; i < 4; ++i) record.push_back(static_cast<char>(crc >> 8 * i & 0xFFU));
  content.insert(ends()[1], record);

  const Recorded read = read_all(content);

  EXPECT_EQ(read.records.size(), 7U);
  EXPECT_EQ(read.skipped, 1U);
  EXPECT_EQ(read.ending, Reader::Ending::Whole);
}

TEST(Reader, TakesAnyBytes) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random{seed};
  const std::string head = [] {
    fakes::TemporaryDirectory folder;
    Segments files{plan_in(folder.path("recordings"))};
    EXPECT_EQ(files.open(), 0);
    EXPECT_EQ(files.flush(), 0);
    return content_of_file(files.where());
  }();
  for (int round = 0; round < 2000; ++round) {
    RecordBytes record{static_cast<RecordType>(random() % 7), Moment{static_cast<std::int64_t>(random())}};
    for (auto left = random() % 60; left > 0; --left) record.add_number(random() % 256, 1);
    std::string content{head};
    content.append(reinterpret_cast<const char*>(record.bytes().data()), record.bytes().size());
    const std::uint32_t crc = checksum::crc32(record.bytes());
    for (unsigned i = 0; i < 4; ++i) content.push_back(static_cast<char>(crc >> 8 * i & 0xFFU));

    const Recorded read = read_all(content);

    ASSERT_EQ(read.records.size() + read.skipped, 1U) << "its checksum is right";
  }
}

TEST(Crc32, HasTheCheckValueOfIsoHdlc) {
  constexpr std::string_view kDigits = "123456789";
  EXPECT_EQ(checksum::crc32(std::as_bytes(std::span{kDigits.data(), kDigits.size()})), 0xCBF43926U);
}

}  // namespace
}  // namespace record
