#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace preload_test {
namespace {

/// What is behind @p mark in the lines of @p text that have it.
std::vector<std::string> words_behind(const std::string& text, const std::string& mark) {
  std::vector<std::string> words;
  std::istringstream lines{text};
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t at = line.find(mark); at != std::string::npos)
      words.push_back(line.substr(at + mark.size()));
  std::ranges::sort(words);
  return words;
}

/// Runs `sh -c SCRIPT` with the library and bus @p bus.
fakes::Finished run_shell(const std::string& script, const std::string& bus, const std::string& more = "A=") {
  return fakes::run_program({"/bin/sh", "-c", script},
                            {std::string{"LD_PRELOAD="} + LIBRARY, "CAN_BUS=" + bus, "PATH=/usr/bin:/bin", more});
}

TEST(PreloadLibrary, NeedsTheCLibraryOnly) {
  const fakes::Finished result = fakes::run_program({"/usr/bin/readelf", "-d", LIBRARY});

  EXPECT_EQ(words_behind(result.output, "Shared library: "), (std::vector<std::string>{"[libc.so.6]"}));
}

TEST(PreloadLibrary, ShowsWhatItWrapsAndWhetherItKeepsTimeOnly) {
  const fakes::Finished result = fakes::run_program({"/usr/bin/nm", "-D", "--defined-only", LIBRARY});

  const std::vector<std::string> calls{"_Exit",
                                       "__fgets_chk",
                                       "__fread_chk",
                                       "__getdelim",
                                       "__isoc99_fscanf",
                                       "__isoc99_scanf",
                                       "__longjmp_chk",
                                       "__poll_chk",
                                       "__ppoll_chk",
                                       "__read_chk",
                                       "__recv_chk",
                                       "__recvfrom_chk",
                                       "__uflow",
                                       "__underflow",
                                       "_exit",
                                       "_longjmp",
                                       "accept",
                                       "accept4",
                                       "alarm",
                                       "bind",
                                       "can_bus_keeps_time",
                                       "clock_gettime",
                                       "clock_nanosleep",
                                       "close",
                                       "close_range",
                                       "closefrom",
                                       "cnd_broadcast",
                                       "cnd_signal",
                                       "cnd_timedwait",
                                       "cnd_wait",
                                       "connect",
                                       "dup2",
                                       "dup3",
                                       "epoll_pwait",
                                       "epoll_pwait2",
                                       "epoll_wait",
                                       "execl",
                                       "execle",
                                       "execlp",
                                       "execv",
                                       "execve",
                                       "execveat",
                                       "execvp",
                                       "execvpe",
                                       "fdopen",
                                       "fexecve",
                                       "fgetc",
                                       "fgetc_unlocked",
                                       "fgets",
                                       "fgets_unlocked",
                                       "fread",
                                       "fread_unlocked",
                                       "getc",
                                       "getc_unlocked",
                                       "getchar",
                                       "getchar_unlocked",
                                       "getdelim",
                                       "getitimer",
                                       "getline",
                                       "getsockname",
                                       "getsockopt",
                                       "gettimeofday",
                                       "if_indextoname",
                                       "if_nameindex",
                                       "if_nametoindex",
                                       "ioctl",
                                       "kill",
                                       "killpg",
                                       "longjmp",
                                       "mtx_lock",
                                       "mtx_timedlock",
                                       "mtx_unlock",
                                       "nanosleep",
                                       "pause",
                                       "pclose",
                                       "poll",
                                       "popen",
                                       "posix_spawn",
                                       "posix_spawnp",
                                       "ppoll",
                                       "pselect",
                                       "pthread_barrier_wait",
                                       "pthread_cancel",
                                       "pthread_clockjoin_np",
                                       "pthread_cond_broadcast",
                                       "pthread_cond_clockwait",
                                       "pthread_cond_signal",
                                       "pthread_cond_timedwait",
                                       "pthread_cond_wait",
                                       "pthread_create",
                                       "pthread_join",
                                       "pthread_mutex_clocklock",
                                       "pthread_mutex_lock",
                                       "pthread_mutex_timedlock",
                                       "pthread_mutex_unlock",
                                       "pthread_rwlock_clockrdlock",
                                       "pthread_rwlock_clockwrlock",
                                       "pthread_rwlock_rdlock",
                                       "pthread_rwlock_timedrdlock",
                                       "pthread_rwlock_timedwrlock",
                                       "pthread_rwlock_unlock",
                                       "pthread_rwlock_wrlock",
                                       "pthread_timedjoin_np",
                                       "read",
                                       "readv",
                                       "recv",
                                       "recvfrom",
                                       "recvmmsg",
                                       "recvmsg",
                                       "sched_yield",
                                       "select",
                                       "sem_clockwait",
                                       "sem_post",
                                       "sem_timedwait",
                                       "sem_wait",
                                       "send",
                                       "sendmmsg",
                                       "sendmsg",
                                       "sendto",
                                       "setitimer",
                                       "setsockopt",
                                       "siglongjmp",
                                       "sigqueue",
                                       "sigsuspend",
                                       "sigtimedwait",
                                       "sigwait",
                                       "sigwaitinfo",
                                       "sleep",
                                       "socket",
                                       "syscall",
                                       "system",
                                       "thrd_create",
                                       "thrd_join",
                                       "thrd_sleep",
                                       "thrd_yield",
                                       "time",
                                       "timer_create",
                                       "timer_delete",
                                       "timer_getoverrun",
                                       "timer_gettime",
                                       "timer_settime",
                                       "timerfd_create",
                                       "timerfd_gettime",
                                       "timerfd_settime",
                                       "timespec_get",
                                       "usleep",
                                       "vfork",
                                       "wait",
                                       "wait3",
                                       "wait4",
                                       "waitid",
                                       "waitpid",
                                       "write",
                                       "writev"};
  EXPECT_EQ(words_behind(result.output, " T "), calls);
  EXPECT_EQ(words_behind(result.output, " ").size(), calls.size());
}

