/* Preloaded into a program, it lets one call fail. FAIL_CALL="fsync 3 5" is the third fsync(2) of the process,
   which fails with errno 5; short_write, which is a kind of its own, writes half instead. FAIL_COUNTS names a file
   in which another process reads how many calls of each kind there were. Without FAIL_CALL nothing fails. */
#define _GNU_SOURCE
#include "tests/support/failing_calls.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/timerfd.h>
#include <sys/uio.h>
#include <unistd.h>

#include "tests/support/spared_calls.h"

extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t count, size_t size);
extern void* __libc_realloc(void* old, size_t size);
extern void* __libc_memalign(size_t alignment, size_t size);

static uint64_t unread[FAILING_CALL_KINDS]; /* until the file is mapped */
static uint64_t* counts = unread;
static int failing_kind = -1;
static int wanted_kind = -1; /* from main() on */
static uint64_t failing_number;
static int failing_error;
_Thread_local int spared;

#define NAME_OF(name) #name,
static const char* const kNames[] = {FAILING_CALLS(NAME_OF)};

/* Whether this call fails; errno is set then. */
static int fails(enum failing_call kind) {
  if (spared) return 0;
  const uint64_t number = __atomic_add_fetch(&counts[kind], 1, __ATOMIC_RELAXED);
  if ((int)kind != failing_kind || number != failing_number) return 0;
  errno = failing_error;
  return 1;
}

__attribute__((constructor)) static void begin(void) {
  char name[32];
  unsigned long number = 0;
  int error = 0;
  const char* const said = getenv("FAIL_CALL");
  if (said != NULL && sscanf(said, "%31s %lu %d", name, &number, &error) == 3)
    for (int kind = 0; kind < FAILING_CALL_KINDS; ++kind)
      if (strcmp(name, kNames[kind]) == 0) wanted_kind = kind;
  failing_number = number;
  failing_error = error;
  const char* const path = getenv("FAIL_COUNTS");
  const int file = path != NULL ? (int)syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CLOEXEC) : -1;
  if (file >= 0) {
    void* const mapped =
        (void*)syscall(SYS_mmap, NULL, FAILING_CALLS_FILE_SIZE, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (mapped != MAP_FAILED) counts = mapped;
    syscall(SYS_close, file);
  }
}

#define REAL(type, name, ...) ((type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, #name))

/* What comes before main() does not count: without memory for what is static there is no program that could say a
 * word. */
static int (*real_main)(int, char**, char**);
static int counted_main(int count, char** words, char** environment) {
  memset(counts, 0, sizeof unread);
  failing_kind = wanted_kind;
  return real_main(count, words, environment);
}
int __libc_start_main(int (*begin_at)(int, char**, char**), int count, char** words, void (*initialise)(void),
                      void (*finish)(void), void (*finish_linker)(void), void* stack_end) {
  real_main = begin_at;
  return REAL(int, __libc_start_main, int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void),
              void (*)(void), void*)(counted_main, count, words, initialise, finish, finish_linker, stack_end);
}

static int open_as(int folder, const char* path, int flags, mode_t mode) {
  if (fails(CALL_open)) return -1;
  return (int)syscall(SYS_openat, folder, path, flags, mode);
}

