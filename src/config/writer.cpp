#include "creepcontact/config/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tables.hpp"

namespace creepcontact::config {
namespace {

/// Values before the tables below them, as TOML wants it.
struct Section {
  std::string values, tables;
  std::string text() const { return values + tables; }
};

class TomlWriter final : public Visitor {
 public:
  TomlWriter(std::filesystem::path directory, const Comments& comments)
      : directory_(std::move(directory)), comments_(comments) {}

  void key(const Key& key, Walk value) override {
    const std::string outer_key = std::exchange(key_, join_key(key_, key.name));
    const std::string outer_path = std::exchange(path_, join_key(path_, toml_key(key.name)));
    const Form form = key.info != nullptr ? key.info->form : Form::table;
    const bool is_several = form == Form::tables || form == Form::named;  // none: nothing is written
    if (key.is_meaningful && (is_several || has_comments() || !key.is_default())) {
      if (is_several)
        value(*this);
      else if (form == Form::value)
        write_value(key.name, value);
      else
        write_table('[' + path_ + ']', value);
    }
    key_ = outer_key;
    path_ = outer_path;
  }

  void element(std::size_t index, Walk value) override {
    const std::string outer = std::exchange(key_, fmt::format("{}[{}]", key_, index));
    write_table("[[" + path_ + "]]", value);
    key_ = outer;
  }

  // Values are written by InlineText.
  void leaf(Call<std::string> /*toml*/) override {}
  void function(const Function& /*value*/, const std::vector<std::string>& /*variables*/) override {}
  void path(const std::filesystem::path& /*file*/) override {}

  std::string heading() const { return comment_above(); }
  std::string text() const { return section_.text(); }

 private:
  /// Returns true if the key that is visited, or one below it, has a comment.
  bool has_comments() const {
    for (const auto* all : {&comments_.beside, &comments_.above})
      for (auto next = all->lower_bound(key_); next != all->end() && next->first.starts_with(key_); ++next)
        if (const char end = next->first[key_.size()]; end == '\0' || end == '.' || end == '[') return true;
    return false;
  }

  std::string comment_above() const {
    const auto found = comments_.above.find(key_);
    std::string text;
    for (std::size_t begin = 0; found != comments_.above.end() && begin < found->second.size();) {
      const std::size_t end = std::min(found->second.find('\n', begin), found->second.size());
      text += fmt::format("# {}\n", found->second.substr(begin, end - begin));
      begin = end + 1;
    }
    return text;
  }

  std::string line(const std::string& text) const {
    const auto found = comments_.beside.find(key_);
    return found == comments_.beside.end() ? text + '\n' : fmt::format("{:<28} # {}\n", text, found->second);
  }

  void write_value(const std::string& name, Walk value) {
    InlineText text(directory_);
    value(text);
    section_.values += comment_above() + line(fmt::format("{} = {}", toml_key(name), text.text));
  }

  void write_table(const std::string& heading, Walk keys) {
    Section outer = std::exchange(section_, {});
    const std::string head = '\n' + comment_above() + line(heading);
    keys(*this);
    outer.tables += head + section_.text();
    section_ = std::move(outer);
  }

  std::filesystem::path directory_;
  const Comments& comments_;
  std::string key_, path_;  // of what is visited: full, and as headings have it
  Section section_;         // of the table that is open
};

}  // namespace

std::string to_toml(const Config& config, const Vocabulary& vocabulary, const Comments& comments) {
  TomlWriter writer(config.file.parent_path(), comments);
  config_table(vocabulary).visit(config, writer);
  return writer.heading() + writer.text();
}

}  // namespace creepcontact::config
