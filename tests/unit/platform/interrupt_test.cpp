#include "creepcontact/platform/interrupt.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace creepcontact::platform {
namespace {

using testing::ExitedWithCode;

class Signals : public testing::Test {
 protected:
  Signals() { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

TEST_F(Signals, EndTheProcessWhileNothingIsToBeSaved) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    EXPECT_EXIT(
        {
          end_at_signals();
          std::raise(signal);
          std::_Exit(0);
        },
        ExitedWithCode(130), "^error: interrupted \\(SIG[A-Z]+\\): ended before there were results to save\n$");
}

TEST_F(Signals, AreARequestWhileSomethingIs) {
  EXPECT_EXIT(
      {
        end_at_signals();
        {
          const Interrupt outer;
          const Interrupt inner;
          if (inner.requested()) std::_Exit(1);
          std::raise(SIGINT);
          std::raise(SIGTERM);  // another one: the study that dies after it has passed a Ctrl-C on
          if (!inner.requested() || !outer.requested()) std::_Exit(2);
        }
        const Interrupt next;
        std::_Exit(next.requested() ? 3 : 0);
      },
      ExitedWithCode(0), "^$");
}

TEST_F(Signals, ASecondOneEndsTheProcessAtOnce) {
  EXPECT_EXIT(
      {
        end_at_signals();
        const Interrupt interrupt;
        std::raise(SIGINT);
        std::raise(SIGINT);
        std::_Exit(0);
      },
      ExitedWithCode(130), "SIGINT.* second");
}

TEST_F(Signals, WaitForAFileThatIsBeingPutIntoItsPlace) {
  EXPECT_EXIT(
      {
        end_at_signals();
        {
          const DelayedSignals outer;
          const DelayedSignals delayed;
          std::raise(SIGTERM);
          [[maybe_unused]] const auto written = ::write(STDERR_FILENO, "written\n", 8);
        }
        std::_Exit(0);
      },
      ExitedWithCode(130), "^written\nerror: interrupted \\(SIGTERM\\)");
}

TEST_F(Signals, ThatComeBeforeTheHandlersAreNotLost) {
  EXPECT_EXIT(
      {
        {
          const BlockedSignals blocked;
          std::raise(SIGINT);
          end_at_signals();  // as the program that is started meanwhile does
        }
        std::_Exit(0);
      },
      ExitedWithCode(130), "error: interrupted");
}

TEST_F(Signals, AreIgnoredAfterNohup) {
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        end_at_signals();
        const Interrupt interrupt;
        std::raise(SIGHUP);
        std::_Exit(interrupt.requested() ? 1 : 0);
      },
      ExitedWithCode(0), "^$");
}

TEST_F(Signals, EndAChildAsTheyEndAnyProcess) {
  EXPECT_EXIT(
      {
        end_at_signals();
        const Interrupt interrupt;
        const pid_t child = ::fork();
        if (child == 0) {
          std::raise(SIGTERM);
          std::_Exit(0);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        std::_Exit(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM && !interrupt.requested() ? 0 : 1);
      },
      ExitedWithCode(0), "^$");
}

}  // namespace
}  // namespace creepcontact::platform
