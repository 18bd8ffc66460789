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
  /// "where: found; did you mean 'x'? (allowed: ...)", without the question if no name is near; or what known_words.hpp
  /// says of a word that is familiar from elsewhere.
  /// @param where    of a value: with its key. @param name  what was written, to be compared with `names`
  /// @param allowed  not given: the names
  void add_unknown(const Location& where, const std::string& found, const std::string& name,
                   const std::vector<std::string>& names, const std::string& allowed = {});

  /// Reports a key that its table does not have. @param where  with the key itself
  void add_unknown_key(const Location& where, const std::string& name, const std::vector<std::string>& names);

  bool empty() const { return problems_.empty(); }
  /// @throws ConfigError with one line per problem, in the order of the file, if there is any
  void throw_if_any() const;

 private:
  struct Problem {
    Location where;
    std::string text;
  };
  std::vector<Problem> problems_;
};

}  // namespace creepcontact::config
