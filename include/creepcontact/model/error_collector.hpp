#pragma once
/// Errors of all entries of a configuration, so that the user sees them in one go.

#include <functional>
#include <string>
#include <vector>

#include "creepcontact/config/location.hpp"

namespace creepcontact::model {

class ErrorCollector {
 public:
  /// Runs `work`; a ModelError becomes one line that begins with the place in the configuration.
  void collect(const config::Location& where, const std::function<void()>& work);
  /// @throws ModelError with all lines, if there is any
  void raise() const;
  bool empty() const { return lines_.empty(); }

 private:
  std::vector<std::string> lines_;
};

}  // namespace creepcontact::model
