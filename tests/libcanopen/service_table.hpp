#pragma once

#include <span>

#include "libcanopen/od/entry_description.hpp"

/// The dictionary of the tests of error control, EMCY, TIME and storage: all their objects, no PDO that is valid.
///
///     1001h            error register, mapped into TPDO 1 (invalid, event-driven)
///     1003h            error history of four entries
///     100Ch, 100Dh     node guarding, off
///     1010h, 1011h     sub 1 and 2; they read 3 and 1
///     1012h, 1014h, 1015h, 1017h
///     1016h            three entries, not used
///     1029h            sub 1 and 2, both 0
std::span<const canopen::EntryDescription> service_table();
