#pragma once
/// The parameters of cards that are read, and what becomes of each. One that is not in the table may change the
/// results.

#include <map>
#include <string>
#include <vector>

namespace creepcontact::deck {

struct Parameter {
  enum class Use {
    taken,       ///< it is in the model
    ignored,     ///< of the procedure, the output or the names: it changes no result
    left_out,    ///< with a consequence
    impossible,  ///< with a reason
  };
  std::string name;  ///< as it is usually written: "TIME DELAY"
  Use use{};
  std::vector<std::string> values = {};  ///< those that `use` is for; others are impossible. Empty: any
  std::string text = {};                 ///< consequence or reason
};

/// Those of a card by their names without blanks; nullptr if the card has no list.
const std::map<std::string, Parameter>* parameters_of(const std::string& card);

/// Names and values without blanks, in upper case.
std::string letters_of(const std::string& text);

}  // namespace creepcontact::deck
