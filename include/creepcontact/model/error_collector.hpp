#pragma once
/// Collects the errors of all entries of a configuration, so that the user sees them together.

#include <functional>
#include <string>
#include <vector>

#include "creepcontact/config/location.hpp"

namespace creepcontact::model {

/// One line per error. Not thread-safe.
class ErrorCollector {
 public:
  /// Runs `work`; a ModelError becomes one line that begins with the location `where`. Other exceptions pass through.
  void collect(const config::Location& where, const std::function<void()>& work);
  /// @throws ModelError with all lines, if there are any
  void raise() const;
  bool empty() const { return lines_.empty(); }

 private:
  std::vector<std::string> lines_;
};

}  // namespace creepcontact::model
