#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "device/process_data/positioner_wiring.hpp"

/// What the ready connections of the positioner are, as tables. Word 1 that comes is always 6040h, whose bits 4 to
/// 13 are those of STW1 of a positioning axis; a word of bits is r8890 and following by its place.
namespace device::positioner_wiring {

/// The source of an input: bit or index @p position of parameter @p number of the same axis; number 0: the
/// constant
/// @p position.
struct Source {
  std::uint16_t number = 0;
  std::uint16_t position = 0;
};
struct Connection {
  std::uint16_t input = 0;
  std::uint8_t index = 0;
  Source source{};
};
/// The bits of a word that is sent, from bit 0; those without source are 0.
using StatusWord = std::array<Source, 16>;
/// The entries of a PDO, of the first axis; none: the PDO is not used.
using Mapping = std::array<std::uint32_t, 4>;

/// One wiring.
struct Table {
  std::array<Mapping, 4> received;
  std::array<Mapping, 4> sent;
  std::span<const std::span<const Connection>> connections;
  std::span<const StatusWord* const> words;  ///< r8889[0] and following
};

// Words that come, as r8890 and following.
inline constexpr std::uint16_t kFirst = 8890, kSecond = 8891, kThird = 8892;
// Words and double words that come, and the places of those that are sent.
inline constexpr std::uint16_t kWord = 8850, kDoubleWord = 8860, kSentWord = 8851, kSentDoubleWord = 8861;
inline constexpr std::uint16_t kMadeOfBits = 8889;       // r8889
inline constexpr std::uint16_t kBitsOfFirstWord = 8894;  // r8894, of p8899[0]
inline constexpr std::uint16_t kStatusword = 8784;

// clang-format off
/// Standard objects: the controlword as word 1, target velocity and torque without a place, bits of the statusword.
inline constexpr std::array kStandard{
    Connection{840, 0, {kFirst, 0}},         // ON
    Connection{844, 0, {kFirst, 1}},         // no OFF2
    Connection{848, 0, {kFirst, 2}},         // no OFF3
    Connection{852, 0, {kFirst, 3}},         // enable operation
    Connection{2103, 0, {kFirst, 7}},        // acknowledge
    Connection{1503, 0, {8797, 0}},          // torque setpoint
    Connection{8785, 0, {2684, 10}},         // bit 8: target position reached
    Connection{8786, 0, {2684, 11}},         // bit 14: reference point set
    Connection{8787, 0, {2684, 12}},         // bit 15: acknowledge block or MDI
    Connection{kSentDoubleWord, 1, {}},
};

/// STW1 beyond the state machine.
inline constexpr std::array kStw1{
    Connection{2641, 0, {kFirst, 4}},        // do not reject
    Connection{2640, 0, {kFirst, 5}},        // no intermediate stop
    Connection{2631, 0, {kFirst, 6}},        // activate block
    Connection{2589, 0, {kFirst, 8}},        // jog 1
    Connection{2590, 0, {kFirst, 9}},        // jog 2
    Connection{2595, 0, {kFirst, 11}},       // referencing
    Connection{2633, 0, {kFirst, 13}},       // external block change
};
inline constexpr std::array kMdiAcceptance{Connection{2650, 0, {kFirst, 6}}};
inline constexpr std::array kControlByMaster{Connection{854, 0, {kFirst, 10}}};

/// Bits 0 to 5 of word 2.
inline constexpr std::array kBlockNumber{
    Connection{2625, 0, {kSecond, 0}}, Connection{2626, 0, {kSecond, 1}}, Connection{2627, 0, {kSecond, 2}},
    Connection{2628, 0, {kSecond, 3}}, Connection{2629, 0, {kSecond, 4}}, Connection{2630, 0, {kSecond, 5}},
};
inline constexpr std::array kMdiSelection{Connection{2647, 0, {kSecond, 15}}};
/// The rest of POS_STW1.
inline constexpr std::array kMdiBits{
    Connection{2648, 0, {kSecond, 8}},       // absolute
    Connection{2651, 0, {kSecond, 9}},       // positive direction
    Connection{2652, 0, {kSecond, 10}},      // negative direction
    Connection{2649, 0, {kSecond, 12}},      // continuous transfer
    Connection{2653, 0, {kSecond, 14}},      // setting-up
};
/// MDI_MOD, the word of p8899[0].
inline constexpr std::array kMdiMode{
    Connection{8899, 0, {kWord, 11}},
    Connection{2648, 0, {kBitsOfFirstWord, 0}},
    Connection{2651, 0, {kBitsOfFirstWord, 1}},
    Connection{2652, 0, {kBitsOfFirstWord, 2}},
};

/// What POS_STW and POS_STW2 have in common, word 3.
inline constexpr std::array kPosStw{
    Connection{2655, 0, {kThird, 0}},        // tracking
    Connection{2596, 0, {kThird, 1}},        // set reference point
    Connection{2612, 0, {kThird, 2}},        // reference cam
    Connection{2591, 0, {kThird, 5}},        // jog incremental
};
inline constexpr std::array kPosStw2{
    Connection{2597, 0, {kThird, 8}},        // flying referencing
    Connection{2604, 0, {kThird, 9}},        // search in negative direction
    Connection{2510, 0, {kThird, 10}},       // probe 2
    Connection{2511, 0, {kThird, 11}},       // falling edge
    Connection{2582, 0, {kThird, 14}},       // software limits
    Connection{2568, 0, {kThird, 15}},       // STOP cams
};

// Setpoints, behind the words of bits.
inline constexpr std::array kOverrideInWord4{Connection{2646, 0, {kWord, 3}}};
inline constexpr std::array kMdiSetpoints{
    Connection{2642, 0, {kDoubleWord, 4}}, Connection{2643, 0, {kDoubleWord, 6}},
    Connection{2644, 0, {kWord, 8}},       Connection{2645, 0, {kWord, 9}},
};
inline constexpr std::array kTelegramSetpoints{
    Connection{2646, 0, {kWord, 4}},       Connection{2642, 0, {kDoubleWord, 5}},
    Connection{2643, 0, {kDoubleWord, 7}}, Connection{2644, 0, {kWord, 9}},
    Connection{2645, 0, {kWord, 10}},
};

/// The modes of r2669 as bits of r8894.
inline constexpr std::array kModeBits{Connection{8899, 0, {2669, 0}}};

// What is sent.
inline constexpr std::array kSentOfMdi{
    Connection{kSentWord, 0, {kStatusword, 0}},
    Connection{kSentWord, 1, {kMadeOfBits, 0}},
    Connection{kSentWord, 2, {kMadeOfBits, 1}},
    Connection{kSentWord, 3, {2681, 0}},        // override
    Connection{kSentDoubleWord, 4, {2521, 0}},  // position
    Connection{kSentDoubleWord, 6, {63, 0}},    // speed
};
inline constexpr std::array kSentOfTelegram{
    Connection{kSentWord, 0, {kMadeOfBits, 0}},
    Connection{kSentWord, 1, {kMadeOfBits, 1}},
    Connection{kSentWord, 2, {kMadeOfBits, 2}},
    Connection{kSentWord, 3, {kMadeOfBits, 3}},
    Connection{kSentWord, 4, {kMadeOfBits, 4}},
    Connection{kSentDoubleWord, 4, {}},
    Connection{kSentDoubleWord, 5, {2521, 0}},  // XIST_A
};
inline constexpr std::array kSentOf110{Connection{kSentWord, 7, {kStatusword, 0}}};
inline constexpr std::array kSentOf111{
    Connection{kSentDoubleWord, 7, {63, 0}},    // NIST_B
    Connection{kSentWord, 9, {2131, 0}},        // FAULT_CODE
    Connection{kSentWord, 10, {2132, 0}},       // WARN_CODE
    Connection{kSentWord, 11, {kStatusword, 0}},
};

inline constexpr StatusWord kZsw1{{
    {899, 0}, {899, 1}, {899, 2}, {2139, 3}, {899, 4}, {899, 5}, {899, 6}, {2139, 7},
    {2684, 8}, {899, 9}, {2684, 10}, {2684, 11}, {2684, 12}, {2683, 2}, {2684, 4}, {2684, 5},
}};
/// Data sets and the block of the closed-loop control; there is no sign of life on CAN.
inline constexpr StatusWord kZsw2{{
    {51, 0}, {51, 1}, {51, 2}, {51, 3}, {51, 4}, {}, {}, {}, {1406, 8}, {}, {899, 11}, {}, {}, {}, {}, {},
}};
/// What of MELDW there are binectors of.
inline constexpr StatusWord kMeldw{{
    {2199, 5}, {2199, 11}, {2199, 0}, {2197, 1}, {}, {}, {}, {}, {2199, 4}, {}, {}, {899, 8}, {899, 7}, {899, 11}, {}, {},
}};
inline constexpr StatusWord kPosZsw1{{
    {2670, 0}, {2670, 1}, {2670, 2}, {2670, 3}, {2670, 4}, {2670, 5}, {}, {},
    {2684, 13}, {2684, 14}, {kBitsOfFirstWord, 0}, {kBitsOfFirstWord, 1}, {2684, 1}, {kBitsOfFirstWord, 2},
    {kBitsOfFirstWord, 4}, {2670, 15},
}};
inline constexpr StatusWord kPosZsw2{{
    {2683, 0}, {2683, 1}, {2683, 2}, {2684, 3}, {2683, 4}, {2683, 5}, {2683, 6}, {2683, 7},
    {2683, 8}, {2683, 9}, {2683, 10}, {2683, 11}, {2683, 12}, {2683, 13}, {2683, 14}, {2684, 15},
}};
inline constexpr StatusWord kPosZsw{{
    {2683, 0}, {2683, 1}, {2683, 2}, {2683, 3}, {2683, 4}, {2683, 5}, {2683, 6}, {2683, 7}, {}, {}, {}, {}, {}, {}, {}, {},
}};
inline constexpr StatusWord kAktsatz{{
    {2670, 0}, {2670, 1}, {2670, 2}, {2670, 3}, {2670, 4}, {2670, 5}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {2670, 15},
}};

using Connections = std::span<const Connection>;
inline constexpr std::array<Connections, 12> kConnectionsOfMdi{
    kStandard, kStw1, kMdiAcceptance, kBlockNumber, kMdiSelection, kMdiBits, kPosStw, kPosStw2, kOverrideInWord4,
    kMdiSetpoints, kModeBits, kSentOfMdi};
inline constexpr std::array<Connections, 8> kConnectionsOfBlocks{
    kStandard, kStw1, kBlockNumber, kPosStw, kPosStw2, kOverrideInWord4, kModeBits, kSentOfMdi};
inline constexpr std::array<Connections, 11> kConnectionsOf110{
    kStandard, kStw1, kMdiAcceptance, kControlByMaster, kBlockNumber, kMdiSelection, kMdiMode, kPosStw,
    kTelegramSetpoints, kSentOfTelegram, kSentOf110};
inline constexpr std::array<Connections, 13> kConnectionsOf111{
    kStandard, kStw1, kMdiAcceptance, kControlByMaster, kBlockNumber, kMdiSelection, kMdiBits, kPosStw, kPosStw2,
    kTelegramSetpoints, kModeBits, kSentOfTelegram, kSentOf111};

inline constexpr std::array<const StatusWord*, 2> kWordsOfMdi{&kPosZsw1, &kPosZsw2};
inline constexpr std::array<const StatusWord*, 5> kWordsOf110{&kZsw1, &kAktsatz, &kPosZsw, &kZsw2, &kMeldw};
inline constexpr std::array<const StatusWord*, 5> kWordsOf111{&kZsw1, &kPosZsw1, &kPosZsw2, &kZsw2, &kMeldw};

inline constexpr Mapping kWordsOfControl{0x60400010, 0x58000010, 0x58010010, 0x58020010};
inline constexpr std::array<Mapping, 4> kReceivedByTelegram{{
    kWordsOfControl,
    {0x58030010, 0x58200020},              // OVERRIDE, MDI_TARPOS
    {0x58210020, 0x58040010, 0x58050010},  // MDI_VELOCITY, MDI_ACC, MDI_DEC
    {0x58060010},                          // MDI_MOD, free
}};
inline constexpr std::array<Mapping, 4> kSentByMdi{{
    {0x60410010, 0x58100010, 0x58110010, 0x58120010},
    {0x58300020, 0x606C0020},
}};
inline constexpr Mapping kWordsOfStatus{0x58100010, 0x58110010, 0x58120010, 0x58130010};

/// In the order of PositionerWiring.
inline constexpr std::array kTables{
    Table{{{kWordsOfControl, {0x58200020, 0x58210020}, {0x58030010, 0x58040010}}}, kSentByMdi, kConnectionsOfMdi, kWordsOfMdi},
    Table{{{kWordsOfControl}}, kSentByMdi, kConnectionsOfBlocks, kWordsOfMdi},
    Table{kReceivedByTelegram, {{kWordsOfStatus, {0x58140010, 0x58300020, 0x60410010}}}, kConnectionsOf110, kWordsOf110},
    Table{kReceivedByTelegram,
          {{kWordsOfStatus, {0x58140010, 0x58300020}, {0x58310020, 0x58150010, 0x58160010}, {0x60410010}}},
          kConnectionsOf111, kWordsOf111},
};
static_assert(kTables.size() == drive::kPositionerWirings.size());
// clang-format on

}  // namespace device::positioner_wiring
