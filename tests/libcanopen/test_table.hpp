#pragma once

#include <span>

#include "libcanopen/od/entry_description.hpp"

/// The dictionary that the tests of the library serve: one entry of every kind, four RPDOs and four TPDOs.
///
///     1000h 1005h 1008h 100Ah 1014h 1017h 1018h 1200h    communication profile
///     1400h..1403h, 1600h..1603h, 1800h..1803h, 1A00h..1A03h
///     2000h..2009h  numbers with limits: I8 U8 I16 U16 I24 U32 I64 U64 REAL32 REAL64
///     2010h..201Fh  every numeric type without limits, in the order of their sizes, all rw
///     2020h wo, 2021h ro, 2022h const, 2023h rw text, 2024h empty rw text, 2025h rw with gaps (sub 0, 2, 5)
///     6040h 6060h 60FFh for RPDOs, 6041h 6061h 606Ch 6063h for TPDOs, A000h rw outside the reset ranges
///
/// RPDO 1 and 2 are event-driven (6040h; 6040h 6060h), RPDO 3 synchronous (6040h 60FFh). TPDO 1 is event-driven
/// (6041h), TPDO 2 goes with every SYNC (6041h 606Ch), TPDO 3 with a SYNC after a change (6063h). The fourth of
/// each direction is invalid and empty.
std::span<const canopen::EntryDescription> test_table();
