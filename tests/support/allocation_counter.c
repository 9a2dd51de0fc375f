/* A library to preload into a program: counts every call of an allocating function in a file that another process
   reads while the program runs. operator new ends in malloc or aligned_alloc and is counted there. */
#define _GNU_SOURCE
#include "tests/support/allocation_counter.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

/* What glibc's own functions are called beneath the public names. */
extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t count, size_t size);
extern void* __libc_realloc(void* old, size_t size);
extern void* __libc_memalign(size_t alignment, size_t size);

static uint64_t unread[ALLOCATION_FORMS]; /* until the file is mapped */
static uint64_t* counts = unread;

static void count(enum allocation_form form) {
  __atomic_add_fetch(&counts[form], 1, __ATOMIC_RELAXED);
}

__attribute__((constructor)) static void map_counts(void) {
  const char* const name = getenv("AXISD_ALLOCATION_COUNTS");
  const int file = name != NULL ? open(name, O_RDWR | O_CLOEXEC) : -1;
  if (file < 0) return;
  void* const mapped = mmap(NULL, ALLOCATION_FILE_SIZE, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  if (mapped != MAP_FAILED) counts = mapped;
}

void* malloc(size_t size) {
  count(ALLOCATION_MALLOC);
  return __libc_malloc(size);
}

void* calloc(size_t number, size_t size) {
  count(ALLOCATION_CALLOC);
  return __libc_calloc(number, size);
}

void* realloc(void* old, size_t size) {
  count(ALLOCATION_REALLOC);
  return __libc_realloc(old, size);
}

void* reallocarray(void* old, size_t number, size_t size) {
  size_t bytes = 0;
  count(ALLOCATION_REALLOCARRAY);
  if (__builtin_mul_overflow(number, size, &bytes)) {
    errno = ENOMEM;
    return NULL;
  }
  return __libc_realloc(old, bytes);
}

void* aligned_alloc(size_t alignment, size_t size) {
  count(ALLOCATION_ALIGNED_ALLOC);
  return __libc_memalign(alignment, size);
}

void* memalign(size_t alignment, size_t size) {
  count(ALLOCATION_MEMALIGN);
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** result, size_t alignment, size_t size) {
  const int before = errno;
  count(ALLOCATION_POSIX_MEMALIGN);
  if (alignment % sizeof(void*) != 0 || alignment == 0 || (alignment & (alignment - 1)) != 0) return EINVAL;
  void* const block = __libc_memalign(alignment, size);
  errno = before; /* the error is the result */
  if (block == NULL) return ENOMEM;
  *result = block;
  return 0;
}
