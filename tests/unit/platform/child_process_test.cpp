// What a started program finds, and how its end is told.
#include "creepcontact/platform/child_process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "support/says.hpp"

namespace creepcontact::platform {
namespace {

std::string all_of(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer;
  for (ssize_t n = 0; (n = ::read(descriptor, buffer.data(), buffer.size())) > 0;) text.append(buffer.data(), n);
  return text;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// What a program writes to its standard output.
std::string output_of(ChildSetup setup) {
  Pipe pipe;
  setup.descriptors.emplace_back(pipe.writing_end(), STDOUT_FILENO);
  ChildProcess child(setup);
  pipe.close_writing_end();
  const std::string text = all_of(pipe.reading_end());
  EXPECT_EQ(child.wait(), 0);
  return text;
}

ChildSetup shell(const std::string& script) {
  return {"/bin/sh", {"-c", script}};
}

/// The signals in a mask of /proc/PID/status.
unsigned long mask(const std::string& status, const std::string& name) {
  return std::stoul(status.substr(status.find(name + ":") + name.size() + 1), nullptr, 16);
}

TEST(ChildProcess, TellsHowItEnded) {
  EXPECT_EQ(ChildProcess(shell("exit 0")).wait(), 0);
  EXPECT_EQ(ChildProcess(shell("exit 3")).wait(), 3);
  EXPECT_EQ(ChildProcess(shell("exit 143")).wait(), 143);
  EXPECT_EQ(ChildProcess(shell("kill -TERM $$")).wait(), 128 + SIGTERM);
  ChildProcess polled(shell("exit 4"));
  std::optional<int> status;
  while (!(status = polled.poll())) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(status, 4);
  EXPECT_EQ(polled.poll(), 4);
  EXPECT_EQ(polled.wait(), 4);
}

TEST(ChildProcess, HasNotSucceededIfTheSystemDoesNotTell) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        std::signal(SIGCHLD, SIG_IGN);
        ChildProcess polled(shell("exit 0"));
        while (!polled.poll()) std::this_thread::yield();
        std::_Exit(*polled.poll() == 127 && ChildProcess(shell("exit 0")).wait() == 127 ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST(ChildProcess, TellsHowItEndedWhereThisProgramBeganWithSigchldIgnored) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        std::signal(SIGCHLD, SIG_IGN);
        end_at_signals();
        std::_Exit(ChildProcess(shell("exit 3")).wait());
      },
      testing::ExitedWithCode(3), "");
}

TEST(ChildProcess, IsInterruptedAndKilledWithAllThatItStarted) {
  ChildProcess interrupted({"/bin/sleep", {"1000"}});
  EXPECT_FALSE(interrupted.poll());
  interrupted.interrupt();
  EXPECT_EQ(interrupted.wait(), 128 + SIGINT);

  Pipe pipe;  // comes to its end only when the grandchild is gone too
  ChildSetup setup = shell("sleep 1000 & echo started; wait");
  setup.descriptors = {{pipe.writing_end(), STDOUT_FILENO}};
  ChildProcess killed(setup);
  pipe.close_writing_end();
  std::array<char, 8> started;
  EXPECT_EQ(::read(pipe.reading_end(), started.data(), started.size()), 8);
  killed.kill();
  EXPECT_EQ(killed.wait(), 128 + SIGKILL);
  EXPECT_EQ(all_of(pipe.reading_end()), "");

  ChildProcess at_once({"/bin/sleep", {"1000"}});
  at_once.kill();  // its group is there as soon as it is
  EXPECT_EQ(at_once.wait(), 128 + SIGKILL);
}

TEST(ChildProcess, ThatCannotBeStartedIsAnError) {
  for (const char* program : {"/no/such/program", "/etc/passwd"}) try {
      const ChildProcess child({program});
      ADD_FAILURE() << program;
    } catch (const SolverError& error) {
      EXPECT_TRUE(test::says(error.what(), {"'" + std::string(program) + "': "}));
    }
  const std::filesystem::path no_program = std::filesystem::path(testing::TempDir()) / "creepcontact_no_program";
  std::ofstream(no_program) << '\x7f';
  std::filesystem::permissions(no_program, std::filesystem::perms::owner_all);
  EXPECT_EQ(ChildProcess({no_program}).wait(), 127);
  std::filesystem::remove(no_program);
}

TEST(ChildProcess, ThatTheSystemRefusesIsAnError) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const rlimit none{};
        ::setrlimit(RLIMIT_NPROC, &none);
        if (::getuid() == 0 && ::setuid(65534) != 0) std::_Exit(1);  // the limit is not for root
        try {
          const ChildProcess child({"/bin/true"});
        } catch (const SolverError& error) {
          [[maybe_unused]] const auto written = ::write(STDERR_FILENO, error.what(), std::strlen(error.what()));
          std::_Exit(0);
        }
        std::_Exit(2);
      },
      testing::ExitedWithCode(0), "^[^\n]*'/bin/true': Resource temporarily unavailable$");
}

TEST(ChildProcess, GetsItsArgumentsAsTheyAre) {
  EXPECT_EQ(output_of({"/usr/bin/printf", {"%s|", "a b", "", "\"c\\\"", "$HOME *", "d'"}}), "a b||\"c\\\"|$HOME *|d'|");
}

