#include <array>

#include <elf.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "tests/tools/with-can/with_can_fixture.hpp"

namespace with_can_test {
namespace {

TEST_F(WithCan, RefusesAStaticProgram) {
  const fakes::Finished result = run_on_bus({STATIC_PROGRAM});

  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(is_one_line_with(result.errors, "linked statically"));
  EXPECT_TRUE(is_one_line_with(result.errors, "--socketcand"));  // what to use instead
}

TEST_F(WithCan, RefusesAnotherCLibrary) {
  const std::string own = "/lib64/ld-linux-x86-64.so.2";
  const std::size_t at = whole_program().find(own);
  ASSERT_NE(at, std::string::npos);

  const fakes::Finished result =
      run_on_bus({changed_program(at, std::string("/lib/ld-musl-x86_64.so.1\0\0", 26))});

  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(is_one_line_with(result.errors, "another C library (ld-musl-x86_64.so.1)"));
}

TEST_F(WithCan, RefusesAnotherMachine) {
  const std::string machine{static_cast<char>(EM_AARCH64), 0};

  const fakes::Finished result = run_on_bus({changed_program(offsetof(Elf64_Ehdr, e_machine), machine)});

  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(is_one_line_with(result.errors, "another machine"));
}

TEST_F(WithCan, RefusesAnotherWordSize) {
  const fakes::Finished result = run_on_bus({changed_program(EI_CLASS, std::string{ELFCLASS32})});

  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(is_one_line_with(result.errors, "another machine or word size"));
}

TEST_F(WithCan, RefusesSetuidAndSetgid) {
  for (const mode_t bit : {mode_t{S_ISUID}, mode_t{S_ISGID}}) {
    const std::string program = executable("program", whole_program());
    ASSERT_EQ(::chmod(program.c_str(), 0755 | bit), 0);

    const fakes::Finished result = run_on_bus({program});

    EXPECT_EQ(result.status, 2);
    EXPECT_TRUE(is_one_line_with(result.errors, "setuid or setgid"));
  }
}

TEST_F(WithCan, RefusesFileCapabilities) {
  const std::string program = executable("program", whole_program());
  // revision 2 of struct vfs_cap_data: CAP_NET_RAW permitted and effective
  constexpr std::array<unsigned char, 20> kCapabilities{1, 0, 0, 2, 0, 0x20};
  if (::setxattr(program.c_str(), "security.capability", kCapabilities.data(), kCapabilities.size(), 0) != 0) {
    ASSERT_NE(::geteuid(), 0u) << "root may give a file capabilities";
    return;  // nobody else may, and so there is nothing to look at
  }

  const fakes::Finished result = run_on_bus({program});

  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(is_one_line_with(result.errors, "file capabilities"));
}

TEST_F(WithCan, FollowsScriptsToTheirInterpreter) {
  const std::string fixed = STATIC_PROGRAM;
  for (const std::string& line : {"#!" + fixed + "\n", "#! " + fixed + " -x\n", "#!/usr/bin/env " + fixed + "\n",
                                  "#!/usr/bin/env -S A=1 " + fixed + " -x\n"}) {
    const fakes::Finished result = run_on_bus({executable("script", line)});

    EXPECT_EQ(result.status, 2) << line;
    EXPECT_TRUE(is_one_line_with(result.errors, "static_program: is linked statically")) << line;
  }
  EXPECT_EQ(run_on_bus({executable("script", "#!/bin/sh\nexit 7\n")}).status, 7);
  EXPECT_EQ(run_on_bus({executable("script", "#!/usr/bin/env sh\nexit 8\n")}).status, 8);
  EXPECT_EQ(run_on_bus({executable("script", "exit 9\n")}).status, 9);  // the shell's, without a first line
}

TEST_F(WithCan, FollowsScriptsOfScripts) {
  const std::string inner = executable("inner", std::string{"#!"} + STATIC_PROGRAM + "\n");
  const std::string circle = path("circle");

  EXPECT_EQ(run_on_bus({executable("outer", "#!" + inner + "\n")}).status, 2);
  EXPECT_EQ(run_on_bus({executable("circle", "#!" + circle + "\n")}).status, 2);
  const fakes::Finished missing = run_on_bus({executable("outer", "#!/nowhere/shell\n")});
  EXPECT_EQ(missing.status, 127);
  EXPECT_TRUE(is_one_line_with(missing.errors, "its interpreter /nowhere/shell: no such file"));
}

TEST_F(WithCan, SaysThatThereIsNoProgram) {
  const fakes::Finished named = run_on_bus({"no-such-program"});
  EXPECT_EQ(named.status, 127);
  EXPECT_TRUE(is_one_line_with(named.errors, "no-such-program: no such program in $PATH"));
  EXPECT_EQ(run_on_bus({path("nothing")}).status, 127);
}

TEST_F(WithCan, SaysThatItIsNotExecutable) {
  std::ofstream{path("text")} << "text";

  const fakes::Finished result = run_on_bus({path("text")});

  EXPECT_EQ(result.status, 126);
  EXPECT_TRUE(is_one_line_with(result.errors, "is not an executable file"));
  EXPECT_EQ(run_on_bus({path("")}).status, 126);  // a folder
}

TEST_F(WithCan, SaysOfFilesThatAreCutOffThatTheyCannotBeRun) {
  for (const std::size_t size : {4u, 16u, 63u, 64u, 100u}) {
    const fakes::Finished result = run_on_bus({executable("cut", whole_program().substr(0, size))});

    EXPECT_EQ(result.status, 126) << size;
    EXPECT_TRUE(is_one_line_with(result.errors, "cut: ")) << size;
  }
}

}  // namespace
}  // namespace with_can_test
