#pragma once

#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <spawn.h>
#include <sys/epoll.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/timerfd.h>
#include <sys/wait.h>
#include <unistd.h>

namespace preload {

/// The calls that are wrapped for the sake of time, as they are behind this library; see Next for the others.
struct Real {
  int (*clock_gettime)(clockid_t, timespec*);
  int (*gettimeofday)(timeval*, void*);
  time_t (*time)(time_t*);
  int (*timespec_get)(timespec*, int);
  int (*nanosleep)(const timespec*, timespec*);
  int (*clock_nanosleep)(clockid_t, int, const timespec*, timespec*);
  int (*usleep)(useconds_t);
  unsigned (*sleep)(unsigned);
  int (*sched_yield)();
  int (*poll)(pollfd*, nfds_t, int);
  int (*ppoll)(pollfd*, nfds_t, const timespec*, const sigset_t*);
  int (*select)(int, fd_set*, fd_set*, fd_set*, timeval*);
  int (*pselect)(int, fd_set*, fd_set*, fd_set*, const timespec*, const sigset_t*);
  int (*epoll_wait)(int, epoll_event*, int, int);
  int (*epoll_pwait)(int, epoll_event*, int, int, const sigset_t*);
  int (*epoll_pwait2)(int, epoll_event*, int, const timespec*, const sigset_t*);
  int (*accept)(int, sockaddr*, socklen_t*);
  int (*accept4)(int, sockaddr*, socklen_t*, int);
  int (*timerfd_create)(int, int);
  int (*timerfd_settime)(int, int, const itimerspec*, itimerspec*);
  int (*timerfd_gettime)(int, itimerspec*);
  int (*setitimer)(int, const itimerval*, itimerval*);
  int (*getitimer)(int, itimerval*);
  unsigned (*alarm)(unsigned);
  int (*timer_create)(clockid_t, sigevent*, timer_t*);
  int (*timer_settime)(timer_t, int, const itimerspec*, itimerspec*);
  int (*timer_gettime)(timer_t, itimerspec*);
  int (*timer_getoverrun)(timer_t);
  int (*timer_delete)(timer_t);
  int (*sigtimedwait)(const sigset_t*, siginfo_t*, const timespec*);
  int (*sigwaitinfo)(const sigset_t*, siginfo_t*);
  int (*sigwait)(const sigset_t*, int*);
  int (*sigsuspend)(const sigset_t*);
  int (*pause)();
  int (*kill)(pid_t, int);
  int (*sigqueue)(pid_t, int, sigval);
  int (*pthread_create)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  int (*pthread_join)(pthread_t, void**);
  int (*pthread_timedjoin_np)(pthread_t, void**, const timespec*);
  int (*pthread_clockjoin_np)(pthread_t, void**, clockid_t, const timespec*);
  int (*pthread_mutex_lock)(pthread_mutex_t*);
  int (*pthread_mutex_timedlock)(pthread_mutex_t*, const timespec*);
  int (*pthread_mutex_clocklock)(pthread_mutex_t*, clockid_t, const timespec*);
  int (*pthread_mutex_unlock)(pthread_mutex_t*);
  int (*pthread_cond_wait)(pthread_cond_t*, pthread_mutex_t*);
  int (*pthread_cond_timedwait)(pthread_cond_t*, pthread_mutex_t*, const timespec*);
  int (*pthread_cond_clockwait)(pthread_cond_t*, pthread_mutex_t*, clockid_t, const timespec*);
  int (*pthread_cond_signal)(pthread_cond_t*);
  int (*pthread_cond_broadcast)(pthread_cond_t*);
  int (*pthread_rwlock_rdlock)(pthread_rwlock_t*);
  int (*pthread_rwlock_wrlock)(pthread_rwlock_t*);
  int (*pthread_rwlock_timedrdlock)(pthread_rwlock_t*, const timespec*);
  int (*pthread_rwlock_timedwrlock)(pthread_rwlock_t*, const timespec*);
  int (*pthread_rwlock_clockrdlock)(pthread_rwlock_t*, clockid_t, const timespec*);
  int (*pthread_rwlock_clockwrlock)(pthread_rwlock_t*, clockid_t, const timespec*);
  int (*pthread_rwlock_unlock)(pthread_rwlock_t*);
  int (*pthread_cancel)(pthread_t);
  int (*pthread_barrier_wait)(pthread_barrier_t*);
  int (*sem_wait)(sem_t*);
  int (*sem_timedwait)(sem_t*, const timespec*);
  int (*sem_clockwait)(sem_t*, clockid_t, const timespec*);
  int (*sem_post)(sem_t*);
  pid_t (*fork)();
  pid_t (*vfork)();
  int (*posix_spawn)(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*,
                     char* const*, char* const*);
  int (*posix_spawnp)(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*,
                      char* const*, char* const*);
  int (*system)(const char*);
  FILE* (*popen)(const char*, const char*);
  int (*pclose)(FILE*);
  int (*daemon)(int, int);
  int (*execve)(const char*, char* const*, char* const*);
  int (*execvpe)(const char*, char* const*, char* const*);
  int (*fexecve)(int, char* const*, char* const*);
  int (*execveat)(int, const char*, char* const*, char* const*, int);
  pid_t (*waitpid)(pid_t, int*, int);
  pid_t (*wait4)(pid_t, int*, int, rusage*);
  int (*waitid)(idtype_t, id_t, siginfo_t*, int);
  void (*exit_at_once)(int);  // _exit(2)
  void (*longjmp)(__jmp_buf_tag*, int);
  void (*longjmp_chk)(__jmp_buf_tag*, int);
  int (*close_range)(unsigned, unsigned, int);
  void (*closefrom)(int);
  int (*dup2)(int, int);
  int (*dup3)(int, int, int);
  FILE* (*fdopen)(int, const char*);
  int (*fgetc)(FILE*);
  int (*getc_unlocked)(FILE*);
  int (*uflow)(FILE*);
  int (*underflow)(FILE*);
  int (*vfscanf)(FILE*, const char*, va_list);
  char* (*fgets)(char*, int, FILE*);
  ssize_t (*getdelim)(char**, size_t*, int, FILE*);
  size_t (*fread)(void*, size_t, size_t, FILE*);
  long (*syscall)(long, ...);
};

/// Looked up once.
const Real& real() noexcept;

}  // namespace preload
