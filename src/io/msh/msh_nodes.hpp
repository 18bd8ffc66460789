#pragma once
/// The nodes of a .msh file by their tags.

#include <cstdint>
#include <string>
#include <vector>

#include "creepcontact/io/msh/msh_content.hpp"

namespace creepcontact::io {

/// Numbers nodes by ascending tag, first all of them, then those that cells use.
class MshNodes {
 public:
  /// @param content  outlives this
  /// @throws ModelError if a node has two places
  MshNodes(const MshContent& content, const std::string& file);

  /// The number of a node, which is used from here on. @throws ModelError if there is no such node
  std::int64_t use(std::uint64_t tag, std::uint64_t element);

  /// Gives a mesh the used nodes, without the others; numbers in its blocks follow.
  void give_used(mesh::Mesh& mesh) const;

 private:
  const MshContent& content_;
  const std::string& file_;
  std::vector<std::uint64_t> tags_;    // ascending
  std::vector<std::size_t> position_;  // in the content
  std::vector<bool> used_;
};

}  // namespace creepcontact::io
