// What shells offer where somebody presses the tabulator key.
#include "cli/completion.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include "tests/fakes/child_process.hpp"

namespace {

using fakes::Finished;

constexpr const char* kPrograms[] = {"axisctl",       "axisd",       "axisd-http", "axisd-nats",
                                     "axisd-agent",   "canhub",      "canrec",     "canopen-audit",
                                     "canopen-check", "canopen-zoo", "edstool",    "with-can"};

/// What a real bash offers for the last of @p words, the first of which is the program; with blanks between.
std::string offered(const std::vector<std::string>& words) {
  const std::string& program = words.front();
  std::string script = "source '" SHARE "/bash-completion/completions/" + program + "'; COMP_WORDS=(";
  for (const std::string& word : words) script += " '" + word + "'";
  script += " ); COMP_CWORD=" + std::to_string(words.size() - 1) + "; cd '" SOURCE_FOLDER "'; ";
  // As readline finds it.
  script +=
      "function=$(complete -p " + program + "); function=${function#* -F }; ${function%% *}; echo ${COMPREPLY[*]}";
  const Finished shell = fakes::run_program({"/bin/bash", "--norc", "-c", script}, {"PATH=/usr/bin:/bin"});
  EXPECT_EQ(shell.errors, "");
  return shell.output;
}

TEST(BashCompletion, OffersSubcommandsOfTheProtocolAndThoseThatAreMore) {
  EXPECT_EQ(offered({"axisctl", "fault", "in"}), "inject\n");
  EXPECT_EQ(offered({"axisctl", "sup"}), "supply\n");
  EXPECT_EQ(offered({"axisctl", "wai"}), "wait\n");
  EXPECT_EQ(offered({"axisctl", "fleet", "un"}), "undrain\n");
  EXPECT_EQ(offered({"axisctl", "wait", ""}), "ready nmt state fault no-fault value\n");
  EXPECT_EQ(offered({"canrec", ""}), "record stop list remove export import play\n");
  EXPECT_EQ(offered({"edstool", ""}), "lint show diff flatten dcf c++\n");
}

TEST(BashCompletion, OffersWhatAWordMayBe) {
  EXPECT_EQ(offered({"axisctl", "load", "1", "5", ""}), "constant friction\n");
  EXPECT_EQ(offered({"axisctl", "input", "3", ""}), "on off\n");
  EXPECT_EQ(offered({"axisctl", "encoder", "1", "lo"}), "loss lost_pulses\n");
  EXPECT_EQ(offered({"axisctl", "wait", "state", "1", "op"}), "operation-enabled\n");
  EXPECT_EQ(offered({"axisctl", "load", "1", ""}), "\n") << "a number";
  EXPECT_EQ(offered({"edstool", "lint", "README"}), "README.md\n");
  EXPECT_EQ(offered({"with-can", "--private", "--", "READ"}), "\n") << "no program";
}

TEST(BashCompletion, OffersOptionsOfTheSubcommandAndOfThoseAbove) {
  EXPECT_EQ(offered({"axisctl", "wait", "ready", "--ti"}), "--timeout\n");
  EXPECT_EQ(offered({"axisctl", "wait", "ready", "--j"}), "--json\n");
  EXPECT_EQ(offered({"axisctl", "--ti"}), "\n");
  EXPECT_EQ(offered({"axisctl", "--fa"}), "--farm\n");
  EXPECT_EQ(offered({"canhub", "--pa"}), "--path\n");
  EXPECT_EQ(offered({"canopen-check", "--dev"}), "--deviations\n");
  EXPECT_EQ(offered({"with-can", "--p"}), "--private\n");
  EXPECT_EQ(offered({"axisd", "--check"}), "--check-config\n");
}

TEST(BashCompletion, OffersValuesOfOptions) {
  EXPECT_EQ(offered({"axisd", "--log-level", "n"}), "notice\n");
  EXPECT_EQ(offered({"axisd", "--log-level", "=", "n"}), "notice\n") << "--log-level=n";
  EXPECT_EQ(offered({"axisd", "--config", "README"}), "README.md\n");
  EXPECT_EQ(offered({"axisd", "--node-id", ""}), "\n");
  EXPECT_EQ(offered({"edstool", "lint", "--severity", ""}), "error warning\n");
  EXPECT_EQ(offered({"canopen-zoo", "--run", "NeverT"}), "NeverToggles\n");
}

TEST(BashCompletion, KnowsValuesOfOptionsFromWords) {
  EXPECT_EQ(offered({"axisctl", "--unit", "fault", "fault", ""}), offered({"axisctl", "fault", ""}));
  EXPECT_EQ(offered({"axisctl", "--json", "fault", "a"}), "ack\n");
}

/// zsh and fish where the machine has them.
TEST(Completion, IsUnderstoodByTheShellsThatAreThere) {
  for (const std::string program : kPrograms) {
    for (const auto& [shell, file] :
         {std::pair{std::string{"/bin/bash"}, "/bash-completion/completions/" + program},
          {"/usr/bin/zsh", "/zsh/site-functions/_" + program},
          {"/usr/bin/fish", "/fish/vendor_completions.d/" + program + ".fish"}}) {
      ASSERT_TRUE(std::filesystem::exists(SHARE + file)) << file;
      if (!std::filesystem::exists(shell)) continue;
      const Finished checked = fakes::run_program({shell, "-n", SHARE + file});
      EXPECT_EQ(checked.status, 0) << checked.errors;
      EXPECT_EQ(checked.errors, "") << file;
    }
  }
}

TEST(Completion, IsMadeFromWhatTheProgramTakes) {
  CLI::App app{"An example", "example"};
  std::string file;
  std::string mode;
  app.add_option("--file", file, "it's a file")->type_name("FILE");
  app.add_option("--secret", mode)->group("");
  app.add_subcommand("run", "Runs")->add_option("MODE", mode)->check(CLI::IsMember({"fast", "slow"}));

  const cli::Command described = cli::describe(app);

  ASSERT_EQ(described.options.size(), 2u) << "--help and --file";
  EXPECT_EQ(described.options[1].names, std::vector<std::string>{"--file"});
  EXPECT_EQ(described.options[1].value.kind, cli::Kind::File);
  ASSERT_EQ(described.commands.size(), 1u);
  ASSERT_EQ(described.commands[0].words.size(), 1u);
  EXPECT_EQ(described.commands[0].words[0].name, "MODE");
  for (const char* const shell : {"bash", "zsh", "fish"})
    EXPECT_NE(cli::completion_script(described, shell).find("file"), std::string::npos)
        << shell << cli::completion_script(described, shell);
  EXPECT_EQ(cli::completion_script(described, "csh"), "");
}

}  // namespace
