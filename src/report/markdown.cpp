#include "markdown.hpp"

#include <fmt/format.h>
#include <md4c.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "html.hpp"

namespace creepcontact::report {
namespace {

std::string address(const MD_ATTRIBUTE& attribute) {
  return {attribute.text, attribute.size};
}

bool may_be_linked(const std::string& target) {
  std::string lower = target.substr(0, 8);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower.starts_with("http://") || lower.starts_with("https://") || lower.starts_with("mailto:");
}

/// The page that grows while md4c reads the text.
struct MarkdownPage {
  std::string html;
  int heading = 3;
  std::vector<bool> links;  ///< of the spans <a> that are open: whether they are linked

  void block(MD_BLOCKTYPE type, const void* detail, bool begins) {
    const auto tag = [&](std::string_view name, std::string_view attributes = "") {
      html += begins ? fmt::format("<{}{}>", name, attributes) : fmt::format("</{}>\n", name);
    };
    switch (type) {
      case MD_BLOCK_QUOTE:
        return tag("blockquote");
      case MD_BLOCK_UL:
        return tag("ul");
      case MD_BLOCK_OL:
        return tag("ol", begins ? fmt::format(" start=\"{}\"", static_cast<const MD_BLOCK_OL_DETAIL*>(detail)->start)
                                : std::string());
      case MD_BLOCK_LI:
        return tag("li");
      case MD_BLOCK_HR:
        html += begins ? "<hr>\n" : "";
        return;
      case MD_BLOCK_H: {
        constexpr int deepest = 6;
        const int level = heading - 1 + static_cast<int>(static_cast<const MD_BLOCK_H_DETAIL*>(detail)->level);
        return tag(fmt::format("h{}", std::min(level, deepest)));
      }
      case MD_BLOCK_CODE:
        html += begins ? "<pre><code>" : "</code></pre>\n";
        return;
      case MD_BLOCK_P:
        return tag("p");
      case MD_BLOCK_TABLE:
        html += begins ? "<div class=\"table\" tabindex=\"0\" role=\"group\" aria-label=\"table\"><table>"
                       : "</table></div>\n";
        return;
      case MD_BLOCK_THEAD:
        return tag("thead");
      case MD_BLOCK_TBODY:
        return tag("tbody");
      case MD_BLOCK_TR:
        return tag("tr");
      case MD_BLOCK_TH:
      case MD_BLOCK_TD: {
        const bool right = static_cast<const MD_BLOCK_TD_DETAIL*>(detail)->align == MD_ALIGN_RIGHT;
        return tag(type == MD_BLOCK_TH ? "th" : "td", right ? " class=\"number\"" : "");
      }
      default:
        return;
    }
  }

  void span(MD_SPANTYPE type, const void* detail, bool begins) {
    const auto tag = [&](std::string_view name) { html += fmt::format("<{}{}>", begins ? "" : "/", name); };
    if (type == MD_SPAN_EM) tag("em");
    if (type == MD_SPAN_STRONG) tag("strong");
    if (type == MD_SPAN_CODE) tag("code");
    if (type != MD_SPAN_A) return;
    if (begins) {
      const std::string target = address(static_cast<const MD_SPAN_A_DETAIL*>(detail)->href);
      links.push_back(may_be_linked(target));
      if (links.back()) html += fmt::format("<a href=\"{}\" rel=\"noreferrer\">", escaped(target));
    } else if (!links.empty()) {
      if (links.back()) html += "</a>";
      links.pop_back();
    }
  }

  void text(MD_TEXTTYPE type, std::string_view characters) {
    if (type == MD_TEXT_BR)
      html += "<br>\n";
    else if (type == MD_TEXT_SOFTBR)
      html += '\n';
    else if (type == MD_TEXT_NULLCHAR)
      html += "\uFFFD";
    else if (type == MD_TEXT_ENTITY)
      html += characters;  // of letters, digits and '#' between '&' and ';': one character of text
    else
      html += escaped(characters);
  }
};

}  // namespace

std::string markdown(std::string_view text, int heading) {
  MarkdownPage page;
  page.heading = heading;
  MD_PARSER parser{};
  parser.flags = MD_FLAG_NOHTML | MD_FLAG_TABLES;
  parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* into) {
    static_cast<MarkdownPage*>(into)->block(type, detail, true);
    return 0;
  };
  parser.leave_block = [](MD_BLOCKTYPE type, void* detail, void* into) {
    static_cast<MarkdownPage*>(into)->block(type, detail, false);
    return 0;
  };
  parser.enter_span = [](MD_SPANTYPE type, void* detail, void* into) {
    static_cast<MarkdownPage*>(into)->span(type, detail, true);
    return 0;
  };
  parser.leave_span = [](MD_SPANTYPE type, void* detail, void* into) {
    static_cast<MarkdownPage*>(into)->span(type, detail, false);
    return 0;
  };
  parser.text = [](MD_TEXTTYPE type, const MD_CHAR* characters, MD_SIZE size, void* into) {
    static_cast<MarkdownPage*>(into)->text(type, {characters, size});
    return 0;
  };
  if (md_parse(text.data(), static_cast<MD_SIZE>(text.size()), &parser, &page) != 0)
    return fmt::format("<p>{}</p>\n", escaped(text));
  return page.html;
}

}  // namespace creepcontact::report
