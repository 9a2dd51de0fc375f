#pragma once

#include <stdint.h>

/* The counts that allocation_counter.c keeps in the file named by $AXISD_ALLOCATION_COUNTS, one for each function.
 */

enum allocation_form {
  ALLOCATION_MALLOC,
  ALLOCATION_CALLOC,
  ALLOCATION_REALLOC,
  ALLOCATION_REALLOCARRAY,
  ALLOCATION_ALIGNED_ALLOC,
  ALLOCATION_POSIX_MEMALIGN,
  ALLOCATION_MEMALIGN,
  ALLOCATION_FORMS
};

/* Names of the functions, in the order of the enumeration. */
#define ALLOCATION_NAMES \
  { "malloc", "calloc", "realloc", "reallocarray", "aligned_alloc", "posix_memalign", "memalign" }

/* Size of the file: one uint64_t for each function. */
#define ALLOCATION_FILE_SIZE (ALLOCATION_FORMS * sizeof(uint64_t))
