#pragma once
/// Pieces of an HTML page. Functions that take text escape it; those that take HTML do not.

#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::report {

/// & < > " ' as entities. Bytes that are not UTF-8 are replaced.
std::string escaped(std::string_view text);

/// HTML under construction.
class Html {
 public:
  /// <tag attributes>text</tag>
  void element(std::string_view tag, std::string_view text, std::string_view attributes = "");
  /// HTML as it is.
  void raw(std::string_view html) { text_ += html; }
  void open(std::string_view tag, std::string_view attributes = "");
  void close(std::string_view tag);
  /// A table in a box that scrolls sideways on narrow screens; columns of numbers are aligned to the right.
  /// @param head  may be empty @param caption  may be empty
  void table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows,
             std::string_view caption = "");
  /// <figure><img></figure> with a number before its caption. @param alternative  what is to be seen, for those who
  /// cannot
  void figure(std::string_view url, std::string_view alternative, const std::string& caption);
  /// Captions of the figures, in the order of their numbers from 1. Their ids are "figure-1" and so on.
  const std::vector<std::string>& figures() const { return figures_; }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::vector<std::string> figures_;
};

}  // namespace creepcontact::report
