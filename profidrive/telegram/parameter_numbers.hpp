#pragma once

#include <cstdint>

/// The parameters of IF1 by their numbers.
namespace profidrive::parameter {

inline constexpr std::uint16_t kSelection = 922;
inline constexpr std::uint16_t kTolerance = 925;
inline constexpr std::uint16_t kProtocol = 2030;
inline constexpr std::uint16_t kWithoutControl = 2037;
inline constexpr std::uint16_t kInterfaceMode = 2038;
inline constexpr std::uint16_t kMonitoringTime = 2040;
inline constexpr std::uint16_t kFaultDelay = 2044;
inline constexpr std::uint16_t kSignOfLife = 2045;
inline constexpr std::uint16_t kFurtherTime = 2047;
inline constexpr std::uint16_t kCycle = 2048;
inline constexpr std::uint16_t kReceivedWord = 2050;
inline constexpr std::uint16_t kSentWord = 2051;
inline constexpr std::uint16_t kState = 2054;
inline constexpr std::uint16_t kReceivedDoubleWord = 2060;
inline constexpr std::uint16_t kSentDoubleWord = 2061;
inline constexpr std::uint16_t kWrongSignsOfLife = 2065;
inline constexpr std::uint16_t kHighestConnected = 2067;
inline constexpr std::uint16_t kOffsetReceived = 2075;
inline constexpr std::uint16_t kOffsetSent = 2076;
inline constexpr std::uint16_t kExtendedSelection = 2079;
inline constexpr std::uint16_t kBitsOfWord = 2080;  ///< p2080 to p2084
inline constexpr std::uint16_t kInversion = 2088;   ///< of the words that are made of bits
inline constexpr std::uint16_t kMadeOfBits = 2089;
inline constexpr std::uint16_t kReceivedBits = 2090;     ///< r2090 to r2093
inline constexpr std::uint16_t kWordOfConverter = 2094;  ///< the first connector-binector converter
inline constexpr std::uint16_t kSourceOfConverter = 2099;
inline constexpr std::uint16_t kConnectCanControlword = 8790;
inline constexpr std::uint16_t kAssignment = 8839;
inline constexpr std::uint16_t kCycleOfUnit = 8848;

}  // namespace profidrive::parameter