TEST(ChildProcess, HasAGroupOfItsOwn) {
  const std::vector<std::string> stat = words_of(output_of({"/bin/cat", {"/proc/self/stat"}}));
  ASSERT_GT(stat.size(), 4);
  EXPECT_EQ(stat[3], std::to_string(::getpid()));
  EXPECT_EQ(stat[4], stat[0]);
}

TEST(ChildProcess, HasSignalsBlockedOnlyIfItLetsThemThrough) {
  constexpr unsigned long signals = 1UL << (SIGINT - 1) | 1UL << (SIGTERM - 1) | 1UL << (SIGHUP - 1);
  ChildSetup setup{"/bin/cat", {"/proc/self/status"}};
  EXPECT_EQ(mask(output_of(setup), "SigBlk"), 0);
  {
    const BlockedSignals blocked;
    EXPECT_EQ(mask(output_of(setup), "SigBlk"), 0);
  }
  setup.lets_signals_through = true;
  EXPECT_EQ(mask(output_of(setup), "SigBlk"), signals);
  sigset_t now;
  ::pthread_sigmask(SIG_SETMASK, nullptr, &now);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) EXPECT_FALSE(sigismember(&now, signal));
}

TEST(ChildProcess, DiesWithTheProcessThatStartedIt) {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // whoever loses its parent becomes a child of this process
  for (const int signal : {SIGTERM, SIGKILL}) {
    Pipe pipe;
    const pid_t parent = ::fork();
    if (parent == 0) {
      const ChildProcess child({.program = "/bin/sh",
                                .arguments = {"-c", "echo $$; exec sleep 1000"},
                                .descriptors = {{pipe.writing_end(), STDOUT_FILENO}},
                                .signal_at_death = signal});
      ::pause();
    }
    std::array<char, 32> text{};
    ASSERT_GT(::read(pipe.reading_end(), text.data(), text.size() - 1), 0);
    ::kill(parent, SIGKILL);
    ::waitpid(parent, nullptr, 0);
    int status = 0;
    ASSERT_EQ(::waitpid(std::stoi(text.data()), &status, 0), std::stoi(text.data()));
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal);
  }
  ::prctl(PR_SET_CHILD_SUBREAPER, 0);
}

TEST(ChildProcess, GetsTheDescriptorsNamedAndNull) {
  const ChildSetup null = shell("readlink /proc/$$/fd/0; readlink /proc/$$/fd/2");
  EXPECT_EQ(output_of(null), "/dev/null\n/dev/null\n");

  // Each to the number of the other.
  Pipe first, second;
  const int a = first.writing_end(), b = second.writing_end();
  ChildProcess child({"/bin/bash",
                      {"-c", "echo first >&" + std::to_string(b) + "; echo second >&" + std::to_string(a)},
                      {{a, b}, {b, a}}});
  first.close_writing_end();
  second.close_writing_end();
  EXPECT_EQ(all_of(first.reading_end()), "first\n");
  EXPECT_EQ(all_of(second.reading_end()), "second\n");
  EXPECT_EQ(child.wait(), 0);

  // To its own number.
  Pipe same;
  ChildProcess other({"/bin/bash",
                      {"-c", "echo same >&" + std::to_string(same.writing_end())},
                      {{same.writing_end(), same.writing_end()}}});
  same.close_writing_end();
  EXPECT_EQ(all_of(same.reading_end()), "same\n");
  EXPECT_EQ(other.wait(), 0);
}

/// The numbers of the descriptors that a program finds open; 3 is that of the listing itself.
std::vector<std::string> descriptors_of_a_program() {
  return words_of(output_of({"/bin/ls", {"/proc/self/fd"}}));
}

class ChildDescriptors : public testing::Test {
 protected:
  ChildDescriptors() {  // those that this program has inherited itself
    for (int number = STDERR_FILENO + 1; number < 1024; ++number)
      if (::fcntl(number, F_GETFD) == 0) ::fcntl(number, F_SETFD, FD_CLOEXEC);
  }
  const std::vector<std::string> none_else_{"0", "1", "2", "3"};
};

TEST_F(ChildDescriptors, AreNoneOfThisProcess) {
  const Pipe open_here;
  EXPECT_EQ(descriptors_of_a_program(), none_else_);
}

TEST_F(ChildDescriptors, AreNoneOfThoseThatOtherThreadsStart) {
  std::array<int, 4> wrong{};
  {
    std::vector<std::jthread> threads;
    for (int& count : wrong)
      threads.emplace_back([&] {
        for (int i = 0; i < 60; ++i) count += descriptors_of_a_program() != none_else_;
      });
  }
  EXPECT_EQ(wrong, (std::array<int, 4>{}));
}

TEST(ChildProcess, IsStartedWhereStandardDescriptorsAreClosed) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const int out = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 10);
        for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(standard);
        const std::string listed = output_of(shell("readlink /proc/$$/fd/0; readlink /proc/$$/fd/2"));
        const int missing = ChildProcess(shell("exec /no/such/program")).wait();
        const std::string text = listed + std::to_string(missing) + "\n";
        [[maybe_unused]] const auto written = ::write(out, text.data(), text.size());
        std::_Exit(0);
      },
      testing::ExitedWithCode(0), "^/dev/null\n/dev/null\n127\n$");
}

}  // namespace
}  // namespace creepcontact::platform
