#include "creepcontact/base/team.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <string>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/stop_request.hpp"
#include "thread_team.hpp"

namespace creepcontact {
namespace {

TEST(Team, ReducesOverAllMembers) {
  for (const int n : {1, 2, 4}) {
    std::vector<std::vector<double>> results(n);
    on_team(n, [&](const Team& team) {
      const double own = 1.0 + team.rank();
      results[team.rank()] = {team.sum(own),
                              team.max(own),
                              team.min(own),
                              static_cast<double>(team.rank_of_max(-own)),
                              static_cast<double>(team.rank_of_max(7)),
                              team.any(team.rank() == n - 1) ? 1.0 : 0.0,
                              team.any(false) ? 1.0 : 0.0};
    });
    for (const std::vector<double>& result : results)
      EXPECT_EQ(result, (std::vector<double>{n * (n + 1) / 2.0, 1.0 * n, 1.0, 0.0, 0.0, 1.0, 0.0})) << n;
  }
}

TEST(Team, HandsValuesAround) {
  std::vector<std::vector<double>> results(3), gathered(3);
  on_team(3, [&](const Team& team) {
    results[team.rank()] = {1.0 * team.rank(), 2.0};
    team.broadcast(results[team.rank()], 2);
    gathered[team.rank()] = team.gather(std::vector<double>(team.rank(), team.rank()));
  });
  for (const std::vector<double>& result : results) EXPECT_EQ(result, (std::vector<double>{2, 2}));
  EXPECT_EQ(gathered[0], (std::vector<double>{1, 2, 2}));
  EXPECT_TRUE(gathered[1].empty() && gathered[2].empty());
}

TEST(Team, HandsAroundWhatOneMemberAloneKnowsTheSizeOf) {
  std::vector<std::vector<double>> values(3);
  std::vector<std::string> texts(3);
  on_team(3, [&](const Team& team) {
    values[team.rank()].assign(team.rank(), 7.0);
    texts[team.rank()] = std::string(2 - team.rank(), 'x');
    broadcast(team, values[team.rank()], 2);
    broadcast(team, texts[team.rank()], 0);
  });
  for (const std::vector<double>& of_member : values) EXPECT_EQ(of_member, (std::vector<double>{7, 7}));
  for (const std::string& of_member : texts) EXPECT_EQ(of_member, "xx");
}

/// What local work, by rank, makes every member throw.
std::string thrown(int n, const std::function<void(int rank)>& local) {
  std::vector<std::string> caught(n);
  on_team(n, [&](const Team& team) {
    std::string& own = caught[team.rank()];
    try {
      together(team, [&] { local(team.rank()); });
    } catch (const RecoverableError& error) {
      own = std::string("RecoverableError: ") + error.what();
    } catch (const ConfigError& error) {
      own = std::string("ConfigError: ") + error.what();
    } catch (const ModelError& error) {
      own = std::string("ModelError: ") + error.what();
    } catch (const SolverError& error) {
      own = std::string("SolverError: ") + error.what();
    } catch (const Error& error) {
      own = "Error " + std::to_string(error.exit_status()) + ": " + error.what();
    } catch (const std::bad_alloc&) {
      own = "bad_alloc";
    } catch (const Cancelled&) {
      own = "Cancelled";
    } catch (const std::exception& error) {
      own = std::string("exception: ") + error.what();
    }
    team.sum(1.0);  // all are still in step
  });
  for (const std::string& own : caught) EXPECT_EQ(own, caught.front());
  return caught.front();
}

TEST(Together, AFailureOfOneIsThrownByAll) {
  for (const int n : {1, 2, 4}) {
    for (int failing = 0; failing < n; ++failing) {
      const auto on_failing = [&](const auto& error) {
        return thrown(n, [&](int rank) {
          if (rank == failing) throw error;
        });
      };
      EXPECT_EQ(on_failing(RecoverableError("not converged")), "RecoverableError: not converged");
      EXPECT_EQ(on_failing(ConfigError("key")), "ConfigError: key");
      EXPECT_EQ(on_failing(ModelError("a mesh, \"named\"\n\u00e4")), "ModelError: a mesh, \"named\"\n\u00e4");
      EXPECT_EQ(on_failing(SolverError("")), "SolverError: ");
      EXPECT_EQ(on_failing(Error("disk", 5)), "Error 5: disk");
      EXPECT_EQ(on_failing(std::bad_alloc()), "bad_alloc");
      EXPECT_EQ(on_failing(Cancelled()), "Cancelled");
      EXPECT_EQ(on_failing(std::invalid_argument("n < 0")), "exception: n < 0");
    }
    EXPECT_EQ(thrown(n, [](int) {}), "");
  }
}

TEST(Together, AFatalFailureOutweighsOneThatMayBeRetried) {
  EXPECT_EQ(thrown(4,
                   [](int rank) {
                     if (rank < 2) throw RecoverableError("retry");
                     throw SolverError("rank " + std::to_string(rank));
                   }),
            "SolverError: rank 2");
}

TEST(Together, OfEqualFailuresThatOfTheLowestRankIsThrown) {
  EXPECT_EQ(thrown(3,
                   [](int rank) {
                     if (rank > 0) throw RecoverableError("rank " + std::to_string(rank));
                   }),
            "RecoverableError: rank 1");
}

}  // namespace
}  // namespace creepcontact