TEST(PreloadLibrary, StartsNoHubForProgramsThatDoNotUseCan) {
  const fakes::TemporaryDirectory folder;
  const std::string bus = folder.path("bus");

  const fakes::Finished result =
      run_shell("/usr/bin/python3 -c 'import socket; print(len(socket.if_nameindex()))'", bus);

  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output, "");
  EXPECT_FALSE(std::filesystem::exists(bus));
}

TEST(PreloadLibrary, SaysOnceWhyThereIsNoBus) {
  const fakes::TemporaryDirectory folder;
  const std::string file = folder.path("file");
  std::ofstream{file} << "text";
  struct Case {
    std::string bus, more, message;
  };
  const std::vector<Case> cases{
      {folder.path("bus"), "CAN_HUB=/nowhere/canhub", "is not served, and the program canhub was not found"},
      {file, "A=", "is in use by something that is no CAN bus"},
      {folder.path("no/such/folder/bus"), "A=", "cannot be served by canhub"},
      {"/" + std::string(107, 'x'), "A=", "has a path that is too long: 107 bytes are the most"},
  };
  for (const Case& wanted : cases) {
    const fakes::Finished result = run_shell(
        "/usr/bin/python3 -c '\n"
        "import socket\n"
        "for i in range(2):\n"
        "  try: socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)\n"
        "  except OSError as error: print(error.strerror)'",
        wanted.bus, wanted.more);

    EXPECT_EQ(result.output,
              "Address family not supported by protocol\nAddress family not supported by protocol\n");
    EXPECT_EQ(words_behind(result.errors, "libcan-preload: the CAN bus ").size(), 1u) << result.errors;
    EXPECT_NE(result.errors.find(wanted.message), std::string::npos) << result.errors;
  }
}

}  // namespace
}  // namespace preload_test
