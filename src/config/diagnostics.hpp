#pragma once
/// Collects the mistakes of a configuration so that the user sees them all at once.

#include <string>
#include <vector>

#include "creepcontact/config/location.hpp"

namespace creepcontact::config {

class Diagnostics {
 public:
  /// "where: found; allowed: ..."
  void add(const Location& where, const std::string& found, const std::string& allowed = {});
  /// "where: found; did you mean 'x'? (allowed: ...)"
  /// @param name     what was written, to be compared with `names`
  /// @param allowed  not given: the names
  void add_unknown(const Location& where, const std::string& found, const std::string& name,
                   const std::vector<std::string>& names, const std::string& allowed = {});

  bool empty() const { return problems_.empty(); }
  /// @throws ConfigError with one line a problem, in the order of the file, if there is any
  void throw_if_any() const;

 private:
  struct Problem {
    Location where;
    std::string text;
  };
  std::vector<Problem> problems_;
};

}  // namespace creepcontact::config
