#include "msh_reader.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "creepcontact/base/error.hpp"
#include "msh_input.hpp"
#include "msh_sections.hpp"

namespace creepcontact::io {
namespace {

constexpr const char* conversion =
    "2.2 and 4.1 are read. Convert the file with Gmsh: gmsh OLD.msh -save -format msh41 -o NEW.msh";

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

enum class Version { v22, v41 };

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : input_(bytes, name), name_(name) {}

  MshContent read() {
    input_.take("\xEF\xBB\xBF");  // the mark of UTF-8 that some editors put first
    input_.skip_blanks();
    while (input_.take("$Comments")) {
      skip_section("Comments");
      input_.skip_blanks();
    }
    if (!input_.take("$MeshFormat")) refuse_beginning();
    read_format();
    for (input_.skip_blanks(); !input_.at_end(); input_.skip_blanks()) read_section();
    for (const char* needed : {"Nodes", "Elements"}) {
      if (read_.count(needed) == 0)
        throw ModelError(fmt::format("{}: has no section ${}; it is incomplete or not a mesh: write it again with Gmsh",
                                     name_, needed));
    }
    return std::move(content_);
  }

 private:
  [[noreturn]] void refuse_beginning() {
    for (const char* section : {"$NOD", "$NOE", "$PARA", "$ELM"}) {
      if (input_.take(section))
        throw ModelError(fmt::format("{}: is in Gmsh's format 1.0; formats {}", name_, conversion));
    }
    throw ModelError(fmt::format(
        "{}: does not begin with $MeshFormat, so it is not a Gmsh mesh; if it is a geometry, rename it to NAME.geo; if "
        "it is a mesh of another program, convert it with Gmsh: gmsh FILE -save -format msh41 -o NEW.msh",
        name_));
  }

  void read_format() {
    input_.enter("MeshFormat");
    input_.line();
    std::istringstream words{std::string(input_.line())};
    std::string version;
    int type = -1, width = -1;
    words >> version >> type >> width;
    if (!words || (type != 0 && type != 1))
      input_.fail("expected the version, 0 (ASCII) or 1 (binary), and 8; the file is damaged: write it again");
    if (version != "2.2" && version != "4.1")
      throw ModelError(fmt::format("{}: is in Gmsh's format {}; formats {}", name_, version.substr(0, 10), conversion));
    if (width != 8) input_.fail("numbers of {} bytes; only those of 8 bytes are read: write the file again", width);
    version_ = version == "2.2" ? Version::v22 : Version::v41;
    if (type == 1) input_.begin_binary();
    end_section("MeshFormat");
  }

  void read_section() {
    input_.enter("");
    if (!input_.take("$"))
      input_.fail("expected the beginning of a section ($...); the file is damaged: write it again");
    const std::string_view line = input_.line();
    const std::string section(line.substr(0, line.find_first_of(" \t")));
    if (section.empty() || section.size() > 40 || !std::all_of(section.begin(), section.end(), is_word))
      input_.fail("the name of a section is damaged; write the file again");
    input_.enter(section);
    if (!read_known(section)) {
      skip_section(section);
      return;
    }
    if (!read_.insert(section == "ParametricNodes" ? "Nodes" : section).second)
      input_.fail("the section appears twice, so the file contains several meshes: write each to its own file");
    input_.use_binary(true);
    end_section(section);
  }

  bool read_known(const std::string& section) {
    const bool is_22 = version_ == Version::v22;
    if (section == "PhysicalNames")
      read_names();
    else if (section == "Nodes")
      is_22 ? read_nodes_22(input_, content_, false) : read_nodes_41(input_, content_);
    else if (section == "ParametricNodes" && is_22)
      read_nodes_22(input_, content_, true);
    else if (section == "Elements")
      is_22 ? read_elements_22(input_, content_) : read_elements_41(input_, content_);
    else if ((section == "Entities" || section == "PartitionedEntities") && !is_22)
      read_entities_41(input_, content_, section == "PartitionedEntities");
    else
      return false;
    return true;
  }

  void read_names() {
    input_.use_binary(false);
    const int count = input_.non_negative("the number of names");
    for (int i = 0; i < count; ++i) {
      const int dimension = input_.integer("the dimension of a physical group");
      const int tag = read_physical_tag(input_);
      const std::string_view quoted = input_.line();
      const std::size_t begin = quoted.find('"'), end = quoted.rfind('"');
      if (begin == end) input_.fail("expected a name in quotation marks; the file is damaged: write it again");
      if (end > begin + 1)
        content_.physical_names.emplace(MshContent::Key{dimension, tag}, quoted.substr(begin + 1, end - begin - 1));
    }
  }

  void skip_section(const std::string& section) {
    if (!input_.skip_behind("$End" + section))
      input_.fail("the section has no end ($End{}); the file is incomplete: write or copy it again", section);
    input_.line();
  }

  void end_section(const std::string& section) {
    input_.skip_blanks();
    if (!input_.take("$End" + section))
      input_.fail(
          "expected $End{}: the section contains more or less than it announces; the file is damaged: write it again",
          section);
    input_.line();
  }

  MshInput input_;
  std::string name_;
  Version version_{};
  std::set<std::string> read_;
  MshContent content_;
};

}  // namespace

MshContent read_msh_content(std::string_view bytes, const std::string& name) {
  return Reader(bytes, name).read();
}

mesh::Mesh read_msh(std::string_view bytes, const std::string& name, const mesh::Section& section) {
  return import_msh(read_msh_content(bytes, name), name, section);
}

}  // namespace creepcontact::io
