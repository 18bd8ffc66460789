#include "creepcontact/io/msh/msh_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "creepcontact/base/error.hpp"

namespace creepcontact::io {
namespace {

struct TagRange {
  std::uint64_t least = 0, largest = 0;
  bool empty = true;
  void add(const std::vector<std::uint64_t>& tags) {
    for (std::uint64_t tag : tags) {
      least = empty ? tag : std::min(least, tag);
      largest = empty ? tag : std::max(largest, tag);
      empty = false;
    }
  }
};

class Writer {
 public:
  std::string write(const MshContent& content) {
    constexpr std::size_t of_node = 32, of_number = 8, of_names = 1 << 16;
    std::size_t size = of_names + of_node * content.nodes.size();
    for (const auto& elements : content.elements) size += of_number * (elements.tags.size() + elements.nodes.size());
    text_.reserve(size);
    text_ = "$MeshFormat\n4.1 1 8\n";
    add<std::int32_t>(1);
    text_ += "\n$EndMeshFormat\n";
    add_names(content);
    add_entities(content);
    add_nodes(content);
    add_elements(content);
    return std::move(text_);
  }

 private:
  template <typename T>
  void add(T value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void add_size(std::size_t value) { add(static_cast<std::uint64_t>(value)); }
  void add_range(const TagRange& range) {
    add(range.least);
    add(range.largest);
  }

  void add_names(const MshContent& content) {
    if (content.physical_names.empty()) return;
    text_ += fmt::format("$PhysicalNames\n{}\n", content.physical_names.size());
    for (const auto& [key, name] : content.physical_names) {
      if (name.find_first_of("\"\r\n") != std::string::npos)
        throw ModelError(fmt::format(
            "the name of physical group {} contains a quotation mark or a line end; choose a name without them",
            key.tag));
      text_ += fmt::format("{} {} \"{}\"\n", key.dimension, key.tag, name);
    }
    text_ += "$EndPhysicalNames\n";
  }

  void add_entities(const MshContent& content) {
    std::map<MshContent::Key, std::vector<int>> entities = content.physicals;
    for (const auto& elements : content.elements) entities.try_emplace(elements.entity);
    std::array<std::size_t, 4> counts{};
    for (const auto& [entity, physicals] : entities) ++counts.at(entity.dimension);
    text_ += "$Entities\n";
    for (std::size_t count : counts) add_size(count);
    for (const auto& [entity, physicals] : entities) {
      add(std::int32_t{entity.tag});
      for (int k = 0; k < (entity.dimension == 0 ? 3 : 6); ++k) add(0.0);
      add_size(physicals.size());
      for (int physical : physicals) add(std::int32_t{physical});
      if (entity.dimension > 0) add_size(0);  // bounding entities
    }
    text_ += "\n$EndEntities\n";
  }

  void add_nodes(const MshContent& content) {
    TagRange range;
    range.add(content.node_tags);
    const MshContent::Key owner = content.elements.empty() ? MshContent::Key{} : content.elements.front().entity;
    text_ += "$Nodes\n";
    add_size(1);
    add_size(content.nodes.size());
    add_range(range);
    add(std::int32_t{owner.dimension});
    add(std::int32_t{owner.tag});
    add(std::int32_t{0});
    add_size(content.nodes.size());
    for (std::uint64_t tag : content.node_tags) add(tag);
    for (const Vector3& node : content.nodes) {
      for (double x : node) add(x);
    }
    text_ += "\n$EndNodes\n";
  }

  void add_elements(const MshContent& content) {
    TagRange range;
    std::size_t n_elements = 0;
    for (const auto& elements : content.elements) {
      range.add(elements.tags);
      n_elements += elements.tags.size();
    }
    text_ += "$Elements\n";
    add_size(content.elements.size());
    add_size(n_elements);
    add_range(range);
    for (const auto& elements : content.elements) {
      add(std::int32_t{elements.entity.dimension});
      add(std::int32_t{elements.entity.tag});
      add(std::int32_t{elements.type});
      add_size(elements.tags.size());
      const std::size_t n = elements.tags.empty() ? 0 : elements.nodes.size() / elements.tags.size();
      for (std::size_t i = 0; i < elements.tags.size(); ++i) {
        add(elements.tags[i]);
        for (std::size_t k = 0; k < n; ++k) add(elements.nodes[i * n + k]);
      }
    }
    text_ += "\n$EndElements\n";
  }

  std::string text_;
};

}  // namespace

std::string write_msh(const MshContent& content) {
  return Writer().write(content);
}

}  // namespace creepcontact::io
