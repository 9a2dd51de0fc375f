/* What failing_calls.c shares with the tests that preload it. */
#ifndef TESTS_SUPPORT_FAILING_CALLS_H
#define TESTS_SUPPORT_FAILING_CALLS_H

/* X(name): a kind of calls, in the order of their numbers in the file of counts (uint64_t each). */
#define FAILING_CALLS(X) \
  X(open)                \
  X(read)                \
  X(write)               \
  X(short_write)         \
  X(fsync)               \
  X(rename)              \
  X(unlink)              \
  X(mkdir)               \
  X(socket)              \
  X(bind)                \
  X(listen)              \
  X(connect)             \
  X(accept)              \
  X(send)                \
  X(receive)             \
  X(epoll)               \
  X(wait)                \
  X(timer)               \
  X(eventfd)             \
  X(map)                 \
  X(thread)              \
  X(spawn)               \
  X(pipe)                \
  X(inotify)             \
  X(memory)

#define FAILING_CALL_OF(name) CALL_##name,
enum failing_call { FAILING_CALLS(FAILING_CALL_OF) FAILING_CALL_KINDS };
#undef FAILING_CALL_OF

#define FAILING_CALLS_FILE_SIZE 4096

#endif
