#include "summary_file.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/linalg/blas_library.hpp"
#include "creepcontact/platform/memory.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "model_record.hpp"
#include "model_view.hpp"
#include "warning_order.hpp"

namespace creepcontact::run {
namespace {

io::Summary::WallSeconds wall_seconds(const Stopwatch& watch) {
  const PartSeconds parts = watch.seconds();
  return {std::accumulate(parts.begin(), parts.end(), 0.0), parts};
}

/// A file that is right is left as it is.
bool is_same(const io::RecordedReport& a, const io::RecordedReport& b) {
  const auto texts = [](const io::RecordedReport& of) {
    return std::tie(of.title, of.project, of.drawing, of.revision, of.author, of.checker, of.logo, of.logo_file,
                    of.purpose, of.assumptions, of.assessment, of.appendix);
  };
  const auto keys = [](const io::RecordedPicture& of) {
    return std::tie(of.field, of.time, of.section, of.view, of.range);
  };
  return texts(a) == texts(b) &&
         std::ranges::equal(a.pictures, b.pictures, [&](const auto& x, const auto& y) { return keys(x) == keys(y); });
}

}  // namespace

void renew_report(const std::filesystem::path& directory, const config::Config& config) {
  const std::filesystem::path file = directory / "model.json";
  if (!path_exists(file)) return;
  try {
    io::ModelRecord record = io::read_model_record(file);
    io::RecordedReport now = recorded_report(config);
    if (is_same(record.report, now)) return;
    record.report = std::move(now);
    io::write_model_record(file, record);
  } catch (const ConfigError& error) {
    log::warning("the report keeps its former texts: {}", error.what());
  }
}

SummaryFile::SummaryFile(const RunContext& context, const ObserverList& observers,
                         std::vector<std::string> earlier_warnings, const log::WarningRecord& warnings,
                         std::function<void(Summary&)> describe_loop)
    : context_(context),
      observers_(observers),
      earlier_warnings_(std::move(earlier_warnings)),
      warnings_(warnings),
      describe_loop_(std::move(describe_loop)),
      has_model_record_(context.resumed != nullptr && path_exists(context.directory / "model.json")) {
  together(context.team(), [&] {
    if (has_model_record_ && context.observed.is_root()) renew_report(context.directory, context.config);
  });
}

void SummaryFile::output(StepView& /*view*/) {
  if (context_.directory.empty()) return;
  together(context_.team(), [&] {
    if (std::exchange(has_model_record_, true) || !context_.observed.is_root()) return;
    io::write_model_record(context_.directory / "model.json",
                           model_record(context_.config, context_.model, make(Status::completed, "").results));
    if (const std::string job = model_picture_job(context_.config, context_.model); !job.empty())
      platform::replace_file(context_.directory / "model_view.json", job, platform::Durable::when_synced);
  });
  const Clock::time_point now = Clock::now();
  if (!context_.team().any(!last_ || now - *last_ >= std::chrono::seconds(1))) return;
  last_ = now;
  write(make(Status::interrupted, "killed after this time was reached"));
}

void SummaryFile::write(const Summary& summary) const {
  if (context_.directory.empty()) return;
  together(context_.team(), [&] {
    if (context_.observed.is_root()) io::write_summary(context_.directory / "summary.json", summary.results);
  });
}

Summary SummaryFile::make(Status status, const std::string& message) const {
  Summary summary;
  summary.directory = context_.directory.string();
  summary.is_resumed = context_.resumed != nullptr;
  io::Summary& results = summary.results;
  results.status = status;
  results.message = message;
  results.title = context_.config.title;
  results.units = context_.config.units;
  results.version = CREEPCONTACT_VERSION;
  const linalg::BlasLibrary blas = linalg::blas_library();
  results.libraries = {{"blas", blas.blas}, {"lapack", blas.lapack}};
  for (const config::Material& material : context_.config.materials)
    if (!material.sources.empty()) results.sources[material.name] = material.sources;
  results.integrator = context_.config.time.integrator;
  for (const mechanics::Body& body : context_.model.bodies())
    results.bodies[body.name()] = {body.constraints().n_free(),
                                   static_cast<std::int64_t>(body.discretization().n_elements()),
                                   static_cast<std::int64_t>(body.discretization().n_points()),
                                   {}};
  results.accuracy.tolerance = context_.config.time.tolerance;
  results.wall_seconds = wall_seconds(context_.watch);
  results.peak_memory_mb = platform::peak_memory() / (1 << 20);
  results.warnings = earlier_warnings_;
  for (const std::string& warning : warnings_.texts()) summary.add_warning(warning);
  describe_loop_(summary);
  observers_.finish(summary);  // observers warn, too
  results.warnings = by_consequence(std::move(results.warnings));
  return summary;
}

}  // namespace creepcontact::run
