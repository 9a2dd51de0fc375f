#pragma once

#include <span>

#include "libcanopen/od/entry_description.hpp"

/// The dictionary for the tests of SDO servers and DOMAINs.
///
///     1000h 1017h, 1200h, 1201h..1203h rw without identifiers, 127Fh rw under 680h and 681h
///     1400h, 1600h  an RPDO under 205h
///     2000h UNSIGNED32 rw
///     2100h 2101h 2102h DOMAIN rw, wo, ro: for owners    2103h DOMAIN rw of 20 bytes in the dictionary
std::span<const canopen::EntryDescription> sdo_table();

/// 1000h, 2000h UNSIGNED32 rw, 2100h DOMAIN rw, 2200h..227Fh VISIBLE_STRING rw of 30 bytes, and 128 servers:
/// number n (1201h: 1) listens to 20000000h + n and answers under 20001000h + n, both of 29 bits.
std::span<const canopen::EntryDescription> many_servers_table();
