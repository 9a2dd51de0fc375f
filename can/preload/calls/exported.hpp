#pragma once

/// Stands before a function that takes the place of the C library's in the program. Nothing else of the library
/// can be seen from outside.
#define PRELOAD_EXPORT extern "C" __attribute__((visibility("default")))
