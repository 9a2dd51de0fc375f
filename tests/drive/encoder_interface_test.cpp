// The encoder interface of PROFIdrive: Gn_STW by p0480 to Gn_ZSW (r0481) and Gn_XIST2 (r0483).
#include <cstdint>

#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

constexpr std::size_t kWord = 8;  // of the received ones that p0480[0] is connected to
constexpr unsigned kFault = 0x8000;

/// A unit whose axes take Gn_STW from a word of the bus.
struct Encoders : WiredUnit {
  Encoders() {
    for (const std::uint8_t axis : {kX, kY}) wire(axis, 480, {8850, kOwnObject, kWord});
    cycles(2);
  }
  /// Gn_ZSW of encoder 1 after @p control.
  unsigned ask(unsigned control, std::uint8_t axis = kX) {
    receives(axis, kWord, static_cast<std::uint16_t>(control));
    cycles();
    return status(axis);
  }
  unsigned status(std::uint8_t axis = kX) { return static_cast<unsigned>(read(axis, 481)); }
  std::uint32_t second(std::uint8_t axis = kX) { return static_cast<std::uint32_t>(read(axis, 483)); }
  std::uint32_t first(std::uint8_t axis = kX) { return static_cast<std::uint32_t>(read(axis, 482)); }
};

TEST(EncoderInterface, MirrorsAbsoluteValueAndParking) {
  Encoders encoders;
  EXPECT_EQ(encoders.ask(0x0000), 0u);
  EXPECT_EQ(encoders.ask(0x2000), 0x2000u);
  EXPECT_EQ(encoders.ask(0x4000), 0x4000u);
  EXPECT_EQ(encoders.ask(0x6000), 0x4000u) << "a parked encoder transfers nothing";
  EXPECT_EQ(encoders.ask(0x0000), 0u);
}

TEST(EncoderInterface, AnswersSearchesAndMeasurementsAsActiveUntilTheyAreCancelled) {
  Encoders encoders;
  EXPECT_EQ(encoders.ask(0x0011), 0x0001u) << "search for mark 1";
  EXPECT_EQ(encoders.ask(0x0000), 0x0001u);
  EXPECT_EQ(encoders.ask(0x0092), 0x0003u) << "and a measurement of edge 2";
  EXPECT_EQ(encoders.ask(0x0031), 0x0002u);
  encoders.cycles(100);
  EXPECT_EQ(encoders.status(), 0x0002u) << "nothing is ever found";
  EXPECT_EQ(encoders.ask(0x4000), 0x4000u);
  EXPECT_EQ(encoders.ask(0x0000), 0u) << "parking has ended them";
}

TEST(EncoderInterface, ReadsThePositionWhenItIsAskedFor) {
  Encoders encoders;
  ASSERT_EQ(encoders.write(kX, 1120, 0.0), std::nullopt);
  encoders.receives_double_word(kX, 1, 0x10000000);
  encoders.switch_on(kX);
  encoders.cycles(50);

  EXPECT_EQ(encoders.ask(0x0021), 0x0010u);
  const std::uint32_t read = encoders.second();
  EXPECT_EQ(read, encoders.first());
  encoders.cycles(5);
  EXPECT_EQ(encoders.second(), read) << "it stays";
  EXPECT_NE(encoders.first(), read);
  EXPECT_EQ(encoders.ask(0x0001), 0u);
  EXPECT_EQ(encoders.second(), 0u);
}

TEST(EncoderInterface, ShowsAFaultUntilItIsAcknowledgedWhenItsCauseIsGone) {
  Encoders encoders;
  ASSERT_TRUE(encoders.axis(kX).raise(31110, 0));
  EXPECT_EQ(encoders.ask(0x0001), kFault);
  EXPECT_EQ(encoders.second(), 1u) << "encoder fault";
  EXPECT_EQ(encoders.ask(0x4000), 0x4000u) << "not of a parked encoder";
  EXPECT_EQ(encoders.ask(0x0000), kFault);
  EXPECT_EQ(encoders.ask(0x8000), 0x0800u);
  EXPECT_EQ(encoders.ask(0x0000), 0u);
  EXPECT_EQ(encoders.read(kX, 2131), 31110.0) << "the axis has its fault still";

  encoders.axis(kX).acknowledge();
  encoders.cycles();
  ASSERT_TRUE(encoders.axis(kX).raise(31110, 0));
  EXPECT_EQ(encoders.ask(0x0000), kFault) << "a new one";
}

TEST(EncoderInterface, IsOfTheMotorEncoderOnly) {
  Encoders encoders;
  for (std::size_t encoder = 1; encoder <= 2; ++encoder) {
    encoders.wire(kX, 480, {8850, kOwnObject, kWord}, encoder);
    encoders.ask(0x2011);
    EXPECT_EQ(decode(encoders.unit.read(kX, 481, encoder).value()), 0.0);
    EXPECT_EQ(decode(encoders.unit.read(kX, 483, encoder).value()), 0.0);
  }
}

TEST(EncoderInterface, GivesTheAbsolutePositionUnlessItIsAskedForSomethingElse) {
  AxisConfiguration absolute;
  absolute.machine.encoder.type = motor::EncoderType::Absolute;
  Axis axis{absolute};
  const double position = axis.drive_train().encoder().absolute_position();
  EncoderInterface& interface = axis.block<EncoderInterface>();
  EXPECT_EQ(axis.read(483).value(), position) << "as without the interface";
  for (const auto& [control, second] :
       {std::pair{8192.0, position}, std::pair{1.0, 0.0}, std::pair{16384.0, 0.0}}) {
    interface.inputs.control_words[0] = control;
    interface.run({});
    EXPECT_EQ(axis.read(483).value(), second) << control;
  }
}

}  // namespace
}  // namespace drive
