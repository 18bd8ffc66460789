#include "creepcontact/model/error_collector.hpp"

#include "creepcontact/base/error.hpp"

namespace creepcontact::model {

void ErrorCollector::collect(const config::Location& where, const std::function<void()>& work) {
  try {
    work();
  } catch (const ModelError& error) {
    const std::string prefix = where.prefix();
    const std::string message = error.what();
    // Some messages already begin with a place.
    lines_.push_back(message.rfind(prefix, 0) == 0 ? message : prefix + message);
  }
}

void ErrorCollector::raise() const {
  if (empty()) return;
  std::string all;
  for (const std::string& line : lines_) all += (all.empty() ? "" : "\n") + line;
  throw ModelError(all);
}

}  // namespace creepcontact::model
