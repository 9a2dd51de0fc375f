#pragma once

#include <span>

#include "libcanopen/od/entry_description.hpp"

namespace fuzz {

/// A dictionary with everything that the library serves: three SDO servers (1201h switched off, 1202h on), four
/// PDOs of each kind with all their parameters, every object of the communication profile, every data type.
///
///     2000h..2009h  numbers with limits        2010h..2026h  every numeric type, no limits
///     2030h wo, 2031h ro, 2032h const, 2033h with gaps, 2034h judged by its owner, 2035h text by its owner
///     2040h..2043h  texts                      2044h DOMAIN in the image, 2045h..2048h DOMAINs with an owner
///     2050h:1..16   BOOLEANs for bit mappings  6040h.. process data, A000h outside the reset ranges
std::span<const canopen::EntryDescription> table();

/// The first of the DOMAINs with an owner, and how many follow it: rw, rw of unknown size, ro, wo.
inline constexpr std::uint16_t kFirstDomain = 0x2045;
inline constexpr std::size_t kDomains = 4;
/// The number and the text that an owner judges.
inline constexpr std::uint16_t kJudgedNumber = 0x2034;
inline constexpr std::uint16_t kJudgedText = 0x2035;
/// SDO servers, RPDOs and TPDOs.
inline constexpr std::size_t kServers = 3;
inline constexpr std::size_t kPdos = 4;

}  // namespace fuzz
