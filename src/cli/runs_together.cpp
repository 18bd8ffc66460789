#include "runs_together.hpp"

#include <fstream>
#include <mutex>
#include <new>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/base/stop_request.hpp"
#include "creepcontact/base/thread_count.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/platform/memory.hpp"
#include "creepcontact/run/run.hpp"
#include "creepcontact/run/vocabulary.hpp"

namespace creepcontact::cli {
namespace {

/// The log of a run as its own process would print it: warnings and errors.
std::shared_ptr<const log::Sink> sink_of(const std::shared_ptr<std::ofstream>& file) {
  const auto mutex = std::make_shared<std::mutex>();
  return std::make_shared<const log::Sink>([file, mutex](log::Level level, std::string_view message) {
    if (level < log::Level::warning) return;
    const std::scoped_lock lock(*mutex);
    *file << (level == log::Level::warning ? "warning: " : "error: ") << message << '\n' << std::flush;
  });
}

/// @returns the exit status
int run_one(const study::RunCall& call, run::Kept& kept) {
  const auto file = std::make_shared<std::ofstream>(call.log);
  const log::Redirection to_file(sink_of(file));
  try {
    config::Config config = config::read(call.base, run::vocabulary(), call.overrides);
    config.mesh.trust_geometry = call.trust_geometry;
    const run::Summary summary =
        run::run(config, {.output = call.output.string(), .kept = &kept, .resume = call.resume});
    if (summary.exit_status != 0) log::error("{}", summary.message);
    return summary.exit_status;
  } catch (const Error& error) {
    log::error("{}", error.what());
    return error.exit_status();
  } catch (const Cancelled&) {
    return platform::interrupted_status;
  } catch (const std::bad_alloc&) {
    log::error("{}", platform::out_of_memory);
    return SolverError::status;
  }
}

}  // namespace

study::RunsTogether runs_together(int threads) {
  const auto kept = std::make_shared<run::Kept>();
  return [kept, threads](const std::vector<study::RunCall>& calls, std::size_t at_once,
                         const std::function<void(std::size_t, int)>& ended) {
    const ThreadCount working(threads);
    const platform::Interrupt interrupt;
    std::mutex telling;
    std::vector<std::function<void()>> jobs;
    jobs.reserve(calls.size());
    for (std::size_t i = 0; i < calls.size(); ++i)
      jobs.emplace_back([&, i] {
        if (interrupt.requested()) return;
        const int status = run_one(calls[i], *kept);
        const std::scoped_lock lock(telling);
        ended(i, status);
      });
    kept->passes.run(jobs, at_once);
  };
}

}  // namespace creepcontact::cli