static mode_t mode_in(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

#define OPEN(name)                                 \
  int name(const char* path, int flags, ...) {     \
    va_list arguments;                             \
    va_start(arguments, flags);                    \
    const mode_t mode = mode_in(flags, arguments); \
    va_end(arguments);                             \
    return open_as(AT_FDCWD, path, flags, mode);   \
  }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                       \
  int name(int folder, const char* path, int flags, ...) { \
    va_list arguments;                                     \
    va_start(arguments, flags);                            \
    const mode_t mode = mode_in(flags, arguments);         \
    va_end(arguments);                                     \
    return open_as(folder, path, flags, mode);             \
  }
OPENAT(openat)
OPENAT(openat64)

int __open_2(const char* path, int flags) {
  return open_as(AT_FDCWD, path, flags, 0);
}
int __open64_2(const char* path, int flags) {
  return open_as(AT_FDCWD, path, flags, 0);
}

ssize_t read(int descriptor, void* to, size_t size) {
  return fails(CALL_read) ? -1 : (ssize_t)syscall(SYS_read, descriptor, to, size);
}
ssize_t __read_chk(int descriptor, void* to, size_t size, size_t room) {
  (void)room;
  return read(descriptor, to, size);
}

ssize_t write(int descriptor, const void* from, size_t size) {
  if (fails(CALL_write)) return -1;
  if (fails(CALL_short_write) && size > 1) size /= 2;
  return (ssize_t)syscall(SYS_write, descriptor, from, size);
}
ssize_t writev(int descriptor, const struct iovec* parts, int count) {
  return fails(CALL_write) ? -1 : (ssize_t)syscall(SYS_writev, descriptor, parts, count);
}

int fsync(int descriptor) {
  return fails(CALL_fsync) ? -1 : (int)syscall(SYS_fsync, descriptor);
}
int fdatasync(int descriptor) {
  return fails(CALL_fsync) ? -1 : (int)syscall(SYS_fdatasync, descriptor);
}
int rename(const char* from, const char* to) {
  return fails(CALL_rename) ? -1 : (int)syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0);
}
int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  return fails(CALL_rename) ? -1 : (int)syscall(SYS_renameat2, from_folder, from, to_folder, to, flags);
}
int unlink(const char* path) {
  return fails(CALL_unlink) ? -1 : (int)syscall(SYS_unlinkat, AT_FDCWD, path, 0);
}
int mkdir(const char* path, mode_t mode) {
  return fails(CALL_mkdir) ? -1 : (int)syscall(SYS_mkdirat, AT_FDCWD, path, mode);
}

int socket(int family, int type, int protocol) {
  return fails(CALL_socket) ? -1 : (int)syscall(SYS_socket, family, type, protocol);
}
int socketpair(int family, int type, int protocol, int ends[2]) {
  return fails(CALL_socket) ? -1 : (int)syscall(SYS_socketpair, family, type, protocol, ends);
}
int bind(int descriptor, const struct sockaddr* address, socklen_t length) {
  return fails(CALL_bind) ? -1 : (int)syscall(SYS_bind, descriptor, address, length);
}
int listen(int descriptor, int backlog) {
  return fails(CALL_listen) ? -1 : (int)syscall(SYS_listen, descriptor, backlog);
}
int connect(int descriptor, const struct sockaddr* address, socklen_t length) {
  return fails(CALL_connect) ? -1 : (int)syscall(SYS_connect, descriptor, address, length);
}
int accept4(int descriptor, struct sockaddr* address, socklen_t* length, int flags) {
  return fails(CALL_accept) ? -1 : (int)syscall(SYS_accept4, descriptor, address, length, flags);
}
int accept(int descriptor, struct sockaddr* address, socklen_t* length) {
  return accept4(descriptor, address, length, 0);
}

ssize_t sendto(int descriptor, const void* from, size_t size, int flags, const struct sockaddr* to,
               socklen_t length) {
  return fails(CALL_send) ? -1 : (ssize_t)syscall(SYS_sendto, descriptor, from, size, flags, to, length);
}
ssize_t send(int descriptor, const void* from, size_t size, int flags) {
  return sendto(descriptor, from, size, flags, NULL, 0);
}
ssize_t sendmsg(int descriptor, const struct msghdr* message, int flags) {
  return fails(CALL_send) ? -1 : (ssize_t)syscall(SYS_sendmsg, descriptor, message, flags);
}
int sendmmsg(int descriptor, struct mmsghdr* messages, unsigned count, int flags) {
  return fails(CALL_send) ? -1 : (int)syscall(SYS_sendmmsg, descriptor, messages, count, flags);
}
ssize_t recvfrom(int descriptor, void* to, size_t size, int flags, struct sockaddr* from, socklen_t* length) {
  return fails(CALL_receive) ? -1 : (ssize_t)syscall(SYS_recvfrom, descriptor, to, size, flags, from, length);
}
ssize_t recv(int descriptor, void* to, size_t size, int flags) {
  return recvfrom(descriptor, to, size, flags, NULL, NULL);
}
ssize_t __recv_chk(int descriptor, void* to, size_t size, size_t room, int flags) {
  (void)room;
  return recv(descriptor, to, size, flags);
}
ssize_t recvmsg(int descriptor, struct msghdr* message, int flags) {
  return fails(CALL_receive) ? -1 : (ssize_t)syscall(SYS_recvmsg, descriptor, message, flags);
}
int recvmmsg(int descriptor, struct mmsghdr* messages, unsigned count, int flags, struct timespec* longest) {
  return fails(CALL_receive) ? -1 : (int)syscall(SYS_recvmmsg, descriptor, messages, count, flags, longest);
}

int epoll_create1(int flags) {
  return fails(CALL_epoll) ? -1 : (int)syscall(SYS_epoll_create1, flags);
}
int epoll_ctl(int set, int operation, int descriptor, struct epoll_event* event) {
  if (operation != EPOLL_CTL_DEL /* needs nothing */ && fails(CALL_epoll)) return -1;
  return (int)syscall(SYS_epoll_ctl, set, operation, descriptor, event);
}
int epoll_wait(int set, struct epoll_event* events, int most, int longest) {
  if (fails(CALL_wait)) return -1;
  return REAL(int, epoll_wait, int, struct epoll_event*, int, int)(set, events, most, longest);
}
int poll(struct pollfd* descriptors, nfds_t count, int longest) {
  if (fails(CALL_wait)) return -1;
  return REAL(int, poll, struct pollfd*, nfds_t, int)(descriptors, count, longest);
}
int ppoll(struct pollfd* descriptors, nfds_t count, const struct timespec* longest, const sigset_t* signals) {
  if (fails(CALL_wait)) return -1;
  return REAL(int, ppoll, struct pollfd*, nfds_t, const struct timespec*, const sigset_t*)(descriptors, count,
                                                                                           longest, signals);
}

int timerfd_create(int clock, int flags) {
  return fails(CALL_timer) ? -1 : (int)syscall(SYS_timerfd_create, clock, flags);
}
int timerfd_settime(int timer, int flags, const struct itimerspec* time, struct itimerspec* before) {
  return fails(CALL_timer) ? -1 : (int)syscall(SYS_timerfd_settime, timer, flags, time, before);
}
int eventfd(unsigned count, int flags) {
  return fails(CALL_eventfd) ? -1 : (int)syscall(SYS_eventfd2, count, flags);
}
void* mmap(void* at, size_t size, int protection, int flags, int descriptor, off_t offset) {
  return fails(CALL_map) ? MAP_FAILED : (void*)syscall(SYS_mmap, at, size, protection, flags, descriptor, offset);
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  if (fails(CALL_thread)) return failing_error;
  return REAL(int, pthread_create, pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)(thread, attributes,
                                                                                               run, argument);
}

int posix_spawn(pid_t* process, const char* path, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* attributes, char* const words[], char* const variables[]) {
  if (fails(CALL_spawn)) return failing_error;
  return REAL(int, posix_spawn, pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*,
              char* const*, char* const*)(process, path, actions, attributes, words, variables);
}
int pipe2(int ends[2], int flags) {
  return fails(CALL_pipe) ? -1 : (int)syscall(SYS_pipe2, ends, flags);
}
int inotify_init1(int flags) {
  return fails(CALL_inotify) ? -1 : (int)syscall(SYS_inotify_init1, flags);
}
int inotify_add_watch(int set, const char* path, uint32_t events) {
  return fails(CALL_inotify) ? -1 : (int)syscall(SYS_inotify_add_watch, set, path, events);
}

void* malloc(size_t size) {
  return fails(CALL_memory) ? NULL : __libc_malloc(size);
}
void* calloc(size_t number, size_t size) {
  return fails(CALL_memory) ? NULL : __libc_calloc(number, size);
}
void* realloc(void* old, size_t size) {
  return fails(CALL_memory) ? NULL : __libc_realloc(old, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  return fails(CALL_memory) ? NULL : __libc_memalign(alignment, size);
}
